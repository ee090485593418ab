#!/usr/bin/env python3
"""Runs scenes drawn at random and checks that each ends well: done with the promise kept, or with a clear error.

    stress.py PROGRAM FOLDER [--first N] [--count N] [--sensible] [--seeds LIST] [--jobs N] [--seconds N] [--resume N] [--write NAME] [--keep]

Never allowed, whatever the scene: a crash, a hang (more than --seconds of processor time), NaN or infinity in a result, a promise
p <= delta that is broken silently, an exit status without its message, a run that ends as done although its files show that forces are
out of balance, that more than 1 % of the work are missing or that the sheet has less than a third of its thickness left, without a
warning in summary.json. These make the exit status of this script 1; so
does a share of completed sensible scenes below --share. --resume N kills the first N scenes that take long enough at
random moments, and demands the same results from the resumed run. A scene is known by its number:
'stress.py PROGRAM FOLDER --first 17 --count 1 --keep' runs number 17 alone and keeps its results.
"""
import argparse
import collections
import concurrent.futures
import json
import math
import os
import pathlib
import random
import re
import shutil
import signal
import subprocess
import sys
import time

import draw

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tests" / "scenes"))
sys.path.append(str(ROOT / "scripts" / "studies"))
import check_run
import resume
import torn
from measured import MeasuredTable
from run_files import CsvFile, NoRun, Run, not_finite

BAD = ("crash", "hang", "NaN in a result", "promise broken silently", "status and message disagree", "wrong without a word",
       "resumed run differs")
SHARE = 1e-3     # of the largest force of a row that may be out of balance: the relaxed force tolerance of thin sheets
THINNEST = 1 / 3  # of the initial thickness: below, no sheet metal is whole


def csv_rows(path):
    file = CsvFile(path)
    return [file.names] + file.rows


def worst_promise(folder):
    """Largest p/delta of the history, and the penetration beyond delta that belongs to it."""
    rows = csv_rows(folder / "history.csv")
    ratio, depth = rows[0].index("max_penetration_over_delta"), rows[0].index("max_penetration")
    worst = (0., 0.)
    for row in rows[1:]:
        worst = max(worst, (float(row[ratio]), float(row[depth])))
    return worst[0], worst[1] * (1 - 1 / worst[0]) if worst[0] > 1 else 0.


def warnings_of(folder):
    """The program's own warnings, from summary.json."""
    try:
        return json.loads((folder / "summary.json").read_text()).get("warnings", [])
    except (OSError, ValueError):
        return []


def kind_of_warning(text):
    """Its first words, up to a number or a mark."""
    return re.split(r"[:;,.(\d]", text)[0].strip() or text[:40]


def wrong_results(folder):
    """What the files of a run that calls itself done show to be wrong, in a sentence; empty if nothing is."""
    try:
        run = Run(folder)
    except NoRun as error:
        return str(error)
    report = check_run.Report()
    check_run.check_forces(run, report, SHARE)
    check_run.check_energy(run, report)
    thickness = float(run.scene["Blank"]["Thickness"])
    thinnest = min([min(run.history.column("min_thickness"))] +
                   [min(table.column("thickness")) for table in run.tables("profile").values() if len(table)])
    if thinnest < THINNEST * thickness:
        report.wrong.append(f"thinnest: {thinnest:.3g} is left of a thickness of {thickness:g}")
    return "; ".join(report.wrong)


def torn_by(folder):
    """How the sheet of a run that stopped has failed, judged by its files."""
    try:
        return torn.why(Run(folder))
    except NoRun:
        return ""


def shorten(message):
    """The kind of a failure: its message without numbers and names."""
    known = (("forces in", "forces out of balance"), ("of the work are missing", "energy missing"), ("thinnest:", "less than a third of the thickness left"),
             ("iron the sheet", "ironed"),
             ("more than", "slow: increments were still accepted" if "increments" in message else "no increment accepted"),
             ("necks", "necking"),
             ("Maximal increments", "increments used up"), ("promise penetration <= delta", "promise could not be kept, said so"),
             ("round-off", "delta below round-off, refused"), ("tangent is singular", "tangent singular: limit load or free to move"),
             ("did not converge", "Newton did not converge"), ("strain increment", "strain increment too large"),
             ("rotation increment", "rotation increment too large"), ("corrections of the penalty", "corrections did not end"),
             ("cuts", "a tool cuts the blank, refused"), ("never reaches", "travel never reached, refused"))
    for part, kind in known:
        if part in message:
            return kind
    return re.sub(r"[-+]?\d[\d.e+-]*", "#", message)[:90]


def judge(tags, folder, status, said, seconds, limit):
    """The outcome of a run: (kind, message)."""
    lines = said.splitlines()
    # Warnings of the input may stand before the reason why the run stopped.
    message = next((line for line in lines if "stopped at time" in line),
                   next((line for line in lines if "deltaform:" in line or "warning" in line), said.strip()[-300:]))
    if status is None:
        rows = csv_rows(folder / "history.csv")[1:] if (folder / "history.csv").exists() else []
        # The last row may be half written.
        return "hang", f"more than {limit:g} s" + (f"; {rows[-2][0]} increments to time {rows[-2][2]}" if len(rows) > 1 else "")
    if status < 0 or "an error of the program" in said or status not in (0, 1, 2, 3):
        return "crash", f"exit status {status}: {message or said[-200:]}"
    try:
        bad = not_finite(folder) if folder.exists() else None
    except ValueError as error:
        bad = str(error)
    if bad:
        return "NaN in a result", bad
    if status == 1:
        return ("refused", message) if "deltaform:" in said else ("status and message disagree", said[-200:])
    if (folder / "history.csv").exists():
        ratio, beyond = worst_promise(folder)
        # 1e-6 of delta, or some units in the last place of a coordinate (ten digits are printed).
        if ratio > 1 + 1e-6 and beyond > 1e-12 * tags["size"]:
            return "promise broken silently", f"p/delta = {ratio:.9g}"
    summary = json.loads((folder / "summary.json").read_text())
    if summary["exit_status"] != status or (status != 0) != ("stopped at time" in said):
        return "status and message disagree", message
    if status == 0:
        if abs(summary["time"] - 1) > 1e-9:
            return "status and message disagree", "done before the end"
        wrong = wrong_results(folder) if not summary.get("warnings") else ""
        return ("wrong without a word", wrong) if wrong else ("done", "")
    return ("necks" if "necks" in message else "stopped", message)


def run_limited(command, console, limit):
    """Exit status (None: more than limit seconds of processor time), what it said, seconds of processor time.

    Processor time, unlike wall time, does not depend on what else the machine does.
    """
    with open(console, "w") as said:
        process = subprocess.Popen(["prlimit", f"--cpu={math.ceil(limit)}"] + command, stdout=said, stderr=said)
    begin, ended = time.monotonic(), 0
    while not ended:
        time.sleep(.01)
        ended, status, usage = os.wait4(process.pid, os.WNOHANG)
        if not ended and time.monotonic() - begin > 20 * limit:  # it sleeps
            process.kill()
    process.returncode = os.waitstatus_to_exitcode(status)
    said = console.read_text()
    console.unlink()
    overdue = process.returncode in (-signal.SIGXCPU, -signal.SIGKILL)
    return None if overdue else process.returncode, said, usage.ru_utime + usage.ru_stime


def run_one(program, work, seed, limit, interrupt, keep, increments):
    text, tags = draw.draw(seed)
    tags["size"] = max(float(number) for number in re.search(r"Points = 0 0; (\S+)", text).groups())
    scene, folder = work / f"{seed:05d}.prm", work / f"{seed:05d}"
    shutil.rmtree(folder, ignore_errors=True)
    scene.write_text(text)
    command = [program, str(scene), "--quiet", "--output", str(folder)]
    if interrupt:
        command += ["--set", "Output/Checkpoint interval=0"]
    if increments:
        command += ["--set", f"Solver/Maximal increments={increments}"]
    begin = time.monotonic()
    status, said, seconds = run_limited(command, work / f"{seed:05d}.txt", limit)
    seconds_alone = time.monotonic() - begin
    kind, message = judge(tags, folder, status, said, seconds, limit)
    if interrupt and kind in ("done", "stopped", "necks"):
        killed = work / f"{seed:05d}_killed"
        shutil.rmtree(killed, ignore_errors=True)
        again = command[:4] + [str(killed)] + command[5:]
        _, tags["resumed"] = resume.interrupt(again, killed, seconds_alone, 3, random.Random(seed))
        different = resume.compare(folder, killed)
        if different:
            kind, message = "resumed run differs", ", ".join(different)
        elif not keep:
            shutil.rmtree(killed)
    tags["warnings"] = warnings_of(folder)
    if kind == "stopped":
        tags["torn"] = torn_by(folder)
    if not keep and kind not in BAD:
        shutil.rmtree(folder, ignore_errors=True)
        scene.unlink()
    return dict(tags, outcome=kind, message=message, seconds=seconds, status=status)


def summary(results, arguments):
    """Outcomes by group, and sentences about them. @return table, sentences, share of the sensible scenes that completed"""
    seeds = arguments.seeds or f"{arguments.first}-{arguments.first + arguments.count - 1}{', sensible ones' if arguments.sensible else ''}"
    outcomes = ("done", "necks", "stopped", "refused") + BAD
    outcomes = [kind for kind in outcomes if kind not in BAD or kind == "hang" or any(r["outcome"] == kind for r in results)]
    table = MeasuredTable(["seeds", "group", "member", "scenes", *outcomes])

    def add(title, groups):
        for name, members in groups:
            count = collections.Counter(r["outcome"] for r in members)
            table.add(seeds, title, name, len(members), *(count[o] for o in outcomes))

    sensible = [r for r in results if r["sensible"]]
    add("judgement", [("sensible", sensible), ("not sensible", [r for r in results if not r["sensible"]]), ("all", results)])
    add("process", [(k, [r for r in results if r["kind"] == k]) for k in ("drawing", "stretching", "bending")])
    add("material", [(law, [r for r in results if r["law"] == law]) for law in draw.LAWS])
    names = sorted({f for r in results for f in r["features"]})
    add("with", [(f, [r for r in results if f in r["features"]]) for f in names])
    complete = sum(r["outcome"] in ("done", "necks") for r in sensible)
    times = sorted(r["seconds"] for r in results)
    first_rule = [r for r in results if set(r["against"]) <= draw.AFTERWARDS]
    first_complete = sum(r["outcome"] in ("done", "necks") for r in first_rule)
    sentences = [
        f"{complete} of {len(sensible)} sensible scenes completed ({100 * complete / max(1, len(sensible)):.1f} %; aim: 98 %).",
        f"{sum(r['outcome'] in BAD for r in results)} of {len(results)} ended in a way that is never allowed.",
        f"Processor time: median {times[len(times) // 2]:.2f} s, longest {times[-1]:.1f} s; limit {arguments.seconds:g} s.",
        f"Without the {len(draw.AFTERWARDS)} clauses that were added to the rule when a failure had shown what it had forgotten "
        f"({'; '.join(sorted(draw.AFTERWARDS))}): {first_complete} of {len(first_rule)} "
        f"({100 * first_complete / max(1, len(first_rule)):.1f} %)."]
    failed = [r for r in results if r["outcome"] == "necks" or r["outcome"] == "stopped" and (r.get("torn") or "iron the sheet" in r["message"])]
    can = len(results) - len(failed) - sum(r["outcome"] == "refused" for r in results)
    done = sum(r["outcome"] == "done" for r in results)
    sentences.append(f"{len(failed)} sheets neck, are ironed, or stopped when they were torn by the curve of their metal ({sum(bool(r.get('torn')) for r in results)}). "
                     f"Of the others that were not refused {done} of {can} are done ({100 * done / max(1, can):.1f} %; aim: 95 %).")
    resumed = [r for r in results if r.get("resumed")]
    if resumed:
        sentences.append(f"{len(resumed)} scenes were killed at random moments ({sum(r['resumed'] for r in resumed)} times) and resumed; "
                         f"{sum(r['outcome'] == 'resumed run differs' for r in resumed)} of them gave other results than the run left alone.")
    return table, sentences, complete / max(1, len(sensible))


def kinds(results, kinds_of, seeds):
    """How many scenes are of a kind, the commonest first."""
    members_of = collections.defaultdict(list)
    for r in results:
        for kind in kinds_of(r):
            members_of[kind].append(r)
    table = MeasuredTable(["seeds", "kind", "sensible", "others", "scenes (the first eight, sensible ones first)"])
    for kind, members in sorted(members_of.items(), key=lambda item: -len(item[1])):
        count = sum(r["sensible"] for r in members)
        table.add(seeds, kind, count, len(members) - count, first_eight(members))
    return table


def warned(results, seeds):
    """How many scenes that are done carry warnings of the program, by kind. @return table and sentence"""
    done = [r for r in results if r["outcome"] == "done"]
    table = kinds(done, lambda r: {kind_of_warning(text) for text in r.get("warnings", [])}, seeds)
    count = sum(bool(r.get("warnings")) for r in done)
    return table, f"{count} of the {len(done)} scenes that are done carry a warning of the program."


def tell(results, arguments):
    """Prints what came out; --write NAME: into doc/measured/NAME.csv and its companions. @return share of completed sensible scenes"""
    table, sentences, share = summary(results, arguments)
    seeds = table.rows[0][0]
    with_warning, sentence = warned(results, seeds)
    sentences.append(sentence)
    failed = kinds([r for r in results if r["outcome"] != "done"], lambda r: [f"{r['outcome']}: {shorten(r['message'])}"], seeds)
    print("\n\n".join(map(str, (table, with_warning, failed, "\n".join(sentences)))))
    if arguments.write:
        table.write(arguments.write, "outcomes of the scenes drawn at random, by group. " + " ".join(sentences))
        with_warning.write(arguments.write + "_warnings", "scenes that are done with a warning, by kind")
        failed.write(arguments.write + "_failures", "scenes that are not done, by kind")
    return share


def first_eight(members):
    members.sort(key=lambda r: (not r["sensible"], r["seed"]))
    return ", ".join(str(r["seed"]) for r in members[:8])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--seeds", help="these scenes instead: '3,5,8'")
    parser.add_argument("--sensible", action="store_true", help="only the scenes that are to complete")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--resume", type=int, default=0)
    parser.add_argument("--increments", type=int, help="at most; default: as drawn, 400 of scenes that are not sensible")
    parser.add_argument("--share", type=float, default=0, help="of the sensible scenes that has to complete")
    parser.add_argument("--write", metavar="NAME", help="renew doc/measured/NAME.csv, NAME_warnings.csv and NAME_failures.csv")
    parser.add_argument("--again", type=pathlib.Path, help="the tables of an earlier results.jsonl, run nothing")
    parser.add_argument("--keep", action="store_true")
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    print(draw.RULE)
    seeds = list(range(arguments.first, arguments.first + arguments.count))
    if arguments.sensible:
        seeds = [seed for seed in seeds if draw.draw(seed)[1]["sensible"]]
    if arguments.seeds:
        seeds = [int(seed) for seed in arguments.seeds.split(",")]
    if arguments.again:
        results = [json.loads(line) for line in arguments.again.read_text().splitlines()]
        results = [dict(r, **draw.draw(r["seed"])[1]) for r in results]
        results = [r for r in results if r["sensible"] or not arguments.sensible]
        results.sort(key=lambda r: r["seed"])
        if not arguments.sensible:
            arguments.first, arguments.count = results[0]["seed"], len(results)
        tell(results, arguments)
        return 0
    results = []
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool, open(arguments.folder / "results.jsonl", "w") as log:
        futures = [pool.submit(run_one, arguments.program, arguments.folder, seed, arguments.seconds,
                               position < arguments.resume, arguments.keep, arguments.increments) for position, seed in enumerate(seeds)]
        for future in futures:
            r = future.result()
            results.append(r)
            log.write(json.dumps(r) + "\n")
            log.flush()
            if r["outcome"] in BAD or r["sensible"] and r["outcome"] != "done":
                print(f"{r['seed']}: {'sensible, ' if r['sensible'] else ''}{r['outcome']}: {r['message']}", flush=True)
    share = tell(results, arguments)
    return 1 if any(r["outcome"] in BAD for r in results) or share < arguments.share else 0


if __name__ == "__main__":
    sys.exit(main())
