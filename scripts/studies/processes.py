#!/usr/bin/python3
"""The processes of doc/processes.md in one picture: the section of each, coloured by plastic strain, with its tools.

    scripts/studies/processes.py [--program PROGRAM] [--output output/processes] [--write]

Runs the scenes of prm/shop and some of prm that --output does not have yet, one after the other (two minutes), and writes
processes.png into --output. --write copies the picture to doc/gallery.
"""
import os
import shutil
import subprocess
import xml.etree.ElementTree as xml

from measured import ROOT, arguments_of

import numpy as np

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.collections import LineCollection, PolyCollection  # noqa: E402

from vtu_file import VtuFile  # noqa: E402

# Name, scene, and the picture of twelve that shows the process at work; -1: the last one, after the release.
PROCESSES = (("cup, drawn through", "shop/cup_drawn_through", 6), ("cup that tears", "shop/cup_tears", -1),
             ("first draw", "shop/redraw_1", 6), ("redrawing", "shop/redraw_2", 7),
             ("stretching", "osu_stretching", -1), ("hydraulic bulge", "shop/hydraulic_bulge", -1),
             ("tube bulge", "shop/tube_bulge", -1), ("U-bend, released", "u_bend", -1),
             ("air bending", "shop/air_bending", 11), ("bottoming", "shop/v_bottoming", 10),
             ("wipe bending", "shop/wipe_bending", 11), ("hole flanging", "shop/hole_flanging", -1),
             ("flaring", "shop/flaring", -1), ("nosing", "shop/nosing", -1),
             ("upsetting, friction", "shop/upsetting_friction", -1), ("forward extrusion", "shop/forward_extrusion", -1),
             ("ironing", "shop/ironing", -1), ("coining", "shop/coining", -1), ("closed-die forging", "forging_flash", -1))


def run(program, folder, scene):
    """The folder of the scene's results, computed unless it is there."""
    out = os.path.join(folder, os.path.basename(scene))
    if not os.path.exists(os.path.join(out, "summary.json")):
        command = [program, os.path.join(ROOT, "prm", scene + ".prm"), "--quiet", "--output", out, "--set", "Output/Pictures=12"]
        if scene == "shop/redraw_2":
            command += ["--set", "Start from=" + os.path.join(folder, "redraw_1")]
        subprocess.run(command, check=False)  # status 2 of a cup that tears is what is wanted
    return out


def cells(path, corners):
    """The file, and the points of its cells (n x corners x 2)."""
    file = VtuFile(path)
    points = np.asarray(file.points()).reshape(-1, 3)[:, :2].astype(float)
    piece = file.root.find("UnstructuredGrid/Piece")
    connectivity = next(data for data in piece.find("Cells") if data.get("Name") == "connectivity")
    return file, points[np.asarray(file.numbers(connectivity)).reshape(-1, corners)]


def pictures(folder):
    """Of every picture: the file of the blank, then those of the tools."""
    found = []
    for entry in xml.parse(os.path.join(folder, "scene.pvd")).getroot().iter("DataSet"):
        if entry.get("part") == "0":
            found.append([])
        found[-1].append(os.path.join(folder, entry.get("file")))
    return found


def panel(axis, name, folder, number):
    blank, *tools = pictures(folder)[number]
    file, polygons = cells(blank, 4)
    strain = np.asarray(file.numbers(file.field("equivalent_plastic_strain")))
    axis.add_collection(PolyCollection(polygons, array=strain, cmap="plasma", clim=(0, max(strain.max(), 1e-9)), edgecolors="face", linewidths=.5))
    for tool in tools:
        axis.add_collection(LineCollection(cells(tool, 2)[1], colors="#20242a", linewidths=1.))
    low, high = polygons.reshape(-1, 2).min(axis=0), polygons.reshape(-1, 2).max(axis=0)
    centre, half = (low + high) / 2, .58 * max(high - low)
    axis.set(xlim=(centre[0] - half, centre[0] + half), ylim=(centre[1] - half, centre[1] + half), xticks=[], yticks=[], aspect="equal")
    axis.set_title(f"{name} ({strain.max():.2g})", fontsize=7)
    for side in axis.spines.values():
        side.set_color("#cccccc")


def main():
    options = arguments_of(__doc__, "processes", write="renew doc/gallery/processes.png").parse_args()
    folder = os.path.abspath(options.output)
    figure, axes = plt.subplots(3, 7, figsize=(12.8, 5.9))
    for axis in axes.flat[len(PROCESSES):]:
        axis.axis("off")
    for axis, (name, scene, number) in zip(axes.flat, PROCESSES):
        panel(axis, name, run(options.program, folder, scene), number)
    figure.tight_layout(pad=.4)
    picture = os.path.join(folder, "processes.png")
    figure.savefig(picture, dpi=110)
    if options.write:
        shutil.copy(picture, os.path.join(ROOT, "doc", "gallery", "processes.png"))


if __name__ == "__main__":
    main()
