#!/usr/bin/env python3
"""Kill a run at random moments, resume it, and compare every result with that of a run that was left alone.

A run that ended by itself is resumed as well: it ends again, and leaves the same.

    resume.py PROGRAM SCENE FOLDER [--seed N] [--kills N] [--launcher MPIRUN --np N] [--set ENTRY=VALUE]...

All files are compared byte by byte, but for those that contain wall times (run.log, timing.json, the seconds of
summary.json) and the saved state itself. Exit status 1 if a file differs, or if no kill hit a run that had something to
resume from: then nothing was tested.
"""
import argparse
import contextlib
import json
import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import time


def results(folder):
    """Name -> bytes of everything that must not depend on interruptions."""
    found = {}
    for path in sorted(folder.iterdir()):
        if path.name in ("run.log", "timing.json", "checkpoint.bin", "scene.prm") or path.suffix == ".part":
            continue
        found[path.name] = path.read_bytes()
    if "summary.json" in found:
        summary = json.loads(found["summary.json"])
        summary.pop("seconds")
        found["summary.json"] = json.dumps(summary).encode()
    return found


def compare(one, other):
    """Names of the files that differ."""
    a, b = results(one), results(other)
    return [name for name in sorted(a.keys() | b.keys()) if a.get(name) != b.get(name)]


def saved(folder):
    """When the state in a folder was saved, None if there is none."""
    try:
        return (folder / "checkpoint.bin").stat().st_mtime_ns
    except FileNotFoundError:
        return None


def kill(process):
    """With all that it has started: of mpirun, the program itself."""
    family = [process.pid]
    for pid in family:
        for children in pathlib.Path("/proc/%d/task" % pid).glob("*/children"):
            with contextlib.suppress(OSError):
                family += map(int, children.read_text().split())
    for pid in family:
        with contextlib.suppress(ProcessLookupError):
            os.kill(pid, signal.SIGKILL)


def interrupt(command, folder, span, kills, chance):
    """Run and kill until the run ends by itself. Returns its status and how many kills left something to resume.

    Every other kill waits for the run's first saved state: of a short run most of the time is start-up.
    """
    resumable = 0
    for attempt in range(kills + 1):
        options, before = ["--resume"] if attempt else [], saved(folder)
        process = subprocess.Popen(command + options, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        if attempt < kills:
            if attempt % 2 == 0:
                while process.poll() is None and saved(folder) == before:
                    time.sleep(5e-4)
                time.sleep(chance.choice((0., chance.uniform(0., .3) * span)))
            else:
                time.sleep(chance.uniform(.1, 1.) * span)
            kill(process)
        status = process.wait()
        if status >= 0:
            return status, resumable
        resumable += saved(folder) is not None
    raise AssertionError("the last attempt is not killed")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("scene")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--kills", type=int, default=4)
    parser.add_argument("--launcher")
    parser.add_argument("--np", default="2")
    parser.add_argument("--set", action="append", default=[])
    arguments = parser.parse_args()

    shutil.rmtree(arguments.folder, ignore_errors=True)
    arguments.folder.mkdir(parents=True)
    alone, killed = arguments.folder / "alone", arguments.folder / "killed"
    os.environ.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    command = [arguments.launcher, "-np", arguments.np, "--oversubscribe"] if arguments.launcher else []
    command += [arguments.program, arguments.scene, "--quiet", "--set", "Output/Checkpoint interval=0"]
    for entry in arguments.set:
        command += ["--set", entry]
    begin = time.monotonic()
    expected = subprocess.run(command + ["--output", str(alone)], stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL).returncode
    span = time.monotonic() - begin
    shutil.copytree(alone, killed)
    status = subprocess.run(command + ["--output", str(killed), "--resume"], stdout=subprocess.DEVNULL,
                            stderr=subprocess.DEVNULL).returncode
    different = compare(alone, killed)
    if status != expected or different:
        print(f"resumed at its end: exit status {status}, alone {expected}; different: {', '.join(different) or 'nothing'}")
        return 1
    chance, resumable = random.Random(arguments.seed), 0
    for trial in range(20):
        shutil.rmtree(killed, ignore_errors=True)
        status, hits = interrupt(command + ["--output", str(killed)], killed, span, arguments.kills, chance)
        resumable += hits
        different = compare(alone, killed)
        if status != expected or different:
            print(f"exit status {status}, alone {expected}; different: {', '.join(different) or 'nothing'}")
            return 1
        if resumable >= arguments.kills:
            break
    print(f"{resumable} kills resumed, {trial + 1} runs, all results identical, exit status {expected}")
    return 0 if resumable > 0 else 1


if __name__ == "__main__":
    sys.exit(main())
