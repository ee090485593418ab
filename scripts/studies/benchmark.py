#!/usr/bin/env python3
"""Measures the speed of deltaform.

    scripts/studies/benchmark.py [--write] [--build FOLDER] [--runs N]

1. The whole process of the main job (the cup of 50 elements to a travel of 1 in, all default outputs) against an empty
   program that is linked to the same libraries and starts and ends MPI with the same settings; alternating runs.
2. The cost of a Newton iteration from 50 to 3200 elements, and the exponent n of cost ~ elements^n.
3. The same of a solid, and its assembly by a plain loop and by WorkStream.
4. Of runs that take over 2 s: the share of start-up, output and bookkeeping.

--write renews doc/measured/speed_*.csv. Builds what it needs. Standard library only; about three minutes.
"""
import argparse
import json
import math
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time

from measured import ROOT, MeasuredTable

# Most of them little longer than the two seconds from which on their share counts, as start and end weigh most there. The last
# one has increments a hundred times as short as the default, with one iteration each.
LONG_RUNS = [("prm/cup.prm", ["Blank/Elements=800"]), ("prm/cup.prm", ["Blank/Elements=1600", "Steps/form/End time=0.65"]),
             ("prm/u_bend.prm", []), ("prm/cup_solid.prm", []),
             ("prm/upsetting.prm", ["Blank/Elements=48", "Blank/Elements through thickness=72"]),
             ("prm/osu_stretching_solid.prm", ["Blank/Elements=430", "Blank/Elements through thickness=4", "Blank/Degree=1"]),
             ("prm/cup.prm", ["Steps/form/Largest increment=1.25e-4"])]
ELEMENTS = [50, 100, 200, 400, 800, 1600, 3200]


def call(command):
    """Wall and processor seconds of a whole process."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    start = time.perf_counter()
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, cwd=ROOT)
    wall = time.perf_counter() - start
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return wall, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def load(folder, name):
    with open(os.path.join(folder, name), encoding="utf-8") as file:
        return json.load(file)


def libraries(program):
    """Names of the shared libraries that a program loads."""
    listing = subprocess.run(["ldd", program], check=True, stdout=subprocess.PIPE, text=True).stdout
    return {line.split()[0] for line in listing.splitlines() if line.strip()}


def compare_libraries(program, empty):
    """The empty program is a fair measure only if it loads nothing that deltaform does not load."""
    of_program, of_empty = libraries(program), libraries(empty)
    if of_empty - of_program:
        sys.exit("benchmark: the empty program loads what deltaform does not: " + ", ".join(sorted(of_empty - of_program)))
    missing = sorted(of_program - of_empty)
    return f"Libraries loaded: deltaform {len(of_program)}, empty program {len(of_empty)}" + \
           (f" (without {', '.join(missing)})." if missing else ".")


def whole_process(program, empty, folder, runs):
    """Medians over alternating runs, on two meshes."""
    table = MeasuredTable(["elements", "program", "whole process [s]", "fastest [s]", "processor time [s]"])
    for elements in (50, 400):
        command = [program, "prm/cup.prm", "--output", folder, "--set", f"Blank/Elements={elements}"]
        call(command), call([empty])  # libraries into the page cache
        cup, nothing, computing = [], [], []
        for _ in range(runs):
            nothing.append(call([empty]))
            cup.append(call(command))
            computing.append(load(folder, "timing.json")["total"])
        wall, processor = ([statistics.median(run[k] for run in of) for of in (cup, nothing)] for k in (0, 1))
        fastest = [min(run[0] for run in of) for of in (cup, nothing)]
        table.add(elements, "deltaform prm/cup.prm, all default outputs", f"{wall[0]:.3f}", f"{fastest[0]:.3f}", f"{processor[0]:.3f}")
        table.add(elements, "empty program, same libraries, MPI started and ended", f"{wall[1]:.3f}", f"{fastest[1]:.3f}", f"{processor[1]:.3f}")
        table.add(elements, "ratio", f"{wall[0] / wall[1]:.2f}", f"{fastest[0] / fastest[1]:.2f}", f"{processor[0] / processor[1]:.2f}")
        table.add(elements, "of which deltaform computes and writes (timing.json, total)", f"{statistics.median(computing):.3f}",
                  f"{min(computing):.3f}", "")
    return table


def per_iteration(program, folder, repetitions):
    """Milliseconds per Newton iteration, the least of some runs, and a sentence with the fitted exponents. Named steps 3 to 9 and 11 of
    timing.json, failed iterations and line searches included."""
    table = MeasuredTable(["elements", "Newton iterations", "assemblies per iteration", "time per iteration [ms]", "blank", "contact",
                           "linear solve", "per element [us]"])
    costs, per_assembly = [], []
    for n in ELEMENTS:
        best = None
        for _ in range(repetitions):
            call([program, "prm/cup.prm", "--quiet", "--output", folder, "--set", f"Blank/Elements={n}",
                  "--set", "Steps/form/End time=0.1", "--set", "Output/Pictures=0"])
            iterations = load(folder, "summary.json")["newton_iterations"]
            sections = load(folder, "timing.json")["sections"]
            blank, contact, solve = (next(s for s in sections if s["name"].startswith(number)) for number in ("3-6", "7-9", "11"))
            parts = [1e3 * part["seconds"] / iterations for part in (blank, contact, solve)]
            if best is None or sum(parts) < sum(best):
                best, assemblies = parts, blank["calls"] / iterations
        costs.append(sum(best))
        per_assembly.append((best[0] + best[1]) / assemblies + best[2])
        table.add(n, f"{iterations:g}", f"{assemblies:.2f}", f"{sum(best):.3f}", *(f"{part:.3f}" for part in best), f"{1e3 * sum(best) / n:.2f}")
    return table, (f"cost ~ elements^{exponent(costs):.2f}; with one assembly per iteration on every mesh, that is without line searches and "
                   f"corrections: elements^{exponent(per_assembly):.2f}")


def steps_of(program, folder, entries, repetitions):
    """Iterations, assemblies and the least seconds of blank, contact and linear solve."""
    best = None
    for _ in range(repetitions):
        call([program, "prm/cup_solid.prm", "--quiet", "--output", folder, "--set", "Output/Pictures=0",
              *(word for entry in entries for word in ("--set", entry))])
        iterations = load(folder, "summary.json")["newton_iterations"]
        sections = load(folder, "timing.json")["sections"]
        parts = [next(s for s in sections if s["name"].startswith(number)) for number in ("3-6", "7-9", "11")]
        seconds = [part["seconds"] for part in parts]
        best = seconds if best is None else [min(pair) for pair in zip(best, seconds)]
    return iterations, parts[0]["calls"], best


def solid(program, folder, repetitions):
    """The cup of a solid: named steps of an iteration."""
    table = MeasuredTable(["degree", "elements", "Newton iterations", "assemblies per iteration", "time per iteration [ms]", "blank", "contact",
                           "linear solve", "blank, per cell and assembly [us]"])
    for degree, along, across in ((1, 100, 4), (1, 200, 4), (1, 400, 4), (2, 50, 2), (2, 100, 2), (2, 200, 2)):
        iterations, assemblies, seconds = steps_of(
            program, folder, [f"Blank/Degree={degree}", f"Blank/Elements={along}", f"Blank/Elements through thickness={across}",
                              "Steps/form/End time=0.1"], repetitions)
        per = [1e3 * value / iterations for value in seconds]
        table.add(degree, f"{along} x {across}", f"{iterations:g}", f"{assemblies / iterations:.2f}", f"{sum(per):.2f}",
                  *(f"{value:.2f}" for value in per), f"{1e6 * seconds[0] / assemblies / (along * across):.2f}")
    return table


def loops(program):
    """Loops over the cells, as the program assembly_loops prints them."""
    lines = subprocess.run([program], check=True, stdout=subprocess.PIPE, text=True).stdout.strip().split("\n")
    head, _, *rows = ([cell.strip() for cell in line.strip("|").split("|")] for line in lines)
    return MeasuredTable(head, rows)


def shares(program, empty, folder):
    """Of whole processes, all default outputs, what is not an iteration. Start-up (1): until the first increment; output (13): what the run
    waits for; bookkeeping: accepting increments (12) and what bears no name. The empty program stands for loading the libraries and MPI."""
    table = MeasuredTable(["scene", "whole process", "iterations (2 to 11)", "start-up (1)", "output (13)", "bookkeeping (12, rest)",
                           "empty program", "share of 1, 12, 13 and rest", "with the empty program"])
    for scene, entries in LONG_RUNS:
        command = [program, scene, "--quiet", "--output", folder, *(word for entry in entries for word in ("--set", entry))]
        parts, nothing = [], []
        for _ in range(5):
            nothing += [call([empty])[0], call([empty])[0]]
            wall = call(command)[0]
            sections = load(folder, "timing.json")["sections"]
            start_up, output, steps = (sum(s["seconds"] for s in sections if test(s["name"].split()[0])) for test in (
                lambda step: step == "1", lambda step: step == "13", lambda step: step not in ("1", "12", "13")))
            parts.append((steps, start_up, output, wall - steps - start_up - output))
        steps, start_up, output, rest = (min(part) for part in zip(*parts))
        wall, loading = steps + start_up + output + rest, min(nothing)
        table.add(", ".join([scene, *entries]), f"{wall:.2f}", f"{steps:.2f}", f"{start_up:.3f}", f"{output:.3f}", f"{rest - loading:.3f}",
                  f"{loading:.3f}", f"{100 * (start_up + output + rest - loading) / (wall - loading):.1f} %", f"{100 * (start_up + output + rest) / wall:.1f} %")
    return table


def exponent(costs):
    """Slope of the straight line through log(cost) over log(elements)."""
    x, y = [math.log(n) for n in ELEMENTS], [math.log(cost) for cost in costs]
    mean_x, mean_y = statistics.fmean(x), statistics.fmean(y)
    return sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / sum((a - mean_x) ** 2 for a in x)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default=os.path.join(ROOT, "build", "release"), help="build folder")
    parser.add_argument("--runs", type=int, default=15, help="alternating runs of the whole process")
    parser.add_argument("--repetitions", type=int, default=3, help="runs per mesh")
    parser.add_argument("--write", action="store_true", help="renew doc/measured/speed_*.csv")
    options = parser.parse_args()

    build = os.path.abspath(options.build)
    subprocess.run([os.path.join(ROOT, "scripts", "build.sh"), build, "deltaform", "empty_process", "assembly_loops"], check=True, stdout=sys.stderr)
    program = os.path.join(build, "deltaform")
    empty, cells = (os.path.join(build, "tests", "benchmark", name) for name in ("empty_process", "assembly_loops"))
    with tempfile.TemporaryDirectory() as folder:
        iteration, fitted = per_iteration(program, folder, options.repetitions)
        tables = {
            "speed_process": (whole_process(program, empty, folder, options.runs),
                              f"whole process of prm/cup.prm, medians of {options.runs} alternating runs"),
            "speed_iteration": (iteration, f"a Newton iteration of the cup to .1 in, least of {options.repetitions} runs; {fitted}"),
            "speed_solid": (solid(program, folder, options.repetitions),
                            "a Newton iteration of prm/cup_solid.prm to .1 in, least of each step [ms]"),
            "speed_loops": (loops(cells), "assembly of a cell of degree 2 [us], least of 30 passes"),
            "speed_shares": (shares(program, empty, folder), "whole processes with all default outputs [s], each number the least of 5 runs; "
                             "numbers in parentheses: steps of timing.json")}
    print(compare_libraries(program, empty))
    for name, (table, title) in tables.items():
        print(f"\n{title}\n{table}")
        if options.write:
            table.write(name, title)


if __name__ == "__main__":
    main()
