#!/usr/bin/env python3
"""Measures the speed of deltaform and prints it as Markdown.

    scripts/benchmark.py [--write doc/speed.md] [--build FOLDER] [--runs N]

1. The whole process of the main job (the cup of 50 elements to a travel of 1 in, all default outputs) against an empty
   program that is linked to the same libraries and starts and ends MPI with the same settings; alternating runs.
2. The cost of a Newton iteration from 50 to 3200 elements, and the exponent n of cost ~ elements^n.
3. The same of a solid, and its assembly by a plain loop and by WorkStream.
4. Of runs that take over 2 s: the share of start-up, output and bookkeeping.

Builds what it needs. Standard library only; about three minutes.
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

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
BY_HAND = "## Found on the way"  # of the page: from here on it is kept as it is
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


def whole_process(program, empty, folder, runs, elements):
    """Lines of a table: medians over alternating runs."""
    command = [program, "prm/cup.prm", "--output", folder, "--set", f"Blank/Elements={elements}"]
    call(command), call([empty])  # libraries into the page cache
    cup, nothing, computing = [], [], []
    for _ in range(runs):
        nothing.append(call([empty]))
        cup.append(call(command))
        computing.append(load(folder, "timing.json")["total"])
    summary = load(folder, "summary.json")
    wall, processor = ([statistics.median(run[k] for run in of) for of in (cup, nothing)] for k in (0, 1))
    return [
        f"The cup of `prm/cup.prm` with {elements} elements ({summary['increments']:g} increments, {summary['newton_iterations']:g} Newton iterations, "
        f"{runs} alternating runs, medians):",
        "",
        "| | whole process [s] | fastest [s] | processor time [s] |",
        "|---|---|---|---|",
        f"| deltaform prm/cup.prm, all default outputs | {wall[0]:.3f} | {min(r[0] for r in cup):.3f} | {processor[0]:.3f} |",
        f"| empty program, same libraries, MPI started and ended | {wall[1]:.3f} | {min(r[0] for r in nothing):.3f} | {processor[1]:.3f} |",
        f"| **ratio** | **{wall[0] / wall[1]:.2f}** | {min(r[0] for r in cup) / min(r[0] for r in nothing):.2f} "
        f"| {processor[0] / processor[1]:.2f} |",
        f"| of which deltaform computes and writes (`timing.json`, total) | {statistics.median(computing):.3f} | {min(computing):.3f} | |",
        "",
    ]


def per_iteration(program, folder, repetitions):
    """Lines of a table: milliseconds per Newton iteration, the least of some runs, and the fitted exponent."""
    lines = [
        "A Newton iteration of the cup to a travel of 0.1 in (the named steps 3 to 9 and 11 of `timing.json`, failed iterations and",
        f"line searches included; the least of {repetitions} runs, because other work on the machine only ever adds):",
        "",
        "| elements | Newton iterations | assemblies per iteration | time per iteration [ms] | blank | contact | linear solve | "
        "per element [us] |",
        "|---|---|---|---|---|---|---|---|",
    ]
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
        lines.append(f"| {n} | {iterations:g} | {assemblies:.2f} | {sum(best):.3f} | {best[0]:.3f} | {best[1]:.3f} | {best[2]:.3f} | "
                     f"{1e3 * sum(best) / n:.2f} |")
    return [*lines, "",
            f"Fitted: cost ~ elements^**{exponent(costs):.2f}** (asked: at most 1.1). With one assembly per iteration on every mesh, "
            f"that is without line searches and corrections: elements^{exponent(per_assembly):.2f}."]


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


def solid(program, loops, folder, repetitions):
    """Lines about the cup of a solid: named steps of an iteration, and loops over the cells."""
    lines = ["A Newton iteration of `prm/cup_solid.prm` to a travel of 0.1 in (least of each step):", "",
             "| degree | elements | Newton iterations | assemblies per iteration | time per iteration [ms] | blank | contact | linear solve | "
             "blank, per cell and assembly [us] |", "|---|---|---|---|---|---|---|---|---|"]
    for degree, along, across in ((1, 100, 4), (1, 200, 4), (1, 400, 4), (2, 50, 2), (2, 100, 2), (2, 200, 2)):
        iterations, assemblies, seconds = steps_of(
            program, folder, [f"Blank/Degree={degree}", f"Blank/Elements={along}", f"Blank/Elements through thickness={across}",
                              "Steps/form/End time=0.1"], repetitions)
        per = [1e3 * value / iterations for value in seconds]
        lines.append(f"| {degree} | {along} x {across} | {iterations:g} | {assemblies / iterations:.2f} | {sum(per):.2f} | {per[0]:.2f} | "
                     f"{per[1]:.2f} | {per[2]:.2f} | {1e6 * seconds[0] / assemblies / (along * across):.2f} |")
    table = subprocess.run([loops], check=True, stdout=subprocess.PIPE, text=True).stdout.strip().split("\n")
    return [*lines, "", "Microseconds per cell of degree 2 (`assembly_loops`: material, tangent and adding to the matrix), least of 30 passes:",
            "", *table]


def shares(program, empty, folder):
    """Lines of a table: of whole processes, all default outputs, what is not an iteration."""
    lines = ["Whole processes with all default outputs, each number the least of 5 runs [s], because other work on the machine only ever adds; the whole is their sum. The numbers",
             "are those of the named steps of `timing.json`. Start-up (1) is reading and checking the scene and making the mesh, until the first increment; output (13) is what the run waits for, as pictures, tables and saved",
             "states are written by a second thread; bookkeeping is accepting increments (12) and what bears no name: step control, the end. Iterations include the",
             "start of an increment (tools, predictor) and its checks. The empty program stands for loading the libraries and MPI.", "",
             "| scene | whole process | iterations (2 to 11) | start-up (1) | output (13) | bookkeeping (12, rest) | empty program | share of 1, 12, 13 and rest |",
             "|---|---|---|---|---|---|---|---|"]
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
        lines.append(f"| `{scene}`{', ' if entries else ''}{', '.join(entries)} | {wall:.2f} | {steps:.2f} | {start_up:.3f} | {output:.3f} | "
                     f"{rest - loading:.3f} | {loading:.3f} | {100 * (start_up + output + rest - loading) / (wall - loading):.1f} % |")
    return lines


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
    parser.add_argument("--write", metavar="FILE", help="write the page here as well")
    options = parser.parse_args()

    build = os.path.abspath(options.build)
    subprocess.run([os.path.join(ROOT, "scripts", "build.sh"), build, "deltaform", "empty_process", "assembly_loops"], check=True, stdout=sys.stderr)
    program, empty = os.path.join(build, "deltaform"), os.path.join(build, "tests", "benchmark", "empty_process")
    with tempfile.TemporaryDirectory() as folder:
        lines = ["# Speed", "", "Printed by `scripts/benchmark.py`; Release, one process, one thread.", "",
                 "## The main job", "", *whole_process(program, empty, folder, options.runs, 50),
                 *whole_process(program, empty, folder, options.runs, 400), compare_libraries(program, empty), "",
                 "## Cost of an iteration", "", *per_iteration(program, folder, options.repetitions), "",
                 "## The solid", "", *solid(program, os.path.join(build, "tests", "benchmark", "assembly_loops"), folder,
                                            options.repetitions), "",
                 "## Start-up, output, bookkeeping", "", *shares(program, empty, folder)]
    print("\n".join(lines))
    if options.write:
        by_hand = ""
        if os.path.exists(options.write):
            with open(options.write, encoding="utf-8") as file:
                _, heading, text = file.read().partition(BY_HAND)
            by_hand = "\n" + heading + text if heading else ""
        with open(options.write, "w", encoding="utf-8") as file:
            file.write("\n".join(lines) + "\n" + by_hand)


if __name__ == "__main__":
    main()
