#!/usr/bin/env python3
"""Orders of conduction in the increment and in the element, against closed forms.

    heat_order.py PROGRAM TREE FOLDER

Increment: the surface of a hot block on a cold tool (prm/quenched_block.prm) at t = .1 on a fine mesh, order 1; the tool keeps
its temperature, or is a half-space. Element: the inner
wall of a cylinder between two baths (tests/scenes/heat_cylinder_wall.prm), which is steady, orders 2 and 4 (at nodes) of degree 1
and 2.
"""
import math
import os
import subprocess
import sys

from run_files import rows_of


def last(program, scene, folder, column, sets):
    command = [program, scene, "--quiet", "--output", folder]
    for entry in sets:
        command += ["--set", entry]
    subprocess.run(command, check=True)
    return float(rows_of(os.path.join(folder, "history.csv"))[-1][column])


def judge(what, errors, order):
    """Halves of steps: is the last observed order as large as it should be?"""
    observed = [math.log2(a / b) for a, b in zip(errors, errors[1:])]
    print(f"{what}: errors", " ".join(f"{e:.3e}" for e in errors), "orders", " ".join(f"{o:.2f}" for o in observed))
    return abs(observed[-1] - order) <= .15


def main():
    program, tree, folder = sys.argv[1:]
    block = os.path.join(tree, "prm", "quenched_block.prm")
    good = True
    for what, share, body in (("tool", 0., []), ("half-space", 1. / 3., ["Tools/tool/Heat/Body=half space",
                                                                         f"Tools/tool/Heat/Effusivity={3. * math.sqrt(160.)!r}"])):
        x = 10. * math.sqrt(.1 / 160.) * (1. + share)
        surface = 1000. - 980. / (1. + share) * (1. - math.exp(x * x) * math.erfc(x))
        errors = []
        for step in (.01, .005, .0025):
            sets = ["Blank/Elements through thickness=160", "Steps/cool/End time=.1", f"Steps/cool/First increment={step}",
                    f"Steps/cool/Largest increment={step}", "Output/Pictures=0", *body]
            errors.append(abs(last(program, block, os.path.join(folder, f"{what}_{step}"), "min_temperature", sets) - surface))
        good = judge("increment, " + what, errors, 1) and good

    r_i, r_o, k, h_i, h_o, t_i, t_o = 10., 20., 40., 2., 1., 900., 100.
    flux = (t_i - t_o) / (1 / (h_i * 2 * math.pi * r_i) + math.log(r_o / r_i) / (2 * math.pi * k) + 1 / (h_o * 2 * math.pi * r_o))
    wall = t_i - flux / (h_i * 2 * math.pi * r_i)
    for degree, order in ((1, 2), (2, 4)):
        scene = os.path.join(tree, "tests", "scenes", "heat_cylinder_wall.prm")
        errors = []
        for n in (2, 4, 8):
            sets = [f"Blank/Degree={degree}", f"Blank/Elements={n}"]
            errors.append(abs(last(program, scene, os.path.join(folder, f"wall_{degree}_{n}"), "max_temperature", sets) - wall))
        good = judge(f"degree {degree}", errors, order) and good
    if not good:
        sys.exit("heat_order.py: an order is not what it should be")


if __name__ == "__main__":
    main()
