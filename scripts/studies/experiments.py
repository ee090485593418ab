"""Runs of deltaform for the scripts that measure: one call per run, and what came out."""
import json
import math
import os
import re
import subprocess
import sys
import tempfile

from measured import ROOT
from results import NoResults, Table


class Outcome:
    """What a run has left: status, history, profiles, seconds of computing, numbers of iterations and unknowns."""

    def __init__(self, folder, status, message):
        self.status, self.message = status, message
        self.history, self.profiles, self.contacts = None, {}, {}
        try:
            self.history = Table(os.path.join(folder, "history.csv"))
            for name in os.listdir(folder):
                for kind, tables in (("profile", self.profiles), ("contact", self.contacts)):
                    match = re.fullmatch(kind + r"_([-+.\de]+)\.csv", name)  # of a travel; others name a stage as well
                    if match:
                        tables[float(match.group(1))] = Table(os.path.join(folder, name))
            with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
                summary = json.load(file)
            with open(os.path.join(folder, "timing.json"), encoding="utf-8") as file:
                self.seconds = json.load(file)["total"]
        except (NoResults, OSError):
            self.status = self.status or 1
            return
        self.unknowns = summary["unknowns"]
        self.increments = summary["increments"]
        self.iterations = summary["newton_iterations"]
        self.cutbacks = summary["cutbacks"]

    @property
    def done(self):
        return self.status == 0

    def at(self, column, place, over):
        """A column of the history where the column @p over has the value @p place."""
        row = min(range(len(self.history)), key=lambda i: abs(self.history[over][i] - place))
        if abs(self.history[over][row] - place) > 1e-6 * max(abs(place), 1.):
            raise NoResults(f"the history has no row with {over} = {place}")
        return self.history[column][row]


class Program:
    """deltaform, to be called with a scene and entries "Section/Entry=value". The same run is done once only."""

    def __init__(self, path, limit=300., short=0.):
        """@p limit: seconds after which a run is given up; runs shorter than @p short are timed three times, the least counts."""
        self.path, self.limit, self.short = os.path.abspath(path), limit, short
        self.known, self.seconds = {}, 0.
        if not os.access(self.path, os.X_OK):
            sys.exit(f"there is no program '{path}': scripts/build.sh makes it")

    def __call__(self, scene, *entries):
        key = (scene, *entries)
        if key not in self.known:
            outcome = self._run(scene, entries)
            if outcome.done and outcome.seconds < self.short:
                outcome.seconds = min([outcome.seconds] + [self._run(scene, entries).seconds for _ in range(2)])
            self.known[key] = outcome
        return self.known[key]

    def _run(self, scene, entries):
        with tempfile.TemporaryDirectory() as folder:
            command = [self.path, os.path.join(ROOT, "prm", scene + ".prm"), "--quiet", "--output", folder,
                       "--set", "Output/Pictures=0", *(word for entry in entries for word in ("--set", entry))]
            try:
                run = subprocess.run(command, capture_output=True, text=True, timeout=self.limit, check=False)
            except subprocess.TimeoutExpired:
                print(f"{scene} {entries}: not done after {self.limit:g} s", file=sys.stderr)
                return Outcome(folder, 1, "too long")
            if run.returncode != 0:
                print(f"{scene} {entries}: status {run.returncode}\n{run.stderr}", file=sys.stderr)
            outcome = Outcome(folder, run.returncode, run.stderr.strip())
            self.seconds += getattr(outcome, "seconds", 0.)
            return outcome


def uniform(stage, begin, end, n):
    """Entries that make n equal increments of a stage."""
    size = (end - begin) / n
    return [f"Steps/{stage}/First increment={size:.12g}", f"Steps/{stage}/Largest increment={size:.12g}",
            "Solver/Target iterations=1000"]


def orders(sizes, errors, floor=0.):
    """Cells 'error (observed order)': the exponent of 1/size between a row and the one before, above a floor."""
    cells, before = [], None
    for size, error in zip(sizes, errors):
        if error is None:
            cells.append("failed")
        elif before is None or min(abs(before[1]), abs(error)) <= floor:
            cells.append(f"{error:.1e}")
        else:
            cells.append(f"{error:.1e} ({math.log(abs(before[1] / error)) / math.log(size / before[0]):.1f})")
        before = None if error is None else (size, error)
    return cells
