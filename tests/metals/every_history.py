#!/usr/bin/env python3
"""Restart, refinement and several processes with every history that a metal can have.

    every_history.py PROGRAM FOLDER --blank solid|shell [--launcher MPIRUN] [--seed N] [--list]

Metals are drawn from all laws that the program lists until each has had its turn (laws.py). Each is formed and formed back
in few increments: killed and resumed, the run leaves the bytes of a run that was left alone; the reactions of all supports
and all tables of two processes are those of one to 1e-8 (solids, cells of which are refined on the way); works and energies
agree, and nothing is warned of.
"""
import argparse
import json
import pathlib
import random
import shutil
import subprocess
import sys
import os

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent / "scenes"), str(HERE.parent / "distributed")]

from laws import Deal, Laws
from resume import compare, interrupt
from same_history import difference, history

SCENES = {"solid": "block.prm", "shell": "strip.prm"}


def alone(command, folder):
    """What is wrong with a run that nothing disturbs, and how long it took."""
    status = subprocess.run([*command, "--output", str(folder)], stderr=subprocess.PIPE, text=True)
    if status.returncode != 0:
        return f"exit status {status.returncode}: {status.stderr.strip()}"
    summary = json.loads((folder / "summary.json").read_text())
    # Twelve cells are coarse on purpose.
    if warnings := [warning for warning in summary["warnings"] if not warning.startswith("coarse mesh")]:
        return f"warnings {warnings}"
    rows = history(folder)
    if "cells" in rows[0] and int(rows[-1]["cells"]) <= int(rows[0]["cells"]):
        return "no cell was refined"
    if not float(rows[-1]["plastic_energy"]) > 5. * abs(float(rows[-1]["elastic_energy"])):
        return "hardly anything has flowed"
    return ""


def resumed(command, folder, expected, chance):
    for _ in range(5):
        shutil.rmtree(folder, ignore_errors=True)
        status, hits = interrupt([*command, "--output", str(folder)], folder, .1, 1, chance)
        different = compare(expected, folder)
        if status != 0 or different:
            return f"resumed: exit status {status}, different: {', '.join(different) or 'nothing'}"
        if hits:
            return ""
    return "no kill left anything to resume"


def of_two_processes(command, folder, expected, launcher):
    command = [launcher, "-np", "2", "--oversubscribe", *command, "--output", str(folder)]
    status = subprocess.run(command, stderr=subprocess.PIPE, text=True)
    if status.returncode != 0:
        return f"two processes: exit status {status.returncode}: {status.stderr.strip()}"
    # A last digit decides now and then whether an iteration more is needed; the error of heat is round-off.
    found = difference(history(expected), history(folder), 1e-8, ("newton_iterations", "heat_error"))
    return f"two processes: {found}" if found else ""


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--blank", choices=SCENES, required=True)
    parser.add_argument("--launcher")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--list", action="store_true", help="only say which metals are drawn")
    arguments = parser.parse_args()

    chance = random.Random(arguments.seed)
    # Solids are dealt first whichever blank is asked for, so that both together have all laws.
    deal = Deal(Laws(arguments.program), chance)
    metals = {blank: list(deal.metals(blank)) for blank in SCENES}[arguments.blank]
    shutil.rmtree(arguments.folder, ignore_errors=True)
    os.environ.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    failures = 0
    for number, (name, entries) in enumerate(metals):
        if arguments.list:
            print(name)
            continue
        work = arguments.folder / str(number)
        work.mkdir(parents=True)
        command = [arguments.program, str(HERE / SCENES[arguments.blank]), "--quiet"]
        for entry in entries:
            command += ["--set", entry]
        wrong = (alone(command, work / "alone") or
                  resumed(command, work / "killed", work / "alone", chance))
        if not wrong and arguments.launcher:
            wrong = of_two_processes(command, work / "two", work / "alone", arguments.launcher)
        failures += bool(wrong)
        print(f"{name}: {wrong or 'good'}")
        if wrong:
            print(" ".join(f'"{word}"' if " " in word else word for word in command))
    print(f"{len(metals)} metals, {failures} failed")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
