#!/usr/bin/python3
"""Plot the results of deltaform: forces, strain along the blank, penetration, deformed section, energies.

    scripts/plot.py output/cup                          output/cup/plot.png with all panels
    scripts/plot.py output/cup output/cup_fine          the two on top of each other
    scripts/plot.py output/cup --panel force --file force.pdf
    scripts/plot.py output/cup --separate               force.png, profile.png and so on

Reads history.csv, profile_*.csv, contact_*.csv, tools_*.csv, of solids the pictures of the blank, and the warnings of
summary.json. Of a run of several stages the last state of each is shown. Needs numpy and matplotlib only.
"""
import argparse
import os
import sys
import textwrap

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

import panels  # noqa: E402
from results import NoResults, Run  # noqa: E402

MOST_WARNINGS = 6  # lines

STYLE = {
    "figure.facecolor": "white",
    "font.family": "DejaVu Sans",
    "font.size": 9,
    "axes.titlesize": 10.5,
    "axes.titleweight": "bold",
    "axes.titlelocation": "left",
    "axes.titlepad": 9,
    "axes.labelcolor": "#333333",
    "axes.edgecolor": "#777777",
    "axes.linewidth": 0.8,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.color": "#e4e4e4",
    "grid.linewidth": 0.8,
    "xtick.color": "#555555",
    "ytick.color": "#555555",
    "lines.linewidth": 1.8,
    "lines.solid_capstyle": "round",
    "legend.frameon": False,
    "legend.fontsize": 8.5,
    "legend.borderaxespad": 0,
    "savefig.dpi": 160,
}


def arguments():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("folders", nargs="+", metavar="FOLDER", help="of the results of a run; several to overlay")
    parser.add_argument("--panel", choices=["all", *panels.PANELS], default="all", help="default: all in one picture")
    parser.add_argument("--separate", action="store_true", help="one picture per panel")
    parser.add_argument("--file", help="of the picture (.png, .pdf, .svg); default: plot.png in the first folder")
    parser.add_argument("--travel", type=float, help="at which penetration and section are plotted; default: the end of every stage")
    parser.add_argument(
        "--quantity", default="eps_thickness", help="column of profile_*.csv for the profile; default: %(default)s"
    )
    parser.add_argument("--names", help="of the runs in the legend, comma-separated; default: the folders' names")
    return parser.parse_args()


def draw_all(runs, options):
    """The panels in one figure; the section takes the whole of the lower row where nothing touches."""
    touching = any(state.contact is not None and len(state.contact) for run in runs for state in run.states)
    figure, axes = plt.subplot_mosaic(
        [["force", "profile"], ["penetration" if touching else "section", "section"]],
        figsize=(13, 8.6),
        constrained_layout=True,
    )
    figure.set_constrained_layout_pads(w_pad=0.12, h_pad=0.14, wspace=0.03, hspace=0.03)
    for name, axis in axes.items():
        panels.PANELS[name](axis, runs, options)
    titles = dict.fromkeys(run.title for run in runs)
    figure.suptitle(" / ".join(titles), fontsize=13, fontweight="bold")
    write_warnings(figure, runs)
    return figure


def write_warnings(figure, runs):
    """What summary.json warns of, under the title."""
    several = len(runs) > 1
    lines = [line for run in runs for text in run.warnings
             for line in textwrap.wrap(("" if not several else f"{run.name}: ") + "Warning: " + text, 150)]
    lines = lines[:MOST_WARNINGS] + (["..."] if len(lines) > MOST_WARNINGS else [])
    if not lines:
        return
    height = 0.021 * len(lines)
    title = figure._suptitle  # the one way to where constrained layout puts it
    title.set_y(0.985)
    title.set_va("top")
    figure.text(0.5, 0.95, "\n".join(lines), ha="center", va="top", fontsize=9, color="#b00020")
    figure.get_layout_engine().set(rect=(0, 0, 1, 0.945 - height))


def draw_one(name, runs, options):
    """One panel as a figure of its own."""
    figure, axis = plt.subplots(figsize=(7.4, 4.6), constrained_layout=True)
    figure.set_constrained_layout_pads(w_pad=0.1, h_pad=0.1)
    panels.PANELS[name](axis, runs, options)
    return figure


def draw(runs, options):
    """The figures that are asked for, by the names of their files."""
    if options.separate:
        folder, file = os.path.split(options.file or os.path.join(options.folders[0], "plot.png"))
        ending = os.path.splitext(file)[1]
        return {os.path.join(folder, name + ending): draw_one(name, runs, options) for name in panels.PANELS}
    if options.panel == "all":
        return {options.file or os.path.join(options.folders[0], "plot.png"): draw_all(runs, options)}
    path = options.file or os.path.join(options.folders[0], options.panel + ".png")
    return {path: draw_one(options.panel, runs, options)}


def main():
    options = arguments()
    plt.rcParams.update(STYLE)
    try:
        runs = [Run(folder) for folder in options.folders]
        for run, name in zip(runs, (options.names or "").split(",")):
            run.name = name.strip() or run.name
        for path, figure in draw(runs, options).items():
            figure.savefig(path)
            print(path)
    except (NoResults, OSError) as error:
        sys.exit(f"plot.py: {error}")


if __name__ == "__main__":
    main()
