#!/usr/bin/env python3
"""Errors of memory that no result shows: invalid accesses, values that nobody sets, undefined behaviour.

    memory_errors.py sanitizers PROGRAM FOLDER SCENE...   whole scenes; PROGRAM is built with -DDELTAFORM_SANITIZE=ON
    memory_errors.py valgrind   PROGRAM FOLDER SCENE...   the first three increments of each, by Valgrind's memcheck

[--seconds N] ends a scene after N seconds (1800). Errors inside MPI, BLAS and the like, with no function of deltaform on the
stack, are not counted. Exit status 1 if there is one."""
import argparse
import collections
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import time
import xml.etree.ElementTree as ElementTree

INCREMENTS = 3


def run(command, folder, seconds, increments, **settings):
    """Run until the history has so many rows (0: to its end). @return (exit status, what it said)"""
    log = folder.parent / (folder.name + ".txt")
    with open(log, "wb") as said:
        process = subprocess.Popen(command, stdout=said, stderr=subprocess.STDOUT, **settings)
        begin = time.monotonic()
        while process.poll() is None:
            history = folder / "history.csv"
            rows = sum(not line.startswith("#") for line in history.open()) - 1 if history.exists() else 0
            if time.monotonic() - begin > seconds or 0 < increments <= rows:
                process.send_signal(signal.SIGTERM)  # the increment is finished and the state saved
                break
            time.sleep(.2)
        try:
            status = process.wait(timeout=600)
        except subprocess.TimeoutExpired:
            process.kill()
            status = process.wait()
    return status, log.read_text(errors="replace")


def by_sanitizers(program, scene, folder, seconds):
    """Kinds of errors and how often."""
    errors = collections.Counter()
    settings = {"env": dict(os.environ, ASAN_OPTIONS="detect_leaks=0", UBSAN_OPTIONS="print_stacktrace=1")}
    status, said = run([program, scene, "--output", folder, "--force", "--quiet"], folder, seconds, 0, **settings)
    errors.update(re.findall(r"AddressSanitizer: ([\w-]+)", said))
    errors.update(re.findall(r"^(\S+: runtime error: .*)$", said, re.M))
    return status, errors


def by_valgrind(program, scene, folder, seconds):
    """Kinds of errors with the innermost function of deltaform, and how often."""
    report = folder.parent / (folder.name + ".xml")
    status, _ = run(["valgrind", "--tool=memcheck", "--track-origins=no", "--num-callers=40", "--xml=yes", f"--xml-file={report}",
                     program, scene, "--output", folder, "--force", "--quiet"], folder, seconds, INCREMENTS)
    errors = collections.Counter()
    for error in ElementTree.parse(report).getroot().iter("error"):
        own = [frame.findtext("fn") for frame in error.iter("frame") if "deltaform::" in (frame.findtext("fn") or "")]
        if own and not error.findtext("kind").startswith("Leak"):
            errors[f"{error.findtext('kind')} in {own[0]}"] += 1
    return status, errors


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("by", choices=["sanitizers", "valgrind"])
    parser.add_argument("program")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("scenes", nargs="+", metavar="SCENE")
    parser.add_argument("--seconds", type=float, default=1800)
    options = parser.parse_args()
    shutil.rmtree(options.folder, ignore_errors=True)
    options.folder.mkdir(parents=True)

    judge = by_sanitizers if options.by == "sanitizers" else by_valgrind
    ends, found = collections.Counter(), 0
    for scene in options.scenes:
        status, errors = judge(options.program, scene, options.folder / pathlib.Path(scene).stem, options.seconds)
        ends[status] += 1
        found += sum(errors.values())
        print(f"{scene}: exit status {status}, {sum(errors.values())} errors", flush=True)
        for error, times in errors.most_common(10):
            print(f"  {times} x {error}")
    listed = ", ".join(f"{times} x {status}" for status, times in sorted(ends.items()))
    print(f"{len(options.scenes)} scenes, exit statuses {listed}: {found} errors")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
