#!/usr/bin/python3
"""Work and precision: runs problems over meshes, degrees, layers, increments, delta and rules of contact.

    tests/benchmark/work_precision.py [--build FOLDER] [--quick] [--only NAME ...] [--output FOLDER] [--write]

Every line of a plot varies one choice and keeps the others at the problem's base, so that the errors separate: a line ends
at the error of what it does not vary. 'all together' refines everything at once. The error is against the exact answer
where there is one, else against a run that is finer in everything, whose own error is estimated by a coarser one.
Writes work_precision.csv, a row per run, and a picture per problem into FOLDER (output/work_precision); --write renews
doc/measured/work_*.csv and the pictures in doc/gallery. Needs numpy and matplotlib; about ten minutes of one core, --quick
(first and last member of every line, no shell with friction, no solid) two.
"""
import argparse
import csv
import math
import os
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.join(ROOT, "scripts", "studies"))
sys.path.insert(0, os.path.join(ROOT, "tests", "scenes"))
from measured import MeasuredTable  # noqa: E402
import reference_values as exact  # noqa: E402
from experiments import Program  # noqa: E402
from work_precision_problems import problems  # noqa: E402

GALLERY = os.path.join(ROOT, "doc", "gallery")
GOALS = (1e-2, 1e-3)
COLOURS = ["#0072b2", "#56b4e9", "#009e73", "#e69f00", "#d55e00", "#cc79a7", "#7b4fa3"]
MARKERS = ["o", "s", "^", "D", "v", "P", "X"]


def entries_of(*settings):
    merged = {}
    for setting in settings:
        merged.update(setting)
    return [f"{name}={value}" for name, value in merged.items()]


def measure(problem, program, quick):
    """Rows: problem, line, what varies, its value, seconds, iterations, increments, unknowns, errors."""
    reference, doubt = problem.reference, [0.] * len(problem.quantities)
    if reference is None:
        runs = [program(problem.scene, *entries_of(problem.fixed, problem.base, own)) for own in problem.overkill]
        if not all(run.done for run in runs):
            sys.exit(f"{problem.name}: the run to compare with is not done")
        values = [problem.values(run) for run in runs]
        reference = values[-1]
        doubt = [largest_error(a, b) for a, b in zip(values[0], values[1])]
    rows = []
    for line, members in problem.lines.items():
        for label, own in (members[:1] + members[-1:] if quick and len(members) > 2 else members):
            run = program(problem.scene, *entries_of(problem.fixed, problem.base, own))
            row = {"problem": problem.name, "line": line, "value": label, "status": run.status}
            if run.done:
                row.update(seconds=run.seconds, iterations=run.iterations, increments=run.increments, unknowns=run.unknowns,
                           cutbacks=run.cutbacks)
                for name, value, wanted in zip(problem.quantities, problem.values(run), reference):
                    row["error of " + name] = largest_error(value, wanted)
            rows.append(row)
            print(" ", line, label, *(f"{key} {row[key]:.3g}" for key in row if key not in ("problem", "line", "value", "status")), flush=True)
    return rows, doubt


def largest_error(values, references):
    return max(abs(value / reference - 1) for value, reference in zip(values, references))


def goals(problem, rows, doubt):
    """What reaches the goals in the least time."""
    cells = []
    for name in problem.quantities:
        for goal in GOALS:
            enough = [row for row in rows if row.get("error of " + name, math.inf) <= goal]
            if not enough:
                cells.append((name, goal, "not reached", "", "", ""))
                continue
            best = min(enough, key=lambda row: row["seconds"])
            cells.append((name, goal, f"{best['line']}: {best['value']}", f"{best['seconds']:.2f}", f"{best['iterations']:g}",
                          f"{best['error of ' + name]:.1e}"))
    known = "" if problem.reference is not None else "known to " + ", ".join(f"{d:.0e} ({n})" for n, d in zip(problem.quantities, doubt))
    return [[problem.name, known, c[0], f"{100 * c[1]:g} %", *c[2:]] for c in cells]


def table(problem, rows):
    """Every run of a problem."""
    head = ["line", "value", "unknowns", "increments", "iterations", "seconds", *("error of " + name for name in problem.quantities)]
    cells = []
    for row in rows:
        name = row["line"]
        if "seconds" not in row:
            cells.append([name, row["value"], "", "", "", f"status {row['status']}", *("" for _ in problem.quantities)])
            continue
        cells.append([name, row["value"], f"{row['unknowns']:g}", f"{row['increments']:g}", f"{row['iterations']:g}", f"{row['seconds']:.2f}",
                      *(f"{row['error of ' + quantity]:.1e}" for quantity in problem.quantities)])
    return MeasuredTable(head, cells)


def picture(problem, rows, doubt, path):
    """Error over seconds, a panel per quantity and a line per choice."""
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    from matplotlib.ticker import NullFormatter
    n = len(problem.quantities)
    figure, axes = plt.subplots(1, n, figsize=(4.9 * n + 2.2, 4.4), squeeze=False, constrained_layout=True)
    for axis, quantity, known in zip(axes[0], problem.quantities, doubt):
        for number, line in enumerate(problem.lines):
            points = [(row["seconds"], max(row["error of " + quantity], 1e-8), row["value"]) for row in rows
                      if row["line"] == line and "seconds" in row]
            if not points:
                continue
            bold, series = line == "all together", line != "rule"
            colour, marker = ("#222222", "*") if bold else (COLOURS[number % 7], MARKERS[number % 7])
            axis.loglog([p[0] for p in points], [p[1] for p in points], marker + ("-" if series else ""), color=colour, label=line,
                        markersize=9 if bold else 5, linewidth=2.4 if bold else 1.2, zorder=3 if bold else 2)
            # The first of a line is its crudest; names of rules all, because they have no order.
            for end in range(len(points)) if not series else {0, len(points) - 1} if bold else {0}:
                axis.annotate(points[end][2], points[end][:2], textcoords="offset points", xytext=(4, 4), fontsize=7,
                              color=colour)
        for goal in GOALS:
            axis.axhline(goal, color="#999999", linewidth=.8, linestyle=":")
        if known > 0.:
            axis.axhspan(1e-9, known, color="#eeeeee", zorder=0)
        shown = [max(row["error of " + quantity], 1e-8) for row in rows if "seconds" in row]
        axis.set_ylim(min(shown) / 2, max(shown) * 2)
        axis.xaxis.set_minor_formatter(NullFormatter())
        axis.set_xlabel("computing time [s]")
        axis.set_ylabel("error of " + quantity)
        axis.grid(color="#e5e5e5")
    axes[0][-1].legend(fontsize=8, loc="upper left", bbox_to_anchor=(1.01, 1.))
    figure.suptitle(problem.name, fontsize=11)
    figure.savefig(path, dpi=100)
    plt.close(figure)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default=os.path.join(ROOT, "build", "release"), help="build folder")
    parser.add_argument("--output", default=os.path.join(ROOT, "output", "work_precision"), help="folder for the CSV file and the pictures")
    parser.add_argument("--quick", action="store_true", help="first and last member of every line, the fast problems only")
    parser.add_argument("--only", nargs="+", metavar="NAME", help="problems whose key is one of these")
    parser.add_argument("--write", action="store_true", help="renew doc/measured/work_*.csv and the pictures")
    options = parser.parse_args()
    os.makedirs(options.output, exist_ok=True)
    program = Program(os.path.join(options.build, "deltaform"), short=.5)
    chosen = [p for p in problems(exact) if (p.key in options.only if options.only else not (options.quick and p.slow))]
    if not chosen:
        parser.error("there is no such problem; known are " + ", ".join(p.key for p in problems(exact)))
    all_rows, best, tables = [], [], {}
    for problem in chosen:
        print(problem.name, flush=True)
        rows, doubt = measure(problem, program, options.quick)
        all_rows += rows
        own = goals(problem, rows, doubt)
        best += own
        tables[problem.key] = table(problem, rows)
        for folder in [options.output] + ([GALLERY] if options.write else []):
            picture(problem, rows, doubt, os.path.join(folder, f"work_{problem.key}.png"))
    columns = list(dict.fromkeys(key for row in all_rows for key in row))
    with open(os.path.join(options.output, "work_precision.csv"), "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, columns)
        writer.writeheader()
        writer.writerows(all_rows)
    fastest = MeasuredTable(["problem", "reference", "quantity", "error at most", "least time by", "seconds", "iterations", "error reached"], best)
    print(f"\n{fastest}")
    print(f"\n{program.seconds:.0f} s of computing in {len(program.known)} runs")
    if options.write:
        for problem in chosen:
            tables[problem.key].write("work_" + problem.key, f"{problem.name}: error against computing time, one choice varied per line")
        if not options.only:
            fastest.write("work_goals", "least computing time for errors of 1 % and .1 %")


if __name__ == "__main__":
    main()
