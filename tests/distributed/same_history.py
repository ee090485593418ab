"""Runs a scene with several numbers of processes, linear solvers or linear paths, and compares their histories.

    same_history.py PROGRAM SCENE FOLDER --launcher MPIRUN [--np 1,2,4] [--solvers "klu,cg amg"] [--paths off,automatic]
                    [--tolerance 1e-8] [--factorizations N] [--ignore COLUMN,...] [--set ENTRY=VALUE]...

Every number may differ from that of the first run by the tolerance times the largest of its column (an error of energies or forces:
by the tolerance). Costs (iterations of linear solvers) are not compared. With --factorizations, the last run
must have needed that many. The comparison must be able to say no: a change of one number by ten times the tolerance
has to be found.
"""
import copy
import itertools
import math
import os
import re
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "scripts"))
from csv_file import rows_of
from launched import launch, parser_of


def history(folder):
    return rows_of(os.path.join(folder, "history.csv"))


def factorizations(folder):
    with open(os.path.join(folder, "run.log")) as file:
        return int(re.search(r"(\d+) factorizations", file.read()).group(1))


def difference(first, other, tolerance, ignored=()):
    """The first difference in words, or None."""
    if len(first) != len(other):
        return "%d increments and %d" % (len(first), len(other))
    for column in first[0]:
        if column in ("linear_iterations", "stage", *ignored):
            continue
        numbers = [abs(float(row[column])) for row in first if row[column]]
        # An error of the energy is relative already.
        scale = 1. if column in ("energy_error", "balance_error") else max(numbers, default=0.)
        for a, b in zip(first, other):
            if a[column] == b[column]:  # also if both are empty: not known yet
                continue
            if not (a[column] and b[column]) or not abs(float(a[column]) - float(b[column])) <= tolerance * scale:
                return "increment %s, %s: %s and %s" % (a["increment"], column, a[column], b[column])
    return None


def main():
    parser = parser_of(__doc__)
    parser.add_argument("--np", default="1,2")
    parser.add_argument("--solvers", default="")
    parser.add_argument("--paths", default="")
    parser.add_argument("--factorizations", type=int)
    parser.add_argument("--ignore", default="")
    parser.add_argument("--tolerance", type=float, default=1e-8)
    parser.add_argument("--set", action="append", default=[])
    arguments = parser.parse_args()

    histories = []
    ignored = arguments.ignore.split(",")
    for solver, path, processes in itertools.product(arguments.solvers.split(","), arguments.paths.split(","),
                                                     arguments.np.split(",")):
        name = "_".join([solver or "scene", path, processes] if path else [solver or "scene", processes])
        folder = os.path.join(arguments.folder, name.replace(" ", "_"))
        sets = arguments.set + ["Solver/%s=%s" % entry for entry in (("Linear solver", solver), ("Linear path", path))
                                  if entry[1]]
        status = launch(arguments, processes, ["--quiet", "--output", folder], sets).returncode
        if status != 0:
            sys.exit("exit status %d in %s" % (status, folder))
        histories.append((folder, history(folder)))

    name, first = histories[0]
    wrong = copy.deepcopy(first)
    column = next(c for c in wrong[-1] if c.endswith("_force_z"))
    wrong[-1][column] = repr(float(wrong[-1][column]) +
                             10 * arguments.tolerance * max(abs(float(row[column])) for row in first))
    if difference(first, wrong, arguments.tolerance) is None:
        sys.exit("the comparison finds nothing: there is no force in " + name)
    for other, rows in histories[1:]:
        found = difference(first, rows, arguments.tolerance, ignored)
        if found:
            sys.exit("%s and %s differ: %s" % (name, other, found))
    if arguments.factorizations is not None and factorizations(histories[-1][0]) != arguments.factorizations:
        sys.exit("%s needed %d factorizations" % (histories[-1][0], factorizations(histories[-1][0])))
    print("%d histories of %d increments agree to %g" % (len(histories), len(first), arguments.tolerance))


if __name__ == "__main__":
    main()
