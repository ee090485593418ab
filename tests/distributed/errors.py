"""An error ends all processes, with one message and its exit status: errors.py PROGRAM SCENE FOLDER --launcher MPIRUN

Once an error that all processes find (a misspelt entry), once one that only the first can meet while the others go on (its
history cannot be written).
"""
import argparse
import os
import shutil
import subprocess
import sys


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("scene")
    parser.add_argument("folder")
    parser.add_argument("--launcher", required=True)
    arguments = parser.parse_args()
    shutil.rmtree(arguments.folder, ignore_errors=True)
    os.makedirs(os.path.join(arguments.folder, "history.csv"))

    environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    for sets, wanted in ((["Blank/Thicknes=1"], "Thicknes"), ([], "history.csv")):
        command = [arguments.launcher, "-np", "2", "--oversubscribe", arguments.program, arguments.scene, "--quiet"]
        command += ["--output", arguments.folder]
        for entry in sets:
            command += ["--set", entry]
        result = subprocess.run(command, env=environment, stderr=subprocess.PIPE, text=True, timeout=120)
        messages = [line for line in result.stderr.splitlines() if wanted in line]
        if result.returncode != 1:
            sys.exit("exit status %d instead of 1:\n%s" % (result.returncode, result.stderr))
        if len(messages) != 1:
            sys.exit("%d messages instead of one:\n%s" % (len(messages), result.stderr))


if __name__ == "__main__":
    main()
