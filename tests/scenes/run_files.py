"""Reads what a run has left in its folder: the scene with every default, tables, pictures. Standard library only.

Nothing of the program is used here, and nothing is judged: see check_run.py.
"""
import json
import math
import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent.parent / "scripts"))
from csv_file import CsvFile, rows_of
from vtu_file import VtuFile


class NoRun(Exception):
    """The folder holds no run. The message is a sentence for the user."""


def column_name(name):
    """A tool, support or load as the columns of history.csv name it."""
    return name.replace(" ", "_")


class Table:
    """A CSV file of a run: column(name) is a list of floats, or of words where a cell is no number."""

    def __init__(self, path):
        self.path = Path(path)
        try:
            file = CsvFile(path)
        except ValueError as error:
            raise NoRun(str(error)) from error
        self.comments, self.names, self.rows = file.comments, file.names, file.rows
        ragged = [row for row in self.rows if len(row) != len(self.names)]
        if ragged:
            raise NoRun(f"'{path}' has a row of {len(ragged[0])} cells, but {len(self.names)} columns")
        self._columns = {}

    def __len__(self):
        return len(self.rows)

    def __contains__(self, name):
        return name in self.names

    def column(self, name):
        if name not in self._columns:
            if name not in self.names:
                raise NoRun(f"'{self.path}' has no column '{name}'")
            k = self.names.index(name)
            cells = [row[k] for row in self.rows]
            try:
                self._columns[name] = [float(cell) for cell in cells]
            except ValueError:
                self._columns[name] = cells
        return self._columns[name]


def read_scene(path):
    """The scene as nested dictionaries: scene["Tools"]["punch"]["Radius"] is a text."""
    root = {}
    open_sections = [root]
    for line in Path(path).read_text(encoding="utf-8").splitlines():
        line = line.split("#")[0].strip()
        if line.startswith("subsection "):
            open_sections.append(open_sections[-1].setdefault(line[len("subsection "):].strip(), {}))
        elif line == "end":
            open_sections.pop()
        elif line.startswith("set ") and "=" in line:
            name, value = line[len("set "):].split("=", 1)
            open_sections[-1][name.strip()] = value.strip()
    return root


def names_of(text):
    """The names of a list that is separated by commas."""
    return [name.strip() for name in text.split(",") if name.strip()]


class Actor:
    """A tool, support or load of the scene: its entries, its name in columns, and the stages in which it acts."""

    def __init__(self, name, entries):
        self.name, self.entries, self.column = name, entries, column_name(name)
        self.stages = names_of(entries.get("Stages", ""))

    def acts_in(self, stage):
        return not self.stages or stage in self.stages


class Run:
    """The files of a run. What is missing is None or empty."""

    def __init__(self, folder):
        self.folder = Path(folder)
        for name in ("scene.prm", "history.csv"):
            if not (self.folder / name).exists():
                raise NoRun(f"there is no '{name}' in '{folder}'")
        self.scene = read_scene(self.folder / "scene.prm")
        self.history = Table(self.folder / "history.csv")
        self.plane_strain = any("plane strain" in line for line in self.history.comments)
        self.tools, self.supports, self.loads = (
            [Actor(name, section.get(name, {})) for name in names_of(section.get("Names", ""))]
            for section in (self.scene.get(kind, {}) for kind in ("Tools", "Supports", "Loads")))
        self.stages = names_of(self.scene.get("Steps", {}).get("Stages", ""))
        summary = self.folder / "summary.json"
        self.summary = json.loads(summary.read_text()) if summary.exists() else None

    def tables(self, kind):
        """Tables profile_*.csv and their like by the text between kind and ending."""
        return {path.stem[len(kind) + 1:]: Table(path) for path in sorted(self.folder.glob(kind + "_*.csv"))}

    def row_of(self, table):
        """Row of the history to which a table belongs, or None: its comment names stage and travel."""
        for line in table.comments:
            match = re.fullmatch(r"stage (.+), travel of the main tool \(or time\): (\S+)", line)
            if match:
                break
        else:
            return None
        stage, at = match.group(1), float(match.group(2))
        main = self.main_tool()
        along = self.history.column(f"{main.column}_travel" if main else "time")
        found = [i for i, name in enumerate(self.words("stage")) if name == stage and
                 abs(along[i] - at) <= 1e-8 * max(1., abs(at))]
        return found[-1] if found else None

    def words(self, name):
        """A column of words, although all of them may look like numbers."""
        k = self.history.names.index(name)
        return [row[k] for row in self.history.rows]

    def main_tool(self):
        """Output/Travel of, or the first tool that moves by a motion."""
        asked = self.scene.get("Output", {}).get("Travel of", "")
        for tool in self.tools:
            motion = tool.entries.get("Motion", "0")
            if tool.name == asked or (not asked and not tool.entries.get("Force") and not _is_number(motion)):
                return tool
        return None


def _is_number(text):
    try:
        float(text)
        return True
    except ValueError:
        return False


def floats_of(path):
    """The floating-point arrays of a .vtu file as (label, values). @raise ValueError if the file cannot be read."""
    picture = VtuFile(path)
    for data in picture.arrays():
        if data.get("type") == "Float32":
            yield data.get("Name") or "points", picture.numbers(data)


def not_finite(folder):
    """Where in the tables or pictures of a folder a number is not finite: 'history.csv, tool_work', or None."""
    wrong = re.compile(r"[+-]?(nan|inf|infinity)", re.IGNORECASE)
    for path in sorted(Path(folder).glob("*.csv")):
        for row in rows_of(path):
            for name, cell in row.items():
                if wrong.fullmatch(cell.strip()):
                    return f"{path.name}, {name}"
    for path in sorted(Path(folder).glob("*.vtu")):
        for label, values in floats_of(path):
            if not math.isfinite(sum(values)):
                return f"{path.name}, {label}"
    return None
