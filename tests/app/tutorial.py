#!/usr/bin/env python3
"""Runs the commands of doc/tutorial.md in their order and holds their results against what the page says.

    tests/app/tutorial.py PROGRAM PAGE WORK_FOLDER

A line of a block that opens with "$ " is a command; scripts/... commands of pictures and reports have tests of their own and
are left out. Standard library only.
"""
import csv
import os
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as xml


def main():
    program, page, work = (os.path.abspath(word) for word in sys.argv[1:4])
    shutil.rmtree(work, ignore_errors=True)
    os.makedirs(work)
    with open(page, encoding="utf-8") as file:
        text = file.read()
    commands = re.findall(r"^    \$ (.*)$", text, re.MULTILINE)
    path = os.path.dirname(program) + os.pathsep + os.environ["PATH"]
    said, count = "", 0
    for command in commands:
        if command.startswith("scripts/"):
            continue
        print("$", command, flush=True)
        run = subprocess.run(["bash", "-c", command], cwd=work, env={**os.environ, "PATH": path}, capture_output=True, text=True)
        said = said + run.stdout + run.stderr
        # A sweep in which runs tear says so by its status.
        expected = 2 if command.startswith("deltaform sweep") and "--print" not in command else 0
        check(run.returncode == expected, f"status {run.returncode} of: {command}\n{run.stdout}{run.stderr}")
        count += 1
    check(count >= 7, "the page has lost its commands")

    drawing = xml.parse(os.path.join(work, "cup.svg")).getroot()
    groups = {group.get("id"): group for group in drawing.iter("{http://www.w3.org/2000/svg}g")}
    check(set(groups) >= {"blank", "punch", "die", "holder"}, "blank and tools are drawn")
    check(len(list(groups["punch"])) == 2, "the punch is drawn at its start and at its end")

    # The forces between which the page says that the cup tears.
    whole, torn = (float(word.replace(" ", "")) for word in re.search(r"between (\d+) and (\d+) kN", text).groups())
    outcomes = {}
    for folder in ("forces", "closer"):
        for row in rows_of(os.path.join(work, folder, "sweep.csv")):
            outcomes[float(row["Tools/holder/Force"]) / 1e3] = (row["exit_status"], os.path.join(work, folder, row["folder"]))
    good = [force for force, (status, _) in outcomes.items() if status == "0"]
    bad = [force for force, (status, _) in outcomes.items() if status == "2"]
    check(max(good) == whole and min(bad) == torn, f"it tears between {max(good):g} and {min(bad):g} kN, not {whole:g} and {torn:g}")
    for force in bad:
        with open(os.path.join(outcomes[force][1], "run.log"), encoding="utf-8") as file:
            check("the sheet tears" in file.read(), f"{force} kN: the sheet tears")
    print(f"{count} commands; the cup tears between {whole:g} and {torn:g} kN")


def rows_of(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def check(condition, what):
    if not condition:
        sys.exit("wrong: " + what)


if __name__ == "__main__":
    main()
