"""Reads the output folder of a run: its tables, with names and units of their columns."""
import csv
import glob
import os
import re

import numpy as np


class NoResults(Exception):
    """A folder or file that is not what a run leaves. The message is a sentence for the user."""


class Table:
    """A CSV file: table["time"] is a column, table.unit("time") the label of its unit."""

    def __init__(self, path):
        try:
            with open(path, newline="", encoding="utf-8") as file:
                lines = file.read().splitlines()
        except OSError as error:
            raise NoResults(f"cannot read '{path}': {error.strerror}") from error
        self.path = path
        self.comments = [line[1:].strip() for line in lines if line.startswith("#")]
        rows = list(csv.reader(line for line in lines if line and not line.startswith("#")))
        if not rows:
            raise NoResults(f"'{path}' has no line with the names of its columns")
        self.names = rows[0]
        rows = [row for row in rows[1:] if len(row) == len(self.names)]  # a killed run may leave half a row
        self.columns = {name: _column([row[i] for row in rows]) for i, name in enumerate(self.names)}
        self.units = {}
        for comment in self.comments:
            if comment.startswith("units: "):
                self.units = dict(zip(self.names, comment[len("units: "):].split(",")))

    def __getitem__(self, name):
        if name not in self.columns:
            raise NoResults(f"'{self.path}' has no column '{name}'; it has {', '.join(self.names)}")
        return self.columns[name]

    def __contains__(self, name):
        return name in self.columns

    def __len__(self):
        return len(self.columns[self.names[0]])

    def unit(self, name):
        """Label of the column's unit; empty for a pure number."""
        unit = self.units.get(name, "")
        return "" if unit == "1" else unit.replace("*", " ")


def _column(cells):
    try:
        return np.array([float(cell) for cell in cells])
    except ValueError:
        return np.array(cells, dtype=object)


class Run:
    """What a run has left in its output folder."""

    def __init__(self, folder):
        if not os.path.isdir(folder):
            raise NoResults(f"there is no folder '{folder}'")
        self.folder = folder
        self.name = os.path.basename(os.path.abspath(folder))
        self.history = Table(os.path.join(folder, "history.csv"))
        if len(self.history) == 0:
            raise NoResults(f"'{self.history.path}' has no rows: the run has not finished an increment")
        self.title = self.history.comments[0] if self.history.comments else self.name
        head = " ".join(self.history.comments)
        self.axisymmetric = "plane strain" not in head
        self.axes = ("r", "z") if self.axisymmetric else ("x", "y")
        self.tools = [name[: -len("_travel")] for name in self.history.names if name.endswith("_travel")]
        self.main_tool = self._main_tool()
        self.profiles = self._tables("profile")
        self.contacts = self._tables("contact")
        self.outlines = self._tables("tools")

    def _tables(self, stem):
        """Tables by their travel, ascending."""
        found = {}
        for path in glob.glob(os.path.join(self.folder, stem + "_*.csv")):
            match = re.fullmatch(stem + r"_(.+)\.csv", os.path.basename(path))
            try:
                found[float(match.group(1))] = path
            except ValueError:
                continue
        return {travel: Table(found[travel]) for travel in sorted(found)}

    def _main_tool(self):
        """The tool that travels farthest, or None."""
        ranges = {tool: np.ptp(self.history[tool + "_travel"]) for tool in self.tools}
        ranges = {tool: length for tool, length in ranges.items() if length > 0}
        return max(ranges, key=ranges.get) if ranges else None

    def progress(self):
        """The history's abscissa and its label: travel of the main tool, or time."""
        if self.main_tool is None:
            return self.history["time"], "time"
        name = self.main_tool + "_travel"
        return self.history[name], labelled(f"{self.main_tool} travel", self.history.unit(name))

    @property
    def length_unit(self):
        for table in self.profiles.values():
            return table.unit("r")
        return ""


def labelled(text, unit):
    """ "force [N]"; without brackets for a pure number."""
    return f"{text} [{unit}]" if unit else text


def nearest(tables, travel):
    """Travel and table closest to the travel asked; the last where none is asked; (None, None) where there are none."""
    if not tables:
        return None, None
    key = max(tables) if travel is None else min(tables, key=lambda value: abs(value - travel))
    return key, tables[key]
