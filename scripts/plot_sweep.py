#!/usr/bin/python3
"""Plot the table of a sweep: results over what was varied.

    scripts/plot_sweep.py output/sweep                  output/sweep/sweep.png
    scripts/plot_sweep.py output/sweep --columns force_z,min_thickness --file sweep.pdf

A row of panels per result, a column per varied entry. Where few values were combined, runs that differ in one entry only are
joined by a line; samples are points, coloured by the entry that is varied next. Runs that did not end well are crosses at
the lower edge. Needs numpy and matplotlib only.
"""
import argparse
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

from panels import RUN_COLOURS  # noqa: E402
from plot import STYLE  # noqa: E402
from results import NoResults, Table, labelled  # noqa: E402

USUAL = ["force_z", "min_thickness", "max_penetration_over_delta", "newton_iterations", "seconds"]
NAMES = {"force_z": "force of the main tool", "min_thickness": "smallest thickness", "seconds": "computing time",
         "max_penetration_over_delta": "penetration over delta", "newton_iterations": "iterations of Newton"}
MOST_LINES = 8


class Sweep:
    """sweep.csv: what was varied, and the rows."""

    def __init__(self, folder):
        self.table = table = Table(os.path.join(folder, "sweep.csv"))
        if "exit_status" not in table or len(table) == 0:
            raise NoResults(f"'{table.path}' is no table of a sweep, or has no rows")
        self.varied = table.names[1:table.names.index("exit_status")]
        self.good = table["exit_status"] == 0

    def places(self, entry):
        """Where the runs stand on the axis of an entry, and the labels of that axis if its values are words."""
        values = self.table[entry]
        if values.dtype != object:
            return values, None
        words = list(dict.fromkeys(values))
        return np.array([words.index(value) for value in values], dtype=float), words

    def lines(self, entry):
        """Rows that differ in an entry only, by the values of the others; None if that gives too many lines or points."""
        others = [name for name in self.varied if name != entry]
        groups = {}
        for row in range(len(self.table)):
            key = ", ".join(f"{name.split('/')[-1]} = {self.table.words(name)[row]}" for name in others)
            groups.setdefault(key, []).append(row)
        joined = len(groups) <= MOST_LINES and (len(groups) == 1 or all(len(rows) > 1 for rows in groups.values()))
        return groups if joined else None


def usual_columns(sweep):
    """The results that differ between the runs, at most three."""
    def differs(name):
        values = sweep.table[name][sweep.good] if name in sweep.table else np.array([])
        return values.dtype != object and np.isfinite(values).any() and np.nanmax(values) > np.nanmin(values)
    return [name for name in USUAL if differs(name)][:3] or ["seconds"]


def draw_panel(figure, axis, sweep, entry, column):
    x, words = sweep.places(entry)
    y = sweep.table[column]
    groups = sweep.lines(entry)
    if groups is not None:
        for number, (name, rows) in enumerate(groups.items()):
            rows = np.array([row for row in rows if sweep.good[row]], dtype=int)
            rows = rows[np.argsort(x[rows], kind="stable")] if len(rows) else rows
            axis.plot(x[rows], y[rows], "-o", markersize=4, color=RUN_COLOURS[number % len(RUN_COLOURS)], label=name or None)
        if len(groups) > 1:
            axis.legend(fontsize=7, loc="best")
    else:
        other = sweep.varied[(sweep.varied.index(entry) + 1) % len(sweep.varied)]
        colours, other_words = sweep.places(other)
        points = axis.scatter(x[sweep.good], y[sweep.good], c=colours[sweep.good], s=22, cmap="viridis")
        if other != entry and other_words is None:
            figure.colorbar(points, ax=axis, pad=0.02).set_label(other.split("/")[-1], fontsize=8)
    bad = ~sweep.good
    if bad.any():
        axis.plot(x[bad], np.full(bad.sum(), 0.03), "x", color="#b00020", transform=axis.get_xaxis_transform(), clip_on=False)
    if words is not None:
        axis.set_xticks(range(len(words)), [word if len(word) < 20 else word[:17] + "..." for word in words], rotation=20, ha="right")
    elif groups is not None and x.min() > 0 and x.max() > 30 * x.min():
        axis.set_xscale("log")
    axis.set_xlabel(entry)
    axis.set_ylabel(labelled(NAMES.get(column, column.replace("_", " ")), sweep.table.unit(column)))


def draw(sweep, columns):
    n = len(sweep.varied)
    figure, axes = plt.subplots(len(columns), n, figsize=(1.2 + 4.6 * n, 0.6 + 3.1 * len(columns)), squeeze=False, constrained_layout=True)
    for row, column in enumerate(columns):
        for k, entry in enumerate(sweep.varied):
            draw_panel(figure, axes[row][k], sweep, entry, column)
    n_bad = int((~sweep.good).sum())
    figure.suptitle((sweep.table.comments or ["sweep"])[0] + f": {len(sweep.good)} runs"
                    + (f", {n_bad} of which not to the end" if n_bad else ""), fontsize=12, fontweight="bold")
    return figure


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", metavar="FOLDER", help="of the sweep")
    parser.add_argument("--columns", help="of sweep.csv, comma-separated; default: the usual ones that differ")
    parser.add_argument("--file", help="of the picture (.png, .pdf, .svg); default: sweep.png in the folder")
    options = parser.parse_args()
    plt.rcParams.update(STYLE)
    try:
        sweep = Sweep(options.folder)
        columns = [name.strip() for name in options.columns.split(",")] if options.columns else usual_columns(sweep)
        for name in columns:
            if sweep.table[name].dtype == object:
                raise NoResults(f"column '{name}' holds words")
        path = options.file or os.path.join(options.folder, "sweep.png")
        draw(sweep, columns).savefig(path)
        print(path)
    except (NoResults, OSError) as error:
        sys.exit(f"plot_sweep.py: {error}")


if __name__ == "__main__":
    main()
