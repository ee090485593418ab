#!/usr/bin/env python3
"""Elements that were halved before a radius are joined again behind it: fewer of them, and the same springback. A U-bend on 25 elements,
with halves that are joined and that stay, against 175 elements that are never halved.

    joined.py PROGRAM SCENE FOLDER
"""
import json
import re
import subprocess
import sys
from pathlib import Path


def run(program, scene, folder, *settings):
    """Measures of the wall after springback, largest number of elements, and how often it fell."""
    command = [program, scene, "--quiet", "--output", folder]
    for setting in settings:
        command += ["--set", setting]
    subprocess.run(command, check=True, stderr=subprocess.DEVNULL)
    changes = re.findall(r"mesh changed after increment \d+: (\d+) cells to (\d+)", (Path(folder) / "run.log").read_text(encoding="utf-8"))
    numbers = [(int(before), int(after)) for before, after in changes]
    fell = sum(after < before for before, after in numbers)
    most = max((n for change in numbers for n in change), default=0)
    return json.loads((Path(folder) / "summary.json").read_text(encoding="utf-8"))["measures"]["wall"], most, fell


def main():
    program, scene, folder = sys.argv[1:]
    fine, changed, _ = run(program, scene, folder + "/fine")
    joined, n_joined, fell = run(program, scene, folder + "/joined", "Blank/Elements=25")
    stays, n_stays, never = run(program, scene, folder + "/stays", "Blank/Elements=25", "Blank/Refinement/Join halves=false")
    for name, wall, elements in (("175", fine, changed), ("25, joined", joined, n_joined), ("25, halves stay", stays, n_stays)):
        print(name, wall, elements)
    errors = []
    if changed or never or fell < 2:
        errors.append(f"175 elements changed to {changed}; joined {fell} times, {never} times where halves stay")
    if n_joined > .9 * n_stays:
        errors.append(f"{n_joined} elements at most, {n_stays} if none are joined")
    # Joining costs less than what 25 elements are off (theta2 by .6 degree, rho by 2 %).
    for name, tolerance in (("theta1", .2), ("theta2", .2), ("rho", .01 * stays["rho"])):
        if abs(joined[name] - stays[name]) > tolerance:
            errors.append(f"{name}: {joined[name]}, {stays[name]} if none are joined")
    for name, tolerance in (("theta1", .3), ("theta2", .8), ("rho", .03 * fine["rho"])):
        if abs(joined[name] - fine[name]) > tolerance:
            errors.append(f"{name}: {joined[name]}, on 175 elements {fine[name]}")
    if errors:
        sys.exit("joined.py: " + "; ".join(errors))


if __name__ == "__main__":
    main()
