#!/usr/bin/env python3
"""delta = auto on a series of meshes: the error that contact adds against the error of the mesh.

    scripts/studies/automatic_delta.py [--program PROGRAM] [--write]

Force of the pressed plate at ten travels; contact error: `auto` against `active set` on the same mesh; discretisation error:
`active set` against 800 elements. Root mean squares over the largest force. The thickness that contact sees is the initial one,
so that the result does not depend on the path. Standard library only, half a minute.
"""
import math
import os
import subprocess
import tempfile

from measured import ROOT, MeasuredTable, arguments_of
from csv_file import rows_of

ENTRIES = ["Output/Pictures=0", "Output/Travels=1,2,3,4,5,6,7,8,9,10", "Steps/form/First increment=0.2",
           "Steps/form/Largest increment=0.2", "Blank/Transverse normal stress=false",
           "Tools/punch/Contact thickness=initial"]


def run(program, folder, elements, choice):
    """Forces at the travels, largest penetration at the nodes and between them."""
    command = [program, os.path.join(ROOT, "prm", "pressed_plate.prm"), "--quiet", "--output", folder]
    for entry in ENTRIES + [f"Blank/Elements={elements}", choice]:
        command += ["--set", entry]
    subprocess.run(command, check=True)
    rows = rows_of(os.path.join(folder, "history.csv"))
    forces = [float(row["punch_force_z"]) for row in rows
              if abs(float(row["time"]) - round(float(row["time"]))) < 1e-9]
    largest = {key: max(float(row[key]) for row in rows) for key in ("max_penetration", "max_penetration_between_nodes")}
    return forces, largest["max_penetration"], largest["max_penetration_between_nodes"]


def difference(a, b):
    return math.sqrt(sum((x - y) ** 2 for x, y in zip(a, b)) / len(a)) / max(b)


def main():
    options = arguments_of(__doc__, write="renew doc/measured/automatic_delta.csv").parse_args()
    program = options.program
    with tempfile.TemporaryDirectory() as folder:
        exact, automatic = "Contact/Enforcement=active set", "Contact/Allowed penetration=auto"
        finest = run(program, folder, 800, exact)[0]
        table = MeasuredTable(["elements", "max p", "penetration between nodes", "contact error", "discretisation error", "ratio"])
        for elements in (25, 50, 100, 200):
            reference = run(program, folder, elements, exact)[0]
            forces, deepest, between = run(program, folder, elements, automatic)
            contact, mesh = difference(forces, reference), difference(reference, finest)
            table.add(elements, f"{deepest:.2e}", f"{between:.2e}", f"{contact:.2e}", f"{mesh:.2e}", f"{contact / mesh:.3f}")
    print(table)
    if options.write:
        table.write("automatic_delta", "pressed plate, delta = auto: contact error against the error of the mesh")


if __name__ == "__main__":
    main()
