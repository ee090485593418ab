#!/usr/bin/python3
"""Hardening and friction from measured curves: least squares, with intervals of confidence.

    PYTHONPATH=build/release/python scripts/examples/fit_hardening.py [--force curve.csv [--strains curve.csv]] [--folder output/fit]

The scene is prm/osu_stretching.prm with friction: a clamped sheet over a hemispherical punch, hardening by Swift's law.
Strength coefficient, hardening exponent and friction coefficient are found from the punch force (a file of travel in mm and
force in N), and from it together with the thickness strain at the end (a file of initial radius in mm and strain). Without
files the curves are made: by the program, with known constants, and errors of 1 % of the largest force and .005 in
strain. The fits have to find these constants again, which says what the curves can tell, not whether a metal is so.
Writes fit_hardening.png and fit_hardening.csv.
"""
import argparse
import os

import matplotlib
import numpy as np
from scipy.optimize import least_squares
from scipy.stats import t as student

import deltaform

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
ENTRIES = {"strength coefficient [MPa]": "Material/Hardening/Strength coefficient",
           "hardening exponent [-]": "Material/Hardening/Hardening exponent",
           "friction coefficient [-]": "Tools/punch/Friction coefficient"}
HIDDEN = np.array([560., .24, .12])  # of the curves that are made
START = np.array([700., .2, .2])
STRAIN_ERROR = .005


class Curves:
    """What is compared: punch force at some travels, thickness strain at some radii at the end."""

    def __init__(self, travels, radii):
        self.travels, self.radii = travels, radii

    def of(self, values):
        scene = deltaform.Scene(os.path.join(ROOT, "prm", "osu_stretching.prm"), dict(zip(ENTRIES.values(), values)))
        scene["Steps/form/End time"] = self.travels[-1]
        scene["Output/Travels"] = ""
        run = scene.run()
        profile = run.profile()
        return (np.interp(self.travels, run.history["punch_travel"], run.history["punch_force_z"]),
                np.interp(self.radii, profile["R0"], profile["eps_thickness"]))


class Fit:
    """values of the three constants, half their intervals of 95 %, and the curves that belong to them."""

    def __init__(self, curves, force, strain, with_strains):
        def residual(x):
            computed = curves.of(x * START)
            deviation = (computed[0] - force) / (.01 * force.max())
            return np.append(deviation, (computed[1] - strain) / STRAIN_ERROR) if with_strains else deviation

        # Differences of a thousandth: well above what the tolerances of the program leave open.
        fit = least_squares(residual, np.ones(3), diff_step=1e-3, bounds=([.2, .2, 0], [3, 3, 3]))
        self.values = fit.x * START
        n_free = len(fit.fun) - len(self.values)
        covariance = 2 * fit.cost / n_free * np.linalg.inv(fit.jac.T @ fit.jac) * np.outer(START, START)
        deviations = np.sqrt(np.diag(covariance))
        self.half = student.ppf(.975, n_free) * deviations
        self.correlations = covariance / np.outer(deviations, deviations)
        self.curves = curves.of(self.values)


def draw(path, curves, force, strain, fits, label):
    figure, (left, right) = plt.subplots(1, 2, figsize=(11, 4.6), constrained_layout=True)
    left.plot(curves.travels, force / 1e3, "o", markersize=4, color="#999999", label=label)
    left.set(xlabel="punch travel [mm]", ylabel="punch force [kN]", title="Swift's law and friction from a force curve")
    if strain is not None:
        right.plot(curves.radii, strain, "o", markersize=4, color="#999999")
    right.set(xlabel="initial radius [mm]", ylabel="thickness strain at the end [-]", title="and from the strains")
    for (name, fit), style, colour in zip(fits.items(), ("--", "-"), ("#d55e00", "#0072b2")):
        left.plot(curves.travels, fit.curves[0] / 1e3, style, color=colour, label=name)
        right.plot(curves.radii, fit.curves[1], style, color=colour)
    lines = [f"{name}: " + ", ".join(f"{value:.3g} ± {half:.2g}" for value, half in zip(fit.values, fit.half))
             for name, fit in fits.items()]
    left.text(.02, .97, "strength [MPa], exponent, friction; 95 %\n" + "\n".join(lines), transform=left.transAxes, va="top", fontsize=8.5)
    left.legend(loc="lower right", frameon=False)
    figure.savefig(path, dpi=160)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--force", help="CSV file: travel [mm], force [N]")
    parser.add_argument("--strains", help="CSV file: initial radius [mm], thickness strain")
    parser.add_argument("--folder", default="output/fit")
    options = parser.parse_args()
    if options.force:
        travels, force = np.loadtxt(options.force, delimiter=",").T
        radii, strain = np.loadtxt(options.strains, delimiter=",").T if options.strains else (np.linspace(0, 50, 26), None)
        curves = Curves(travels, radii)
    else:
        curves = Curves(np.linspace(2, 30, 57), np.linspace(0, 50, 26))
        force, strain = curves.of(HIDDEN)
        chance = np.random.default_rng(1)
        force = force + .01 * force.max() * chance.standard_normal(len(force))
        strain = strain + STRAIN_ERROR * chance.standard_normal(len(strain))

    fits = {"force": Fit(curves, force, strain, False)}
    if strain is not None:
        fits["force and strains"] = Fit(curves, force, strain, True)
    os.makedirs(options.folder, exist_ok=True)
    with open(os.path.join(options.folder, "fit_hardening.csv"), "w", encoding="utf-8") as file:
        file.write("from,constant,value,half_width_95\n")
        for source, fit in fits.items():
            for name, value, half in zip(ENTRIES, fit.values, fit.half):
                file.write(f"{source},{name},{value:.8g},{half:.8g}\n")
                print(f"from {source}: {name} {value:.4g} +- {half:.2g} (95 %)")
            print(f"  correlation of strength and exponent {fit.correlations[0, 1]:.2f}, of exponent and friction {fit.correlations[1, 2]:.2f}")
    path = os.path.join(options.folder, "fit_hardening.png")
    draw(path, curves, force, strain, fits, "measured" if options.force else "made, with errors")
    print(path)


if __name__ == "__main__":
    main()
