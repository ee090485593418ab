"""The deformed section of a blank, from the files of a run: cells, their values, and what they are."""
import os
import xml.etree.ElementTree as xml

import numpy as np

from results import NoResults
from vtu_file import VtuFile


class Section:
    """Quadrilaterals (n x 4 x 2), a value for each or None, the label of the values, and the points of the blank."""

    def __init__(self, cells, values=None, label="", time=None):
        self.cells, self.values, self.label = cells, values, label
        self.time = time  # of the picture, where it is not that of the state
        self.points = cells.reshape(-1, 2)


def _arrays(path):
    """Points, connectivity and cell fields of a picture, by name without unit; with the unit in a second dictionary."""
    try:
        file = VtuFile(path)
        piece = file.root.find("UnstructuredGrid/Piece")

        def values(data):
            return np.asarray(file.numbers(data))

        points = np.asarray(file.points()).reshape(-1, 3)[:, :2].astype(float)
        connectivity = next(values(data) for data in piece.find("Cells") if data.get("Name") == "connectivity").reshape(-1, 4)
        fields, units = {}, {}
        for data in piece.find("CellData"):
            name, unit = data.get("Name").rstrip("]").split(" [")
            if data.get("NumberOfComponents", "1") == "1":
                fields[name], units[name] = values(data), "" if unit == "-" else unit
        return points, connectivity, fields, units
    except (OSError, ValueError) as error:
        raise NoResults(f"cannot read '{path}': {error}") from error


def _picture(run, time):
    """File and time of the picture of the blank closest to a time; (None, None) if there are none."""
    series = os.path.join(run.folder, "scene.pvd")
    if not os.path.exists(series):
        return None, None
    found = [(float(entry.get("timestep")), entry.get("file")) for entry in xml.parse(series).getroot().iter("DataSet")
             if entry.get("part") == "0"]
    if not found:
        return None, None
    when, name = min(found, key=lambda item: abs(item[0] - time))
    return os.path.join(run.folder, name), when


def _of_faces(bottom, top, values):
    strips = np.stack([bottom[:-1], bottom[1:], top[1:], top[:-1]], axis=1)
    return Section(strips, 0.5 * (values[:-1] + values[1:]), "equivalent plastic strain")


def _normals(points):
    tangent = np.gradient(points, axis=0)
    tangent /= np.maximum(np.linalg.norm(tangent, axis=1), 1e-300)[:, None]
    return np.column_stack([-tangent[:, 1], tangent[:, 0]])


def _shell(table):
    """The mid-line, plus and minus half the thickness along the normal."""
    points = np.column_stack([table["r"], table["z"]])
    offset = 0.5 * table["thickness"][:, None] * _normals(points)
    return _of_faces(points - offset, points + offset, table["equivalent_plastic_strain"])


def _strip(table):
    """The faces of a solid strip: its middle line, and the thickness with the displacements of both faces."""
    initial = np.exp(-table["eps_thickness"]) * table["thickness"]
    across = initial[:, None] * _normals(np.column_stack([table["R0"], table["Z0"]]))
    across += np.column_stack([table[f"u_{k}_top"] - table[f"u_{k}_bottom"] for k in "rz"])
    middle = np.column_stack([table["r"], table["z"]])
    return _of_faces(middle - 0.5 * across, middle + 0.5 * across, table["equivalent_plastic_strain"])


def _is_strip(table):
    """In the profile of any other body a node is its own bottom and top."""
    return any(np.any(table[f"u_{k}_bottom"] != table[f"u_{k}_top"]) for k in "rz")


def section_of(run, state):
    """The section of a state: of a solid the cells of its picture, or those of the nearest one; None if there is nothing."""
    table = state.profile
    if "Z0" not in table:
        return _shell(table)
    path, time = _picture(run, state.time)
    at_state = path is not None and abs(time - state.time) <= 1e-9 * max(1., abs(state.time))
    if not at_state and _is_strip(table):
        return _strip(table)
    if path is None or not os.path.exists(path):
        return None
    points, connectivity, fields, units = _arrays(path)
    plastic = fields["equivalent_plastic_strain"]
    name = "equivalent_plastic_strain" if plastic.max() > 1e-9 else "stress_von_mises"
    label = name.replace("_", " ").replace("von mises", "(von Mises)")
    unit = units[name]
    return Section(points[connectivity], fields[name], f"{label} [{unit}]" if unit else label, None if at_state else time)
