"""deltaform in Python: scenes are run in this process, results are numpy arrays; no file is written.

    import deltaform
    scene = deltaform.Scene("prm/cup.prm")
    scene["Tools/punch/Friction coefficient"] = .1
    run = scene.run()
    run.history["punch_force_z"], run.history.unit("punch_force_z")
    run.profile(1.0)["eps_thickness"]

Names of entries, columns and members of the summary are those of the program's files (doc/parameters.md,
doc/columns.md, doc/output.md).
"""
import difflib
import json

import numpy as np

from . import _deltaform
from ._deltaform import SceneError

SceneError.__module__ = __name__  # where users find it
__version__ = _deltaform.version
__all__ = ["NotDone", "Run", "Scene", "SceneError", "State", "Table"]


class NotDone(RuntimeError):
    """A run that stopped; the message says where and why. run has all that was computed up to there."""

    def __init__(self, message, run):
        super().__init__(message)
        self.run = run

    def __reduce__(self):
        return NotDone, (str(self), self.run)


class Table:
    """Columns by their names: table["time"] is an array, table.unit("time") the label of its unit ("1": a pure number)."""

    def __init__(self, columns):
        self._columns = {name: np.asarray(values) for name, _, values in columns}
        self.units = {name: unit for name, unit, _ in columns}

    @property
    def names(self):
        return list(self._columns)

    def unit(self, name):
        self[name]  # its error is the better one
        return self.units[name]

    def __getitem__(self, name):
        if name not in self._columns:
            raise KeyError(f"there is no column '{name}'{_nearest(name, self._columns)}")
        return self._columns[name]

    def __contains__(self, name):
        return name in self._columns

    def __iter__(self):
        return iter(self._columns)

    def __len__(self):
        """The number of rows."""
        return len(next(iter(self._columns.values()), ()))

    def __repr__(self):
        return f"<{len(self)} rows of {', '.join(f'{name} [{unit}]' for name, unit in self.units.items())}>"


class State:
    """A state of a run: stage, time, travel of the main tool; profile and contact are tables, outlines arrays of r, z by tool."""

    def __init__(self, state):
        self.stage, self.time, self.travel = state["stage"], state["time"], state["travel"]
        self.profile, self.contact = Table(state["profile"]), Table(state["contact"])
        tools, points = Table(state["outlines"]), {}
        for tool, r, z in zip(tools["tool"], tools["r"], tools["z"]):
            points.setdefault(str(tool), []).append((r, z))
        self.outlines = {tool: np.array(line) for tool, line in points.items()}

    def __repr__(self):
        return f"<stage '{self.stage}', travel {self.travel:g}, time {self.time:g}>"


class Run:
    """What a run leaves: history is a Table with a row per increment, states are those of which tables were kept.

    summary is the content of summary.json, log what the program would have said.
    """

    def __init__(self, record):
        self.title, self.units, self.axisymmetric = record["title"], record["units"], record["axisymmetric"]
        self.exit_status, self.message, self.log = record["exit_status"], record["message"], record["log"]
        self.history = Table(record["history"])
        self.states = [State(state) for state in record["states"]]
        self.summary = json.loads(record["summary"])

    @property
    def done(self):
        return self.exit_status == 0

    @property
    def warnings(self):
        """What makes scene or result doubtful; an empty list is a good sign."""
        return self.summary["warnings"]

    def state(self, travel=None, stage=None):
        """The last state at a travel of the main tool (at a time where there is none); the last of all without one.

        @raise LookupError if none was kept: Output/Travels names the travels, run(keep="all") keeps every increment
        """
        states = [state for state in self.states if stage is None or state.stage == stage]
        if travel is not None:
            states = [state for state in states if abs(state.travel - travel) <= 1e-6 * max(1., abs(travel))]
        if not states:
            raise LookupError(f"no tables were kept {'' if travel is None else f'at travel {travel:g} '}"
                              f"{'' if stage is None else f'of stage {stage} '}"
                              f"(there are {', '.join(f'{state.travel:g}' for state in self.states) or 'none'}): name it "
                              "in Output/Travels, or keep all")
        return states[-1]

    def profile(self, travel=None, stage=None):
        """Thickness, strains, stresses along the blank (columns of profile_*.csv); see state()."""
        return self.state(travel, stage).profile

    def contact(self, travel=None, stage=None):
        """The touching points (columns of contact_*.csv); see state()."""
        return self.state(travel, stage).contact

    def __repr__(self):
        return f"<run of '{self.title}': {self.summary['outcome']}, {len(self.history)} increments>"


class Scene:
    """A scene file, and entries that replace those in it. It may be run any number of times, and pickled.

    @raise SceneError if the file cannot be read
    """

    def __init__(self, file, entries=None):
        self._name, self._text, self._sets = str(file), None, {}
        self._begin(entries)

    @classmethod
    def from_text(cls, text, name="scene", entries=None):
        """A scene from a text; name stands for the file in messages."""
        scene = cls.__new__(cls)
        scene._name, scene._text, scene._sets = name, text, {}
        scene._begin(entries)
        return scene

    def _begin(self, entries):
        _deltaform.read(self._source())
        for entry, value in (entries or {}).items():
            self[entry] = value

    def _source(self):
        return _deltaform.Source(self._name, self._text, [f"{entry}={value}" for entry, value in self._sets.items()])

    def __setitem__(self, entry, value):
        """Replace an entry. What is wrong with it is said by run() or check(): entries that depend on each other come in any order."""
        self._sets.pop(entry, None)  # the last one counts
        self._sets[entry] = _text(value)

    def __getitem__(self, entry):
        """The value of an entry, also one that the scene leaves at its default: a number where it is one, else its text."""
        entries = self.entries()
        if entry not in entries:
            raise KeyError(f"the scene has no entry '{entry}'{_nearest(entry, entries)}")
        return _value(entries[entry])

    def entries(self):
        """All entries with their texts, defaults included. @raise SceneError"""
        return dict(_deltaform.entries(self._source()))

    def copy(self):
        other = Scene.__new__(Scene)
        other._name, other._text, other._sets = self._name, self._text, dict(self._sets)
        return other

    def check(self):
        """Build the scene. @return what makes it doubtful, sentences. @raise SceneError if it is wrong"""
        return _deltaform.warnings(self._source())

    def text(self):
        """The scene with every default, as a scene file."""
        return _deltaform.completed(self._source())

    def run(self, progress=None, keep="asked", check=True):
        """Run it to its end.

        progress is called after every increment with the row of the history, a dictionary; what it raises ends the run,
        as Ctrl-C does. keep="all" keeps tables of every increment, "asked" those that the scene names in Output/Travels
        (else those at the ends of stages).

        @return a Run
        @raise SceneError if the scene is wrong
        @raise NotDone, with the Run, if it stopped; with check=False look at Run.done instead
        """
        if keep not in ("asked", "all"):
            raise ValueError(f"keep='{keep}': it may be 'asked' or 'all'")
        run = Run(_deltaform.run(self._source(), keep == "all", progress))
        if check and not run.done:
            raise NotDone(run.message, run)
        return run

    def __repr__(self):
        return f"<scene {self._name}{''.join(f', {entry} = {value}' for entry, value in self._sets.items())}>"


def _text(value):
    """A value as a scene has it; sequences of numbers with commas, of points with semicolons."""
    if isinstance(value, str):
        return value
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    array = np.asarray(value)
    if array.ndim == 0:
        return repr(array.item())
    if array.ndim == 1:
        return ", ".join(_text(item) for item in array)
    return "; ".join(" ".join(_text(number) for number in point) for point in array)


def _value(text):
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            pass
    return text


def _nearest(name, names):
    found = difflib.get_close_matches(name, list(names), 1, 0)
    return f"; the nearest is '{found[0]}'" if found else ""
