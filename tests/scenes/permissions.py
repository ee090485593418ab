#!/usr/bin/env python3
"""Files and folders that may not be read or written: permissions.py PROGRAM CUP_SCENE. Each is a sentence with the name.

Root may do everything, so the program is then run as nobody."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

program, cup = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
someone_else = {"user": 65534, "group": 65534, "extra_groups": []} if os.geteuid() == 0 else {}
failures = 0


def expect(status, message, *words):
    global failures
    done = subprocess.run([program, *map(str, words), "--quiet"], capture_output=True, encoding="utf-8", timeout=60,
                          cwd=work, **someone_else)
    said = done.stdout + done.stderr
    if done.returncode != status or message not in said or "error of the program" in said:
        failures += 1
        print(f"{' '.join(map(str, words))}: exit status {done.returncode}, expected {status} and '{message}'; it said\n{said}")


# Not below the folder of the build, which may be closed to nobody; for the same reason the program is copied.
work = pathlib.Path(tempfile.mkdtemp(prefix="deltaform_permissions_"))
try:
    work.chmod(0o777)
    program = shutil.copy(program, work / "deltaform")
    scene = work / "cup.prm"
    shutil.copy(cup, scene)
    scene.chmod(0o644)
    short = ["--set", "Steps/form/End time=.02"]
    longer = ["--set", "Steps/form/End time=.03"]

    closed = work / "closed"
    closed.mkdir()
    closed.chmod(0o555)
    expect(1, "Cannot make the folder 'closed/inside'", scene, "--output", "closed/inside", *short)
    expect(1, "The folder 'closed' cannot be written ('closed/deltaform.lock'): Permission denied. Choose another with --output", scene, "--output", "closed", *short)
    expect(1, "'closed", "sweep", scene, "--vary", "Contact/Allowed penetration=1e-3", "--output", "closed/sweep", *short)

    expect(0, "", scene, "--output", "run", *short)
    for name, message in (("checkpoint.bin", "checkpoint.bin' cannot be read"), ("history.csv", "history.csv' cannot be read")):
        file = work / "run" / name
        mode = file.stat().st_mode
        file.chmod(0)
        expect(1, message, scene, "--output", "run", "--resume", *longer)
        file.chmod(mode)
    expect(0, "", scene, "--output", "run", "--resume", *longer)

    scene.chmod(0)
    expect(1, "cup.prm: cannot be read: Permission denied", scene, "--check")
finally:
    shutil.rmtree(work, ignore_errors=True)
sys.exit(failures != 0)
