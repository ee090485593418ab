#!/usr/bin/env python3
"""Signals, pipes without a reader, limits of files, and a folder with an owner: interrupted.py PROGRAM CUP_SCENE FOLDER.

What is interrupted says so, ends with 128 + signal, leaves whole files only, and goes on to the bytes of a run that was
left alone. What is refused changes nothing in the folder."""
import contextlib
import hashlib
import json
import os
import pathlib
import resource
import shutil
import signal
import subprocess
import sys
import time

from resume import compare, saved

program, scene, work = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
shutil.rmtree(work, ignore_errors=True)
work.mkdir(parents=True)
quick = ["--set", "Blank/Elements=60", "--set", "Output/Pictures=5"]
failures = 0


def check(right, sentence):
    global failures
    if not right:
        failures += 1
        print(sentence)


def start(folder, *options, **how):
    return subprocess.Popen([program, scene, *quick, "--output", str(folder), *options], stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT, **how)


def run(folder, *options, **how):
    process = start(folder, *options, **how)
    said = process.communicate()[0].decode()
    return process.returncode, said


def until_rows(folder, n):
    """Wait until the history has this many rows."""
    for _ in range(2000):
        with contextlib.suppress(FileNotFoundError):
            if (folder / "history.csv").read_bytes().count(b"\n") > n + 5:
                return
        time.sleep(.005)


def state_of(folder):
    """Every file of a folder with its bytes and its date."""
    return {path.name: (hashlib.sha256(path.read_bytes()).hexdigest() if path.is_file() else "", path.stat().st_mtime_ns)
            for path in sorted(folder.iterdir())}


def whole(folder, what):
    """No drafts, no half rows, no lock."""
    names = [path.name for path in folder.iterdir()]
    check(not [name for name in names if name.endswith(".part")], f"{what}: drafts stay behind: {names}")
    check("deltaform.lock" not in names, f"{what}: the lock stays behind")
    for table in folder.glob("*.csv"):
        content = table.read_text()
        check(content == "" or content.endswith("\n"), f"{what}: {table.name} ends with half a row")
        rows = [line for line in content.splitlines() if not line.startswith("#")]
        check(len({row.count(",") for row in rows}) <= 1, f"{what}: {table.name} has rows of several lengths")


alone = work / "alone"
check(run(alone)[0] == 0, "the run that is left alone is not done")

for number in (signal.SIGINT, signal.SIGTERM, signal.SIGPIPE, signal.SIGXFSZ):
    folder = work / number.name
    process = start(folder)
    until_rows(folder, 5)
    process.send_signal(number)
    said = process.communicate()[0].decode()
    check(process.returncode == 128 + number, f"{number.name}: exit status {process.returncode}")
    check(f"ended by signal {int(number)} (" in said and "--resume" in said, f"{number.name}: it said\n{said}")
    whole(folder, number.name)
    summary = json.loads((folder / "summary.json").read_text())
    check(summary["exit_status"] == 128 + number and summary["outcome"] == "interrupted",
          f"{number.name}: summary {summary['exit_status']}, {summary['outcome']}")
    check(run(folder, "--resume")[0] == 0, f"{number.name}: not done after --resume")
    check(not compare(alone, folder), f"{number.name}: after --resume differ {compare(alone, folder)}")

# Nobody reads what is printed.
folder = work / "no_reader"
process = start(folder, bufsize=0)
process.stdout.read(1)
process.stdout.close()
check(process.wait() == 128 + signal.SIGPIPE, f"a pipe without a reader: exit status {process.returncode}")
check(run(folder, "--resume")[0] == 0 and not compare(alone, folder), "a pipe without a reader: not as left alone")

# A file may have so many bytes; with the signal, and without it as on a full disk (write() fails).
for ignored in (False, True):
    what = "a full disk" if ignored else "a limit of files"
    for n_bytes in (100, 10000, 60000):
        folder = work / f"limit_{n_bytes}_{ignored}"
        def limit():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN if ignored else signal.SIG_DFL)
            resource.setrlimit(resource.RLIMIT_FSIZE, (n_bytes, n_bytes))
        status, said = run(folder, "--set", "Output/Checkpoint interval=0", preexec_fn=limit)
        check(status == (1 if ignored else 128 + signal.SIGXFSZ), f"{what}, {n_bytes}: exit status {status}\n{said}")
        check("Cannot write '" in said and "File too large" in said, f"{what}, {n_bytes}: it said\n{said}")
        check("error of the program" not in said, f"{what}, {n_bytes}: it said\n{said}")
        whole(folder, f"{what}, {n_bytes}")
        if n_bytes == 60000:
            check("the run ends: Cannot write" in (folder / "run.log").read_text(), f"{what}: run.log does not say why")
            check(run(folder, "--resume")[0] == 0 and not compare(alone, folder), f"{what}: resumed, not as left alone")

# The folder has an owner.
folder = work / "owned"
process = start(folder)
until_rows(folder, 2)
process.send_signal(signal.SIGSTOP)  # else it may be done before the others have started
for options in ((), ("--resume",)):
    status, said = run(folder, *options)
    check(status == 1 and f"in use by process {process.pid} on " in said and "--force" in said,
          f"a second run: exit status {status}, it said\n{said}")
process.kill()
process.communicate()
check((folder / "deltaform.lock").exists(), "a killed run leaves no lock: nothing is tested")
check(run(folder, "--resume")[0] == 0 and not compare(alone, folder), "a lock of a killed run is not recognized")

# A refused --resume changes nothing.
folder = work / "refused"
run(folder, "--set", "Solver/Maximal increments=12")
elsewhere = "process 1 on another.machine\n"
few = ["--resume", "--set", "Solver/Maximal increments=12"]
history = (folder / "history.csv").read_text()
lines = history.splitlines(keepends=True)
checkpoint = (folder / "checkpoint.bin").read_bytes()


def refused(message, *options):
    before = state_of(folder)
    status, said = run(folder, *options)
    check(status == 1 and message in said, f"expected '{message}', exit status {status}, it said\n{said}")
    now = state_of(folder)
    check(now == before, f"'{message}': these have changed: {[n for n in now if now[n] != before.get(n)]}")


refused("was 60 when the run was saved", "--resume", "--set", "Blank/Elements=61")
(folder / "history.csv").write_text("".join(lines[:-2]))
refused("ends at increment 10: its other rows were lost", *few)
(folder / "history.csv").write_text(history.replace("max_epsilon", "other_column"))
refused("'other_column' is only in the file", *few)
(folder / "history.csv").unlink()
refused("cannot be read", *few)
(folder / "history.csv").write_text(history)
(folder / "deltaform.lock").write_text(elsewhere)
refused("belongs to process 1 on another.machine", *few)
(folder / "deltaform.lock").unlink()
series = (folder / "scene.pvd").read_text() if (folder / "scene.pvd").exists() else ""
(folder / "scene.pvd").write_text("<VTKFile")
refused("Cannot resume the series of pictures", *few)
(folder / "scene.pvd").write_text(series)
os.remove(folder / "checkpoint.bin")
(folder / "checkpoint.bin").mkdir()
refused("cannot be read", *few)
(folder / "checkpoint.bin").rmdir()
(folder / "checkpoint.bin").write_bytes(checkpoint)
status, said = run(folder, "--resume")
check(status == 0, f"after all that was refused: exit status {status}\n{said}")


def columns(path):
    return [line for line in path.read_text().splitlines() if not line.startswith("#")]


# Columns of a history stay; what is not asked for any more is empty, what is new is left out.
for name, first, then, note in (
        ("energies_off", "true", "false", "resumed with a change: Output/Energies"),
        ("energies_on", "false", "true", "Output/Energies stays false")):
    folder = work / name
    run(folder, "--set", "Solver/Maximal increments=12", "--set", f"Output/Energies={first}")
    before = columns(folder / "history.csv")
    status, said = run(folder, "--resume", "--set", f"Output/Energies={then}")
    after = columns(folder / "history.csv")
    check(status == 0 and note in said, f"{name}: exit status {status}, it said\n{said}")
    check(after[:len(before)] == before and len(after) > len(before), f"{name}: rows from before have changed")
    check(len({row.count(",") for row in after}) == 1, f"{name}: rows of several lengths")
    if first == "true":
        place = after[0].split(",").index("tool_work")
        check(before[-1].split(",")[place] != "" and after[-1].split(",")[place] == "", f"{name}: tool_work is not empty")
folder = work / "conditions"
run(folder, "--set", "Solver/Maximal increments=12")
before = columns(folder / "history.csv")
status, said = run(folder, "--resume", "--set", "Output/Condition number every=5")
check(status == 0 and "history.csv keeps its columns, so that these are not written: condition_raw" in said,
      f"condition numbers: exit status {status}, it said\n{said}")
check(columns(folder / "history.csv")[:len(before)] == before, "condition numbers: rows from before have changed")

# A sweep takes its runs along, which last some seconds.
folder = work / "sweep"
sweep = subprocess.Popen([program, "sweep", scene, *quick, "--set", "Blank/Elements=400", "--output", str(folder), "--jobs", "2", "--vary",
                          "Contact/Allowed penetration=1e-4,2e-4,3e-4,4e-4"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
until_rows(folder / "run_001", 3)
sweep.send_signal(signal.SIGTERM)
said = sweep.communicate()[0].decode()
check(sweep.returncode == 128 + signal.SIGTERM, f"sweep: exit status {sweep.returncode}")
check("2 runs were not started" in said, f"sweep: it said\n{said}")
rows = columns(folder / "sweep.csv")
check(len(rows) == 3 and all(",143,interrupted," in row for row in rows[1:]), f"sweep: its table is {rows}")
for k in (1, 2):
    check((folder / f"run_00{k}" / "checkpoint.bin").exists(), f"sweep: run {k} has not saved its state")
check(saved(folder / "run_003") is None, "sweep: a third run was started")
sys.exit(1 if failures else 0)
