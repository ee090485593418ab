#!/usr/bin/env python3
"""A wall is heated, and a second operation goes on with it that lets no heat out: it keeps what the first has left in it, to
round-off, and evens out.

    heat_operations.py PROGRAM SCENE FOLDER
"""
import os
import subprocess
import sys

from run_files import rows_of


def run(program, scene, folder, *entries):
    command = [program, scene, "--quiet", "--output", folder, "--set", "Steps/wait/First increment=0.5", "--set",
               "Steps/wait/Largest increment=0.5", "--set", "Steps/wait/End time=5"]
    for entry in entries:
        command += ["--set", entry]
    subprocess.run(command, check=True)
    return {name: float(value) for name, value in rows_of(os.path.join(folder, "history.csv"))[-1].items() if name != "stage"}


def main():
    program, scene, folder = sys.argv[1:]
    first = run(program, scene, os.path.join(folder, "first"))
    second = run(program, scene, os.path.join(folder, "second"), f"Start from={os.path.join(folder, 'first')}",
                 "Heat/inside/Film coefficient=0", "Heat/outside/Film coefficient=0")
    lost = second["heat_stored"] / first["heat_stored"] - 1.
    ranges = [row["max_temperature"] - row["min_temperature"] for row in (first, second)]
    print(f"stored {first['heat_stored']:.6g}, lost {lost:.1e}; temperatures differ by {ranges[0]:.4g}, then by {ranges[1]:.4g}")
    if not (first["heat_stored"] > 1e4 and abs(lost) < 1e-12 and ranges[1] < .5 * ranges[0]):
        sys.exit("heat_operations.py: the second operation does not go on with the heat of the first")


if __name__ == "__main__":
    main()
