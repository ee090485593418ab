"""Reads the output folder of a run: its tables, with names and units of their columns."""
import glob
import json
import os
import re

import numpy as np

from csv_file import CsvFile


class NoResults(Exception):
    """A folder or file that is not what a run leaves. The message is a sentence for the user."""


class Table:
    """A CSV file: table["time"] is a column, table.unit("time") the label of its unit."""

    def __init__(self, path):
        try:
            file = CsvFile(path)
        except OSError as error:
            raise NoResults(f"cannot read '{path}': {error.strerror}") from error
        except ValueError as error:
            raise NoResults(str(error)) from error
        self.path, self.comments, self.names = path, file.comments, file.names
        self.rows = rows = [row for row in file.rows if len(row) == len(self.names)]  # a killed run may leave half a row
        self.columns = {name: _column([row[i] for row in rows]) for i, name in enumerate(self.names)}
        self.units = {}
        for comment in self.comments:
            if comment.startswith("units: "):
                self.units = dict(zip(self.names, comment[len("units: "):].split(",")))

    def __getitem__(self, name):
        if name not in self.columns:
            raise NoResults(f"'{self.path}' has no column '{name}'; it has {', '.join(self.names)}")
        return self.columns[name]

    def words(self, name):
        """A column of words, even if all of them look like numbers."""
        k = self.names.index(name)
        return [row[k] for row in self.rows]

    def __contains__(self, name):
        return name in self.columns

    def __len__(self):
        return len(self.columns[self.names[0]])

    def unit(self, name):
        """Label of the column's unit; empty for a pure number."""
        unit = self.units.get(name, "")
        return "" if unit == "1" else unit.replace("*", " ")


def _column(cells):
    """Numbers, or words where a cell is no number."""
    try:
        return np.array([float(cell or "nan") for cell in cells])  # not known: empty
    except ValueError:
        return np.array(cells, dtype=object)


class State:
    """A moment of which a run has written tables: its stage, travel of the main tool (or time), time, and the tables."""

    def __init__(self, stage, travel, time, by_time, profile):
        self.stage, self.travel, self.time, self.profile = stage, travel, time, profile
        self.by_time = by_time  # no tool has a motion: travel is a time
        self.contact = self.outlines = None


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
        self.states = self._states()
        self.warnings = self._warnings()

    def _main_tool(self):
        """The tool that travels farthest, or None."""
        ranges = {tool: np.ptp(self.history[tool + "_travel"]) for tool in self.tools}
        ranges = {tool: length for tool, length in ranges.items() if length > 0}
        return max(ranges, key=ranges.get) if ranges else None

    def _states(self):
        """All states of which there is a profile, in the order of time."""
        result = []
        for path in glob.glob(os.path.join(self.folder, "profile_*.csv")):
            profile = Table(path)
            match = re.search(r"^stage (.+), travel of the main tool \(or time\): (\S+)$", "\n".join(profile.comments), re.MULTILINE)
            if not match or len(profile) == 0:
                continue
            stage, travel = match.group(1), float(match.group(2))
            state = State(stage, travel, *self._time(stage, travel), profile)
            for kind in ("contact", "tools"):
                other = path.replace("profile_", kind + "_")
                if os.path.exists(other):
                    setattr(state, "contact" if kind == "contact" else "outlines", Table(other))
            result.append(state)
        return sorted(result, key=lambda state: state.time)

    def _time(self, stage, travel):
        """When a stage was last at a travel, and whether that is a time: tables name no time where a tool moves."""
        rows = np.array([name == stage for name in self.history.words("stage")])
        times = self.history["time"][rows]
        if not len(times):
            return travel, True
        # The main tool of the program is the first that moves; here it is found by its travel.
        candidates = [self.history[tool + "_travel"][rows] for tool in self.tools] + [times]
        off = [np.abs(values - travel) for values in candidates]
        best = min(range(len(off)), key=lambda k: off[k].min())
        at = np.flatnonzero(off[best] <= off[best].min() + 1e-9 * max(1., abs(travel)))[-1]
        return times[at], best + 1 == len(candidates)

    def _warnings(self):
        """What the program warns of in summary.json."""
        try:
            with open(os.path.join(self.folder, "summary.json"), encoding="utf-8") as file:
                return [str(text) for text in json.load(file).get("warnings", [])]
        except (OSError, ValueError):
            return []

    def last_states(self, travel=None):
        """The last state of every stage; where a travel is asked, the state closest to it."""
        if travel is not None and self.states:
            return [min(self.states, key=lambda state: abs(state.travel - travel))]
        return list({state.stage: state for state in self.states}.values())

    def several_stages(self):
        return len({state.stage for state in self.states}) > 1

    def label(self, state):
        """ "15 mm", with the stage where there are several."""
        text = f"{state.travel:g}"
        return f"{text}, {state.stage}" if self.several_stages() else text

    def moving(self):
        """Rows of stages in which the main tool moves."""
        if self.main_tool is None:
            return np.zeros(len(self.history), dtype=bool)
        travel, stages = self.history[self.main_tool + "_travel"], self.history.words("stage")
        result = np.zeros(len(travel), dtype=bool)
        for stage in dict.fromkeys(stages):
            rows = np.array([name == stage for name in stages])
            # The stage begins where the one before has ended.
            first = np.flatnonzero(rows)[0]
            span = travel[max(first - 1, 0):][: np.count_nonzero(rows) + (first > 0)]
            result |= rows & (np.ptp(span) > 1e-9 * np.ptp(travel))
        return result

    @property
    def length_unit(self):
        return self.states[0].profile.unit("r") if self.states else ""

    @property
    def time_unit(self):
        unit = self.history.unit("time")
        return "" if unit == "time" else unit

    def force_unit(self, column):
        """Label of a force (or energy): in plane strain they are per unit width."""
        unit = self.history.unit(column)
        length = self.length_unit
        return unit if self.axisymmetric or not unit or not length else f"{unit}/{length}"


def labelled(text, unit):
    """ "force [N]"; without brackets for a pure number."""
    return f"{text} [{unit}]" if unit else text
