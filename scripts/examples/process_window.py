#!/usr/bin/python3
"""A process window: how thin a cup becomes, over friction and holder force, and where it does not come out at all.

    PYTHONPATH=build/release/python scripts/examples/process_window.py [--points 7] [--jobs 2] [--folder output/window]

Every point is a run of prm/cup.prm with the holder pressed by a force. Writes process_window.png and process_window.csv.
"""
import argparse
import multiprocessing
import os

import matplotlib
import numpy as np

import deltaform

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")


def thinning(point):
    """Largest thinning, a share of the thickness, and 0, or the exit status of a run that stopped."""
    friction, force = point
    scene = deltaform.Scene(os.path.join(ROOT, "prm", "cup.prm"))
    for tool in ("punch", "die", "holder"):
        scene[f"Tools/{tool}/Friction coefficient"] = friction
    scene["Tools/holder/Force"] = force
    run = scene.run(check=False)
    return 1 - run.summary["min_thickness"] / scene["Blank/Thickness"], run.exit_status, run.message


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--points", type=int, default=7, help="along each axis (%(default)s)")
    parser.add_argument("--jobs", type=int, default=2, help="processes (%(default)s)")
    parser.add_argument("--folder", default="output/window")
    options = parser.parse_args()

    frictions = np.linspace(.04, .34, options.points)
    forces = np.linspace(.5, 5, options.points)
    points = [(friction, force) for force in forces for friction in frictions]
    # Processes are started afresh: MPI does not survive a copy.
    with multiprocessing.get_context("spawn").Pool(options.jobs) as pool:
        results = pool.map(thinning, points, chunksize=1)

    os.makedirs(options.folder, exist_ok=True)
    with open(os.path.join(options.folder, "process_window.csv"), "w", encoding="utf-8") as file:
        file.write("friction,holder_force,thinning,exit_status\n")
        for (friction, force), (value, status, _) in zip(points, results):
            file.write(f"{friction:.6g},{force:.6g},{value:.10g},{status}\n")

    shape = (options.points, options.points)
    values = np.array([value for value, _, _ in results]).reshape(shape)
    stopped = np.array([status != 0 for _, status, _ in results]).reshape(shape)
    figure, axis = plt.subplots(figsize=(7.4, 5), constrained_layout=True)
    good = np.ma.array(100 * values, mask=stopped)
    filled = axis.contourf(frictions, forces, good, levels=12, cmap="viridis_r")
    lines = axis.contour(frictions, forces, good, levels=filled.levels[::2], colors="white", linewidths=.7)
    axis.clabel(lines, fmt="%g %%", fontsize=8)
    torn, ironed = [np.array([status != 0 and word in message for _, status, message in results]).reshape(shape)
                    for word in ("tears", "iron")]
    for marked, marker, text in ((torn, "x", "tears"), (ironed, "s", "ironed by die and holder"),
                                 (stopped & ~torn & ~ironed, "v", "stopped for another reason")):
        if marked.any():
            rows, columns = np.nonzero(marked)
            axis.plot(frictions[columns], forces[rows], marker, color="#b00020", label=text, clip_on=False)
    figure.colorbar(filled, label="largest thinning at a travel of 1 in [%]")
    axis.set(xlabel="friction coefficient of all tools [-]", ylabel="holder force [tonf]",
             title="Hemispherical cup: process window")
    if stopped.any():
        axis.legend(loc="upper center", bbox_to_anchor=(.5, -.12), ncol=3, frameon=False)
    path = os.path.join(options.folder, "process_window.png")
    figure.savefig(path, dpi=160)
    print(f"{len(points)} runs, {np.count_nonzero(stopped)} stopped, thinning {good.min():.1f} to {good.max():.1f} %")
    print(path)


if __name__ == "__main__":
    main()
