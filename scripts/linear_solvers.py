#!/usr/bin/env python3
"""Measures the linear solvers on the Hertzian block of tests/distributed and writes tables in Markdown to standard output.

    linear_solvers.py PROGRAM iterations            iterations per solve against epsilon and delta, rule by rule
    linear_solvers.py PROGRAM cost --cells 70,223   time of a solve against the number of unknowns, with fitted exponents
    linear_solvers.py PROGRAM speed --cells 316     1 and 2 processes
"""
import argparse
import csv
import json
import math
import os
import subprocess
import tempfile

SCENE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "tests", "distributed", "hertz_block.prm")
RULES = ["adaptive", "constant", "paper", "element stiffness", "proportional", "gap driven"]
ENVIRONMENT = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")


def run(program, cells, solver, sets=(), processes=0, timeout=900):
    """The last row of the history, times and unknowns of a run; None if it did not end well."""
    with tempfile.TemporaryDirectory() as folder:
        command = ["mpirun", "-np", str(processes), "--oversubscribe"] if processes else []
        command += [program, SCENE, "--quiet", "--output", folder]
        for entry in ["Blank/Elements=%d" % cells, "Blank/Elements through thickness=%d" % cells,
                      "Solver/Linear solver=" + solver, *sets]:
            command += ["--set", entry]
        try:
            if subprocess.run(command, env=ENVIRONMENT, stderr=subprocess.DEVNULL, timeout=timeout).returncode != 0:
                return None
        except subprocess.TimeoutExpired:
            return None
        with open(os.path.join(folder, "history.csv")) as file:
            row = list(csv.DictReader(line for line in file if not line.startswith("#")))[-1]
        with open(os.path.join(folder, "timing.json")) as file:
            timing = json.load(file)
        with open(os.path.join(folder, "summary.json")) as file:
            summary = json.load(file)
        sections = {section["name"]: section for section in timing["sections"]}
        return {"row": row, "total": timing["total"], "unknowns": summary["unknowns"],
                "solve": next(s for name, s in sections.items() if name.startswith("11")),
                "assembly": next(s for name, s in sections.items() if name.startswith("3-6"))}


def per_solve(result):
    if result is None:
        return "-"
    return "%.1f" % (float(result["row"]["linear_iterations"]) / result["solve"]["calls"])


def iterations(program, cells):
    print("| epsilon (constant) | CG, multigrid | CG, diagonal | largest p |\n|---|---|---|---|")
    for exponent in range(2, 10):
        sets = ["Contact/Penalty rule=constant", "Contact/Penalty factor=1e%d" % exponent]
        results = [run(program, cells, solver, sets) for solver in ("cg amg", "cg diagonal")]
        p = next(("%.1e" % float(r["row"]["max_penetration"]) for r in results if r), "-")
        print("| 1e%d | %s | %s | %s |" % (exponent, *map(per_solve, results), p), flush=True)
    print("\n| rule | delta | CG, multigrid | CG, diagonal | epsilon, largest | p/delta |\n|---|---|---|---|---|---|")
    for rule in RULES:
        for delta in ("1e-3", "1e-5", "1e-7"):
            sets = ["Contact/Penalty rule=" + rule, "Contact/Allowed penetration=" + delta]
            results = [run(program, cells, solver, sets, timeout=120) for solver in ("cg amg", "cg diagonal")]
            row = next((r["row"] for r in results if r), None)
            tail = ("%.1e" % float(row["max_epsilon"]), "%.2g" % float(row["max_penetration_over_delta"])) if row else \
                ("-", "did not end")
            print("| %s | %s | %s | %s | %s | %s |" % (rule, delta, *map(per_solve, results), *tail), flush=True)


def cost(program, sizes, solvers):
    print("| unknowns | solver | iterations per solve | one solve, s | one assembly, s |\n|---|---|---|---|---|")
    points = {}
    for solver in solvers:
        for cells in sizes:
            result = run(program, cells, solver, ["Contact/Penalty rule=constant", "Contact/Penalty factor=2e4"])
            if result is None:
                print("| %d | %s | - | - | - |" % (2 * (cells + 1)**2, solver))
                continue
            seconds = result["solve"]["seconds"] / result["solve"]["calls"]
            points.setdefault(solver, []).append((result["unknowns"], seconds))
            count = per_solve(result) if "linear_iterations" in result["row"] else "direct"
            print("| %d | %s | %s | %.3g | %.3g |" % (result["unknowns"], solver, count, seconds,
                  result["assembly"]["seconds"] / result["assembly"]["calls"]), flush=True)
    for solver, line in points.items():
        if len(line) > 1:
            x, y = [math.log(n) for n, _ in line], [math.log(s) for _, s in line]
            mx, my = sum(x) / len(x), sum(y) / len(y)
            slope = sum((a - mx) * (b - my) for a, b in zip(x, y)) / sum((a - mx)**2 for a in x)
            print("\nFitted exponent of one solve, %s: %.2f" % (solver, slope))


def speed(program, sizes):
    print("| unknowns | processes | whole run, s | one solve, s | one assembly, s |\n|---|---|---|---|---|")
    for cells in sizes:
        for processes in (1, 2):
            result = run(program, cells, "cg amg", ["Contact/Penalty rule=constant", "Contact/Penalty factor=2e4"],
                         processes)
            if result:
                print("| %d | %d | %.4g | %.3g | %.3g |" % (
                    result["unknowns"], processes, result["total"], result["solve"]["seconds"] / result["solve"]["calls"],
                    result["assembly"]["seconds"] / result["assembly"]["calls"]), flush=True)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("what", choices=["iterations", "cost", "speed"])
    parser.add_argument("--cells", default="70")
    parser.add_argument("--solvers", default="klu,mumps,cg amg")
    arguments = parser.parse_args()
    sizes = [int(n) for n in arguments.cells.split(",")]
    if arguments.what == "iterations":
        iterations(arguments.program, sizes[0])
    elif arguments.what == "cost":
        cost(arguments.program, sizes, arguments.solvers.split(","))
    else:
        speed(arguments.program, sizes)


if __name__ == "__main__":
    main()
