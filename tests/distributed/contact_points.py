"""Where contact points are left open, several processes touch at the nodes and say so.

    contact_points.py PROGRAM SCENE FOLDER --launcher MPIRUN
"""
import subprocess
import sys

from launched import launch, parser_of


def main():
    arguments = parser_of(__doc__).parse_args()
    for processes, entries, wanted in ((1, [], 0), (2, [], 1), (2, ["Blank/Contact points=nodes"], 0)):
        result = launch(arguments, processes, ["--check"], entries, timeout=120,
                        stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        said = result.stdout.count("several processes share the solid, and it touches at its nodes")
        if result.returncode != 0 or said != wanted:
            sys.exit(f"{processes} processes, {entries}: status {result.returncode}, "
                     f"said {said} times instead of {wanted}:\n{result.stdout}")


if __name__ == "__main__":
    main()
