"""What a report shows of a run, as plain lists and dictionaries. Standard library only."""
import glob
import json
import math
import os
import re
import xml.etree.ElementTree as xml

from csv_file import CsvFile
from vtu_file import VtuFile

TENSOR = ("rr", "zz", "hoop", "rz")  # its other two components are zero
LARGEST = {"penalty_factor", "penetration_over_delta", "contact_pressure", "contact_status"}  # of the corners of a cell


class NoRun(Exception):
    """A folder holds no run. The message is a sentence for the user."""


def run(folder):
    """All that is shown of a run."""
    if not os.path.isfile(os.path.join(folder, "history.csv")):
        raise NoRun(f"there is no history.csv in '{folder}': it holds no run")
    history = table(os.path.join(folder, "history.csv"))
    if not history["columns"]["time"]:
        raise NoRun(f"'{folder}/history.csv' has no rows: the run has not finished an increment")
    comments = history.pop("comments")
    tools = [name[:-len("_travel")] for name in history["names"] if name.endswith("_travel")]
    return {
        "name": os.path.basename(os.path.abspath(folder)),
        "title": comments[0] if comments else folder,
        "axisymmetric": "plane strain" not in " ".join(comments),
        "tools": tools,
        "main_tool": main_tool(history, tools),
        "history": history,
        "states": states(folder),
        "film": film(folder),
        "summary": read_json(os.path.join(folder, "summary.json")),
        "timing": read_json(os.path.join(folder, "timing.json")),
        "cuts": cuts(os.path.join(folder, "run.log")),
        "limit": limit(os.path.join(folder, "fld.csv")),
        "scene": scene(os.path.join(folder, "scene.prm")),
    }


def tell_apart(runs):
    """Give runs of the same name different ones."""
    for number, one in enumerate(runs):
        if any(other["name"] == one["name"] for other in runs[:number]):
            one["name"] += f" ({number + 1})"


def thin_films(runs):
    """Leave out every second picture of the longest film, but the last. @return whether there was one"""
    films = [one["film"] for one in runs if len(one["film"]["frames"]) > 2]
    if not films:
        return False
    longest = max(films, key=lambda film: len(film["frames"]))
    longest["frames"] = longest["frames"][::-1][::2][::-1]
    longest["thinned"] = True
    return True


def table(path):
    """names, units and columns of a CSV file; numbers with the digits of the file, null where a number is none."""
    try:
        file = CsvFile(path)
    except ValueError as error:
        raise NoRun(str(error)) from error
    units = next((comment[len("units: "):].split(",") for comment in file.comments if comment.startswith("units: ")), [])
    rows = [row for row in file.rows if len(row) == len(file.names)]  # a killed run may leave half a row
    return {"comments": file.comments, "names": file.names, "units": dict(zip(file.names, units)),
            "columns": {name: [cell(row[i]) for row in rows] for i, name in enumerate(file.names)}}


def cell(word):
    try:
        number = float(word)
    except ValueError:
        return word
    return number if math.isfinite(number) else None


def main_tool(history, tools):
    """The tool that travels farthest, or None."""
    ranges = {tool: max(values) - min(values) for tool in tools
              if (values := [value for value in history["columns"][tool + "_travel"] if isinstance(value, float)])}
    best = max(ranges, key=ranges.get, default=None)
    return best if best is not None and ranges[best] > 0 else None


def states(folder):
    """The tables of profile and contact, in the order in which they were written."""
    result = []
    for path in glob.glob(os.path.join(glob.escape(folder), "profile_*.csv")):
        profile = table(path)
        match = re.search(r"^stage (.+), travel of the main tool \(or time\): (\S+)$", "\n".join(profile.pop("comments")), re.MULTILINE)
        if not match:
            continue
        contact_path = path.replace("profile_", "contact_")
        contact = table(contact_path) if os.path.exists(contact_path) else None
        if contact:
            contact.pop("comments")
        result.append({"stage": match.group(1), "travel": float(match.group(2)), "profile": profile, "contact": contact,
                       "file": os.path.basename(path), "written": os.path.getmtime(path)})
    result.sort(key=lambda state: (state.pop("written"), state["travel"]))
    return result


def limit(path):
    """The forming limit curve that `deltaform fld` has written into the folder of a run, or None."""
    if not os.path.isfile(path):
        return None
    columns = table(path)["columns"]
    return {"minor": columns["minor_strain"], "major": columns["major_strain"]}


def film(folder):
    """The pictures: per frame time, points r and z, corners of the cells, a list of values per field, outlines of tools."""
    try:
        series = xml.parse(os.path.join(folder, "scene.pvd")).getroot()
    except (OSError, xml.ParseError):
        return {"fields": [], "frames": []}
    parts = {}
    for entry in series.iter("DataSet"):
        parts.setdefault(float(entry.get("timestep")), []).append((entry.get("name"), os.path.join(folder, entry.get("file"))))
    fields, frames = [], []
    for time, files in sorted(parts.items()):
        frame = {"time": time, "tools": {}}
        try:
            for name, path in files:
                picture = VtuFile(path)
                if name == "blank" and "values" not in frame:
                    values = blank(picture, frame)
                    fields = fields or [list(key) for key in values]
                    frame["values"] = [values.get(tuple(key)) for key in fields]
                else:
                    points = picture.points()
                    frame["tools"][name] = [rounded(points[0::3]), rounded(points[1::3])]
        except (OSError, ValueError) as error:
            raise NoRun(f"a picture cannot be read: {error}") from error
        frames.append(frame)
    return {"fields": fields, "frames": frames}


def blank(picture, frame):
    """Points and cells into the frame; values of the cells by (field, unit)."""
    points = picture.points()
    frame["r"], frame["z"] = rounded(points[0::3], 6), rounded(points[1::3], 6)
    corners = list(picture.numbers(picture.root.find("UnstructuredGrid/Piece/Cells/DataArray[@Name='connectivity']")))
    frame["cells"] = corners
    of_cells = list(picture.root.find("UnstructuredGrid/Piece/CellData") or [])
    of_points = list(picture.root.find("UnstructuredGrid/Piece/PointData") or [])
    result = {}
    for data in of_cells + of_points:
        name, unit = re.fullmatch(r"(.*) \[(.*)\]", data.get("Name")).groups()
        n = int(data.get("NumberOfComponents"))
        numbers = picture.numbers(data)
        components = {1: ("",), 3: (" r", " z"), 6: tuple(" " + part for part in TENSOR)}[n]
        for k, component in enumerate(components):
            values = numbers[k::n]
            if data in of_points:
                values = [corner_value(name, [values[i] for i in corners[c:c + 4]]) for c in range(0, len(corners), 4)]
            result[name + component, unit] = rounded(values, 4)
    return result


def corner_value(name, values):
    return max(values) if name in LARGEST else sum(values) / len(values)


def rounded(values, digits=5):
    """Numbers that are short as text."""
    return [float(f"{value:.{digits}g}") if math.isfinite(value) else None for value in values]


def read_json(path):
    try:
        with open(path, encoding="utf-8") as file:
            return json.load(file)
    except (OSError, ValueError):
        return None


def cuts(path):
    """Increments that were cut back: number, the time that was tried, and why."""
    try:
        with open(path, encoding="utf-8", errors="replace") as file:
            text = file.read()
    except OSError:
        return []
    return [{"increment": int(number), "time": float(time), "why": why}
            for number, time, why in re.findall(r"^increment (\d+) to time (\S+) cut back: (.*)$", text, re.MULTILINE)]


def scene(path):
    """The entries of a scene file with every default, by "Section/Entry"."""
    result, sections = {}, []
    try:
        with open(path, encoding="utf-8", errors="replace") as file:
            lines = [line.split("#", 1)[0].strip() for line in file]
    except OSError:
        return result
    for line in lines:
        if line.startswith("subsection "):
            sections.append(line[len("subsection "):].strip())
        elif line == "end" and sections:
            sections.pop()
        elif line.startswith("set ") and "=" in line:
            name, value = line[len("set "):].split("=", 1)
            result["/".join([*sections, name.strip()])] = value.strip()
    return result
