#!/usr/bin/python3
"""The die radius that leaves a wanted thickness: a root search over runs.

    PYTHONPATH=build/release/python scripts/examples/die_radius.py [--thinning .2] [--travel .8] [--folder output/radius]

The scene is prm/cup.prm. Writes die_radius.png and die_radius.csv.
"""
import argparse
import os
import sys

import matplotlib
import numpy as np
from scipy.optimize import brentq

import deltaform

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
SMALLEST, LARGEST = .07, .45  # in; below two thicknesses a shell is no model


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--thinning", type=float, default=.2, help="wanted, a share of the thickness (%(default)s)")
    parser.add_argument("--travel", type=float, default=.8, help="of the punch, in (%(default)s)")
    parser.add_argument("--folder", default="output/radius")
    options = parser.parse_args()
    scene = deltaform.Scene(os.path.join(ROOT, "prm", "cup.prm"), {"Steps/form/End time": options.travel,
                                                                            "Blank/Elements": 200})
    thickness = scene["Blank/Thickness"]
    tried = {}

    def excess(radius):
        """Thinning beyond what is wanted."""
        scene["Tools/die/Profile radius"] = radius
        tried[radius] = scene.run()
        thinning = 1 - tried[radius].summary["min_thickness"] / thickness
        print(f"die radius {radius:.5f} in: thinning {100 * thinning:.3f} %")
        return thinning - options.thinning

    ends = excess(SMALLEST), excess(LARGEST)
    if ends[0] * ends[1] > 0:
        sys.exit(f"die_radius.py: radii of {SMALLEST} to {LARGEST} in thin by "
                 f"{100 * (ends[1] + options.thinning):.1f} to {100 * (ends[0] + options.thinning):.1f} %: ask for a value in between")
    # The mesh leaves steps of the size of a thousandth: no use in more digits.
    radius = brentq(excess, SMALLEST, LARGEST, xtol=5e-4)
    excess(radius)

    os.makedirs(options.folder, exist_ok=True)
    with open(os.path.join(options.folder, "die_radius.csv"), "w", encoding="utf-8") as file:
        file.write("radius,thinning\n")
        for one in [*sorted(set(tried) - {radius}), radius]:
            file.write(f"{one:.8g},{1 - tried[one].summary['min_thickness'] / thickness:.8g}\n")
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.4), constrained_layout=True)
    radii = sorted(tried)
    left.plot(radii, [100 * (1 - tried[one].summary["min_thickness"] / thickness) for one in radii], "o-", color="#0072b2")
    left.axhline(100 * options.thinning, color="#999999", linestyle="--")
    left.plot([radius], [100 * options.thinning], "s", color="#d55e00")
    left.set(xlabel="profile radius of the die [in]", ylabel="largest thinning [%]",
             title=f"A die radius of {radius:.3f} in thins the cup by {100 * options.thinning:g} %")
    for one, style in ((radii[0], ":"), (radius, "-"), (radii[-1], "--")):
        profile = tried[one].profile()
        right.plot(profile["R0"], 100 * np.expm1(profile["eps_thickness"]), style, label=f"die radius {one:.3f} in")
    right.axhline(0, color="#999999", linewidth=.8)
    right.set(xlabel="initial radius [in]", ylabel="change of thickness [%]", title="Thickness along the blank")
    right.legend()
    path = os.path.join(options.folder, "die_radius.png")
    figure.savefig(path, dpi=160)
    print(path)


if __name__ == "__main__":
    main()
