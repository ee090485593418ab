#!/usr/bin/env python3
"""Measures the linear solvers on the blocks of tests/distributed; --write renews doc/measured/linear_*.csv.

    linear_solvers.py PROGRAM iterations            iterations per solve against epsilon and delta, rule by rule, and under
                                                    a plane that is inclined
    linear_solvers.py PROGRAM cost --cells 70,223   processor time per Newton iteration against the number of unknowns, with
                                                    fitted exponents: over all sizes, and from --from on; --path
                                                    automatic: with the linear path
    linear_solvers.py PROGRAM paths --cells 70,223  the same with the linear path on and off, in a run of eight increments
    linear_solvers.py PROGRAM shapes                the direct solvers on strips and blocks of some 2e4 unknowns
    linear_solvers.py PROGRAM speed --cells 316     1 and 2 processes
"""
import argparse
import json
import math
import os
import resource
import subprocess
import tempfile

from measured import ROOT, MeasuredTable
from csv_file import rows_of

SCENES = os.path.join(ROOT, "tests", "distributed")
RULES = ["adaptive", "constant", "paper", "element stiffness", "proportional", "gap driven"]
ITERATIVE = ["cg amg", "cg blocks", "cg diagonal"]
ENVIRONMENT = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")


def processor_time():
    """Of all runs so far: what others do on the machine hardly counts."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def run(program, cells, solver, sets=(), processes=0, timeout=900, scene="hertz_block"):
    """The last row of the history, times and unknowns of a run; None if it did not end well. @p cells: along and across."""
    along, across = cells if isinstance(cells, tuple) else (cells, cells)
    with tempfile.TemporaryDirectory() as folder:
        command = ["mpirun", "-np", str(processes), "--oversubscribe", "--bind-to", "none"] if processes else []
        command += [program, os.path.join(SCENES, scene + ".prm"), "--quiet", "--output", folder]
        for entry in ["Blank/Elements=%d" % along, "Blank/Elements through thickness=%d" % across,
                      "Solver/Linear solver=" + solver, *sets]:
            command += ["--set", entry]
        before = processor_time()
        try:
            if subprocess.run(command, env=ENVIRONMENT, stderr=subprocess.DEVNULL, timeout=timeout).returncode != 0:
                return None
        except subprocess.TimeoutExpired:
            return None
        used = processor_time() - before
        largest = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1e6
        row = rows_of(os.path.join(folder, "history.csv"))[-1]
        with open(os.path.join(folder, "timing.json")) as file:
            timing = json.load(file)
        with open(os.path.join(folder, "summary.json")) as file:
            summary = json.load(file)
        sections = {section["name"]: section for section in timing["sections"]}
        return {"row": row, "processor": used, "largest so far [GB]": largest, "total": timing["total"], "unknowns": summary["unknowns"],
                "solve": next(s for name, s in sections.items() if name.startswith("11")),
                "assembly": next(s for name, s in sections.items() if name.startswith("3-6"))}


def per_solve(result):
    if result is None:
        return "-"
    return "%.1f" % (float(result["row"]["linear_iterations"]) / result["solve"]["calls"])


def iterations(program, cells):
    constant = MeasuredTable(["scene", "epsilon (constant)", *ITERATIVE, "largest p"])
    for scene in ("hertz_block", "inclined_block"):
        for exponent in range(2, 10):
            sets = ["Contact/Penalty rule=constant", "Contact/Penalty factor=1e%d" % exponent]
            results = [run(program, cells, solver, sets, timeout=120, scene=scene) for solver in ITERATIVE]
            p = next(("%.1e" % float(r["row"]["max_penetration"]) for r in results if r), "-")
            constant.add(scene, "1e%d" % exponent, *map(per_solve, results), p)
    rules = MeasuredTable(["rule", "delta", *ITERATIVE, "epsilon, largest", "p/delta"])
    for rule in RULES:
        for delta in ("1e-3", "1e-5", "1e-7"):
            sets = ["Contact/Penalty rule=" + rule, "Contact/Allowed penetration=" + delta]
            results = [run(program, cells, solver, sets, timeout=120) for solver in ITERATIVE]
            row = next((r["row"] for r in results if r), None)
            tail = ("%.1e" % float(row["max_epsilon"]), "%.2g" % float(row["max_penetration_over_delta"])) if row else \
                ("-", "did not end")
            rules.add(rule, delta, *map(per_solve, results), *tail)
    return {"linear_iterations_constant": (constant, "iterations per linear solve, one penalty factor for all points"),
            "linear_iterations_rules": (rules, "iterations per linear solve, Hertz's block: rules and delta")}


def exponent(points):
    """Slope of the line through the logarithms of (unknowns, seconds)."""
    x, y = [math.log(n) for n, _ in points], [math.log(s) for _, s in points]
    mx, my = sum(x) / len(x), sum(y) / len(y)
    return sum((a - mx) * (b - my) for a, b in zip(x, y)) / sum((a - mx)**2 for a in x)


def cost(program, sizes, solvers, first, path):
    # Memory: the largest of any run so far, so that it is right as long as it grows.
    table = MeasuredTable(["unknowns", "solver", "iterations per solve", "processor time per Newton iteration [s]", "memory [GB]"])
    points = {}
    for solver in solvers:
        for cells in sizes:
            result = run(program, cells, solver, ["Contact/Penalty rule=constant", "Contact/Penalty factor=2e4",
                                                  "Solver/Linear path=" + path])
            if result is None:
                table.add(2 * (cells + 1)**2, solver, "-", "-", "-")
                continue
            seconds = result["processor"] / result["solve"]["calls"]
            points.setdefault(solver, []).append((result["unknowns"], seconds))
            count = per_solve(result) if "linear_iterations" in result["row"] else "direct"
            table.add("%d" % result["unknowns"], solver, count, "%.3g" % seconds, "%.2f" % result["largest so far [GB]"])
    fits = MeasuredTable(["solver", "exponent over all sizes", "from on", "exponent from there on"])
    for solver, line in points.items():
        large = [point for point in line if point[0] >= first]
        over_all, over_large = ("%.2f" % exponent(fit) if len(fit) > 1 else "-" for fit in (line, large))
        fits.add(solver, over_all, "%g" % first, over_large)
    return {"linear_cost": (table, "processor time per Newton iteration over the number of unknowns, start of the program included; memory"),
            "linear_exponents": (fits, "exponents of processor time over unknowns, by least squares")}


def paths(program, sizes, solvers):
    table = MeasuredTable(["unknowns", "solver", "Newton iterations", "off [s]", "automatic [s]", "ratio"])
    for cells in sizes:
        for solver in solvers:
            sets = ["Steps/press/First increment=0.125", "Steps/press/Largest increment=0.125"]
            off, on = (run(program, cells, solver, sets + ["Solver/Linear path=" + path])
                       for path in ("off", "automatic"))
            if off and on:
                table.add("%d" % on["unknowns"], solver, "%d" % on["solve"]["calls"], "%.3g" % off["processor"],
                          "%.3g" % on["processor"], "%.2g" % (off["processor"] / on["processor"]))
    return {"linear_path": (table, "linear path off and on: processor time of whole runs of eight increments, Hertz's block")}


def shapes(program, solvers):
    table = MeasuredTable(["cells", "unknowns", *("%s [s]" % solver for solver in solvers)])
    for along, across in ((2500, 4), (1250, 8), (600, 16), (300, 32), (100, 100), (150, 150)):
        sets = ["Contact/Penalty rule=constant", "Contact/Penalty factor=2e4", "Solver/Linear path=off",
                "Blank/Thickness=%r" % (10. * across / along), "Tools/cylinder/Motion=%r*t" % (.05 * across / along)]
        results = [run(program, (along, across), solver, sets) for solver in solvers]
        table.add("%d x %d" % (along, across), 2 * (along + 1) * (across + 1), *("%.3g" % r["processor"] if r else "-" for r in results))
    return {"linear_shapes": (table, "direct solvers: processor time of whole runs")}


def speed(program, sizes):
    table = MeasuredTable(["unknowns", "processes", "whole run [s]", "one solve [s]", "one assembly [s]"])
    for cells in sizes:
        for processes in (1, 2):
            result = run(program, cells, "cg amg", ["Contact/Penalty rule=constant", "Contact/Penalty factor=2e4"],
                         processes)
            if result:
                table.add("%d" % result["unknowns"], processes, "%.4g" % result["total"],
                          "%.3g" % (result["solve"]["seconds"] / result["solve"]["calls"]),
                          "%.3g" % (result["assembly"]["seconds"] / result["assembly"]["calls"]))
    return {"linear_processes": (table, "one and two processes, cg amg")}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("what", choices=["iterations", "cost", "paths", "shapes", "speed"])
    parser.add_argument("--cells", default="70")
    parser.add_argument("--solvers", default="klu,mumps,cg amg")
    parser.add_argument("--path", choices=["off", "automatic"], default="off")
    parser.add_argument("--from", dest="first", type=float, default=1e5)
    parser.add_argument("--write", action="store_true", help="renew doc/measured/linear_*.csv")
    arguments = parser.parse_args()
    sizes = [int(n) for n in arguments.cells.split(",")]
    solvers = arguments.solvers.split(",")
    direct = [solver for solver in solvers if solver != "cg amg"]
    if arguments.what == "iterations":
        tables = iterations(arguments.program, sizes[0])
    elif arguments.what == "cost":
        tables = cost(arguments.program, sizes, solvers, arguments.first, arguments.path)
    elif arguments.what == "paths":
        tables = paths(arguments.program, sizes, direct)
    elif arguments.what == "shapes":
        tables = shapes(arguments.program, direct)
    else:
        tables = speed(arguments.program, sizes)
    for name, (table, title) in tables.items():
        print(f"{title}\n{table}\n")
        if arguments.write:
            table.write(name, title)


if __name__ == "__main__":
    main()
