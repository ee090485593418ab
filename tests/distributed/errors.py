"""An error ends all processes, with one message and its exit status: errors.py PROGRAM SCENE FOLDER --launcher MPIRUN

Once an error that all processes find (a misspelt entry), once one that only the first can meet while the others go on
(its history cannot be written).
"""
import os
import shutil
import subprocess
import sys

from launched import launch, parser_of


def main():
    arguments = parser_of(__doc__).parse_args()
    shutil.rmtree(arguments.folder, ignore_errors=True)
    os.makedirs(os.path.join(arguments.folder, "history.csv"))

    for sets, wanted in ((["Blank/Thicknes=1"], "Thicknes"), ([], "history.csv")):
        result = launch(arguments, 2, ["--quiet", "--output", arguments.folder], sets, timeout=120,
                        stderr=subprocess.PIPE)
        messages = [line for line in result.stderr.splitlines() if wanted in line]
        if result.returncode != 1:
            sys.exit("exit status %d instead of 1:\n%s" % (result.returncode, result.stderr))
        if len(messages) != 1:
            sys.exit("%d messages instead of one:\n%s" % (len(messages), result.stderr))


if __name__ == "__main__":
    main()
