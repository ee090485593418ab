"""Where contact points are left open, several processes touch at the nodes and say so: contact_points.py PROGRAM SCENE FOLDER --launcher MPIRUN"""
import argparse
import os
import subprocess
import sys


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("scene")
    parser.add_argument("folder")
    parser.add_argument("--launcher", required=True)
    arguments = parser.parse_args()

    environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    for processes, entries, wanted in ((1, [], 0), (2, [], 1), (2, ["Blank/Contact points=nodes"], 0)):
        command = [arguments.launcher, "-np", str(processes), "--oversubscribe", arguments.program, arguments.scene, "--check"]
        for entry in entries:
            command += ["--set", entry]
        result = subprocess.run(command, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=120)
        said = result.stdout.count("several processes share the solid, and it touches at its nodes")
        if result.returncode != 0 or said != wanted:
            sys.exit(f"{processes} processes, {entries}: status {result.returncode}, said {said} times instead of {wanted}:\n{result.stdout}")


if __name__ == "__main__":
    main()
