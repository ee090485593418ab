#!/usr/bin/python3
"""Plots doc/gallery/against_calculix.png from doc/measured/calculix_*.csv: error of the force over processor time without start-up."""
import os

from measured import FOLDER, ROOT
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

from csv_file import rows_of  # noqa: E402
from plot import STYLE  # noqa: E402

PANELS = {"hertz": "Hertz, sphere", "upsetting": "upsetting to 60 %", "rough": "upsetting to 40 %, friction .1", "cup": "cup, solid, to .6 in"}


def main():
    plt.rcParams.update(STYLE)
    figure, axes = plt.subplots(1, len(PANELS), figsize=(13., 3.4), constrained_layout=True)
    for axis, (name, title) in zip(axes, PANELS.items()):
        rows = rows_of(os.path.join(FOLDER, f"calculix_{name}.csv"))
        for program, colour, marker in (("deltaform", "#1f4e79", "o"), ("CalculiX", "#b3402a", "s")):
            points = []
            for row in rows:
                if row["program"].startswith(program) and row["error"][0] in "+-":  # words: it stopped
                    points.append((float(row["without start-up [s]"]), abs(float(row["error"]))))
            axis.loglog(*zip(*points), marker, color=colour, label=program, markersize=5)
        axis.set_title(title, fontsize=10)
        axis.set_xlabel("processor time [s]")
    axes[0].set_ylabel("error of the force")
    axes[0].legend(fontsize=8)
    figure.savefig(os.path.join(ROOT, "doc", "gallery", "against_calculix.png"), dpi=100)


if __name__ == "__main__":
    main()
