#!/usr/bin/env python3
"""What may change when a run is resumed, what may not, and what is said: resume_rules.py PROGRAM CUP_SCENE FOLDER."""
import json
import pathlib
import re
import shutil
import subprocess
import sys

program, scene, folder = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
shutil.rmtree(folder, ignore_errors=True)
failures = 0


def run(status, message, *options, where=folder):
    """Run the scene with options; check exit status and part of what it says."""
    global failures
    done = subprocess.run([program, scene, "--output", str(where), *options], capture_output=True, text=True)
    said = done.stdout + done.stderr
    if done.returncode != status or message not in said:
        failures += 1
        print(f"{' '.join(options)}: exit status {done.returncode}, expected {status} and '{message}'; it said:\n{said}")


def rows(where=folder):
    lines = [line for line in (where / "history.csv").read_text().splitlines() if not line.startswith("#")]
    return lines[1:]


few = ["--set", "Blank/Elements=25", "--set", "Output/Pictures=0"]
stop = ["--set", "Steps/form/Smallest increment=1e-3", "--set", "Solver/Maximal corrections=0"]
run(0, "no saved state", *few, "--resume")
before = (folder / "history.csv").read_bytes()
for lost in (None, b"x\n"):
    (folder / "history.csv").unlink()
    if lost:
        (folder / "history.csv").write_bytes(lost)
    run(1, "Start again without --resume.", *few, "--resume", "--set", "Steps/form/End time=1.001")
    (folder / "history.csv").write_bytes(before)
run(0, "is finished", *few, "--resume")
if (folder / "history.csv").read_bytes() != before:
    failures += 1
    print("the history of a finished run was changed")

# A run that broke its promise goes on with more corrections, with another delta, but not with another blank.
run(3, "the promise", *few, *stop)
kept = rows()
run(1, "Blank/Elements = 30: was 25", "--set", "Blank/Elements=30", "--resume")
run(1, "Tools/punch/Radius = 0.9: was 1", *few, "--set", "Tools/punch/Radius=0.9", "--resume")
run(1, "Contact/Enforcement", *few, "--set", "Contact/Enforcement=active set", "--resume")
run(0, "resumed with a change: Contact/Allowed penetration was 1e-3*thickness, is now 1e-4", *few, "--set",
    "Contact/Allowed penetration=1e-4", "--resume")
if rows()[:len(kept)] != kept or len(rows()) <= len(kept):
    failures += 1
    print("the rows of before are not those of the resumed run")
# A longer stroke.
run(0, "resumed after increment", *few, "--set", "Contact/Allowed penetration=1e-4", "--set", "Steps/form/End time=1.05",
    "--resume")
run(1, "Cannot resume: the saved state at time 1.05", *few, "--set", "Steps/Stages=form, release", "--set",
    "Steps/form/End time=0.5", "--set", "Steps/release/End time=1.2", "--resume")

# Out of increments, then allowed more: the rows are those of a run that was never stopped.
short, straight = folder / "short", folder / "straight"
run(0, "results in", *few, where=straight)
run(2, "20 increments are done (Solver/Maximal increments)", *few, "--set", "Solver/Maximal increments=20", where=short)
# Nobody goes back in time; what had stopped is not called finished, unless it stopped just where it is now to end.
earlier = ["--set", "Steps/form/End time=0.1", "--resume"]
run(1, "after the end 0.1 that the scene asks for (Steps); the run had stopped there with status 2", *few, *earlier,
    where=short)
run(0, "is finished, at time 1, after the end 0.1", *few, *earlier, where=straight)
copy = folder / "copy"
shutil.copytree(short, copy)
stopped_at = json.loads((copy / "summary.json").read_text())["time"]
run(0, "resumed after increment 20", *few, "--set", f"Steps/form/End time={stopped_at}", "--resume", where=copy)
run(0, "resumed after increment 20", *few, "--resume", where=short)
if rows(short) != rows(straight):
    failures += 1
    print("a run that was resumed when its increments were used up differs from one that was not stopped")

# A sheet that has torn is torn still: nothing is computed, unless the run is to go on after necking. With so much friction it
# tears after a stroke of 1.0.
torn = folder / "torn"
slippery = [option for tool in ("punch", "die", "holder")
            for option in ("--set", f"Tools/{tool}/Friction coefficient=0.5")] + ["--set", "Steps/form/End time=1.1"]
run(2, "the sheet tears", *slippery, where=torn)
kept = rows(torn)
run(2, "the sheet tears", *slippery, "--resume", where=torn)
if rows(torn) != kept:
    failures += 1
    print("a run whose sheet had torn went on when it was resumed")
run(0, "results in", *slippery, "--set", "Steps/form/Continue after necking=true", "--resume", where=torn)

state = folder / "checkpoint.bin"
content = bytearray(state.read_bytes())
content[len(content) // 2] ^= 1
state.write_bytes(content)
run(1, "is damaged", *few, "--resume")
state.write_bytes(state.read_bytes()[:100])
run(1, "is damaged", *few, "--resume")
state.write_bytes(bytes(content).replace(b"deltaform ", b"deltaform 9.", 1))
run(1, "written by another version (deltaform 9.", *few, "--resume")
state.write_bytes(re.sub(rb"checkpoint, layout [0-9]+,", b"checkpoint", bytes(content), count=1))
run(1, "written by another version (an earlier deltaform ", *few, "--resume")
sys.exit(1 if failures else 0)
