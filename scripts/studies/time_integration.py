#!/usr/bin/python3
"""Measures what the increments cost and what they spoil, and renews doc/measured/increments_*.csv and a picture.

    scripts/studies/time_integration.py [--build FOLDER] [--quick] [--write]

1. Order of the error in the size of the increments, mesh kept: flow (a strip in plane strain against its differential
   equation, the thick sphere), friction (capstan), contact (Hertz), all together (stretching, cup, bent strip).
2. Control of the increments: error against Newton iterations, by iterations, by the error of flow, and none.
3. The predictor: iterations with and without.

Without --write the tables are printed only. Needs numpy and matplotlib; about four minutes of one core, --quick: one.
"""
import argparse
import os
import sys

from measured import ROOT, MeasuredTable
from experiments import Program, orders, uniform

sys.path.insert(0, os.path.join(ROOT, "tests", "scenes"))
import reference_values as exact  # noqa: E402

TITLES = {"flow": "strip in plane strain: relative error over the first increments (observed order)",
          "exact": "relative error of problems in which large increments cost nothing: that of the mesh",
          "forming": "relative error over the number of equal increments, mesh kept (observed order)",
          "control": "relative error against iterations: equal increments, aimed iterations, flow error",
          "turning": "strip in plane strain: equal and controlled increments, relative errors",
          "predictor": "Newton iterations with and without predictor"}
PICTURE = os.path.join(ROOT, "doc", "gallery", "time_integration.png")
EULER, TWO_STEPS = "backward Euler", "two steps"
FRICTION = ("Tools/punch/Friction coefficient=0.15", "Tools/die/Friction coefficient=0.15")

# name: scene, stage, end, places, abscissa, entries, quantities
FORMING = {
    "stretching, mu = 0": ("osu_stretching", "form", 40., ()),
    "stretching, mu = 0.15": ("osu_stretching", "form", 40., FRICTION),
    "stretching, solid": ("osu_stretching_solid", "form", 40., ("Blank/Elements=40", "Blank/Elements through thickness=1")),
    "cup": ("cup", "form", 1., ()),
    "bent strip": ("bent_strip", "form", 15., ()),
}


def integration(name):
    return f"Material/Integration={name}"


def flow(program, sizes):
    """Plane-strain stretch: the ratio of the stresses turns at the beginning, where flow is as small as the elastic strain.
    The first increments are made shorter and grow more slowly: all that matter shrink alike."""
    stress, strain = exact.plane_strain_swift()[:2]
    rows = [[f"{1e-3 / n:.1e}, {1 + .4 / n:.3f}"] for n in sizes]
    for rule in (EULER, TWO_STEPS):
        runs = [program("plane_strain_stretch", f"Steps/stretch/First increment={1e-3 / n:.9g}", f"Solver/Growth={1 + .4 / n:.9g}",
                        integration(rule)) for n in sizes]
        if rule == EULER:
            for row, run in zip(rows, runs):
                row.append(f"{run.increments:g}")
        for column, wanted in (("stress_meridional_mid", stress), ("equivalent_plastic_strain", strain)):
            for row, cell in zip(rows, orders(sizes, [run.profiles[1.][column][0] / wanted - 1 for run in runs])):
                row.append(cell)
    return MeasuredTable(["first increment, growth", "increments", *(f"{rule}: {what}" for rule in (EULER, TWO_STEPS) for what in ("stress", "plastic strain"))], rows)


def exact_ones(program, sizes):
    """Problems in which a large increment costs nothing."""
    capstan = exact.capstan(.2, exact.math.radians(90), 50., 1.)
    rows = []
    for n in sizes:
        sphere = program("thick_sphere", *uniform("load", 0., 1., n), "Steps/unload/First increment=1", "Steps/unload/Largest increment=1")
        belt = program("capstan_90", *uniform("draw", 1., 2., n))
        hertz = program("hertz_sphere", *uniform("press", 0., 1., n), "Blank/Elements=20", "Blank/Elements through thickness=20")
        rows.append([str(n), f"{sphere.profiles[1.]['u_r_bottom'][0] / .04712229 - 1:.1e}",
                     f"{belt.history['drum_force_r'][-1] / (100 * capstan) - 1:.2e}",
                     f"{hertz.history['sphere_force_z'][-1] / 7.326007 - 1:.2e}"])
    return MeasuredTable(["increments", "2: thick sphere, u_b", "16: capstan, T2/T1", "11: Hertz, F"], rows)


def forming_run(program, name, n, *entries):
    scene, stage, end, own = FORMING[name]
    run = program(scene, *own, *uniform(stage, 0., end, n), f"Output/Travels={end:g}", *entries)
    return run if run.done else None


def result(run):
    """Force and smallest thickness at the end."""
    return (run.history["punch_force_z"][-1], run.history["min_thickness"][-1])


def limits(program, name, n):
    """Both quantities as the increments go to zero, and how well they are known: extrapolated from backward Euler (of first
    order) and taken from two steps; their difference is the doubt."""
    coarse, fine = (result(forming_run(program, name, k, integration(EULER))) for k in (n // 2, n))
    two = result(forming_run(program, name, n, integration(TWO_STEPS)))
    extrapolated = [2 * b - a for a, b in zip(coarse, fine)]
    return two, [abs(a / b - 1) for a, b in zip(extrapolated, two)]


def forming(program, sizes, finest, series):
    rows = []
    for name in FORMING:
        limit, doubt = limits(program, name, finest)
        for rule in (EULER, TWO_STEPS):
            runs = [forming_run(program, name, n, integration(rule)) for n in sizes]
            errors = [[None if run is None else result(run)[k] / limit[k] - 1 for run in runs] for k in (0, 1)]
            series[name, rule] = (runs, errors)
            cells = [orders(sizes, e, 2 * doubt[k]) for k, e in enumerate(errors)]
            for i, n in enumerate(sizes):
                rows.append([name, rule, str(n),
                             "failed" if runs[i] is None else f"{runs[i].iterations:g}", cells[0][i], cells[1][i]])
        rows.append([name, "known to", "", "", f"{doubt[0]:.0e}", f"{doubt[1]:.0e}"])
    return MeasuredTable(["problem", "flow", "increments", "Newton iterations", "force", "smallest thickness"], rows)


def control(program, finest, quick):
    """Error of thickness and force against iterations."""
    rows = []
    for name in ("stretching, mu = 0", "cup", "bent strip"):
        scene, stage, end, own = FORMING[name]
        limit, _ = limits(program, name, finest)
        choices = [("as shipped", ())]
        choices += [(f"{n} equal increments", uniform(stage, 0., end, n)) for n in ((50, 200) if quick else (25, 50, 100, 200, 400))]
        free = (f"Steps/{stage}/Largest increment={end / 10:g}",)
        choices += [(f"iterations aimed at: {n}, largest increment 1/10", (*free, f"Solver/Target iterations={n}"))
                    for n in ((8,) if quick else (4, 6, 8))]
        choices += [(f"flow error {e:g}, largest increment 1/10", (*free, "Solver/Target iterations=1000", f"Solver/Flow error={e:g}"))
                    for e in ((1e-2,) if quick else (4e-2, 2e-2, 1e-2, 5e-3, 2.5e-3))]
        for label, entries in choices:
            cells = []
            for rule in (EULER, TWO_STEPS):
                run = program(scene, *own, *entries, f"Output/Travels={end:g}", integration(rule))
                if run.done:
                    value = result(run)
                    cells += [f"{run.increments:g}", f"{run.iterations:g}", f"{value[0] / limit[0] - 1:.1e}", f"{value[1] / limit[1] - 1:.1e}"]
                else:
                    cells += ["failed", "", "", ""]
            rows.append([name, label, *cells])
    head = ["increments", "iterations", "force", "thickness"]
    return MeasuredTable(["problem", "control", *(f"{rule}: {h}" if h == "increments" else h for rule in (EULER, TWO_STEPS) for h in head)], rows)


def turning(program, quick):
    """The strip in plane strain with equal increments and with controlled ones."""
    stress, strain = exact.plane_strain_swift()[:2]
    small = ("Solver/Target iterations=1000", "Steps/stretch/First increment=1e-4", "Steps/stretch/Largest increment=0.1")
    choices = [(f"{n} equal increments", uniform("stretch", 0., 1., n)) for n in ((50, 200) if quick else (50, 200, 800))]
    choices += [(f"flow error {e:g}, first increment 1e-4", (*small, f"Solver/Flow error={e:g}")) for e in ((1e-2,) if quick else (3e-2, 1e-2, 3e-3))]
    rows = []
    for label, entries in choices:
        cells = []
        for rule in (EULER, TWO_STEPS):
            run = program("plane_strain_stretch", *entries, integration(rule))
            profile = run.profiles[1.]
            cells += [f"{run.increments:g}", f"{profile['stress_meridional_mid'][0] / stress - 1:.1e}",
                      f"{profile['equivalent_plastic_strain'][0] / strain - 1:.1e}"]
        rows.append([label, *cells])
    return MeasuredTable(["control", *(h for rule in (EULER, TWO_STEPS) for h in (f"{rule}: increments", "stress", "plastic strain"))], rows)


def predictor(program, quick):
    """Newton iterations with and without the extrapolated start: on equal increments, and with the control as shipped."""
    cases = [("stretching, mu = 0", *FORMING["stretching, mu = 0"]), ("cup", *FORMING["cup"]), ("bent strip", *FORMING["bent strip"])]
    if not quick:
        cases.append(("stretching, solid", *FORMING["stretching, solid"]))
    cases += [("upsetting", "upsetting", "press", 9., ()), ("thick sphere", "thick_sphere", "load", 1., ()),
              ("capstan", "capstan_90", "tighten", 1., ())]
    rows = []
    for name, scene, stage, end, own in cases:
        cells = []
        for entries in (uniform(stage, 0., end, 100 if end > 1 or name == "cup" else 20), ()):
            runs = [program(scene, *own, *entries, f"Solver/Extrapolate={flag}") for flag in ("true", "false")]
            cells += ["/".join(f"{run.increments:g}" if run.done else "failed" for run in runs),
                      *(f"{run.iterations:g}" if run.done else "" for run in runs),
                      f"{runs[1].iterations / runs[0].iterations:.1f}" if all(run.done for run in runs) else ""]
        rows.append([name, *cells])
    return MeasuredTable(["problem", "equal increments", "with", "without", "ratio", "increments as controlled, with/without", "with", "without", "ratio"], rows)


def picture(series, sizes):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    names = [name for name in FORMING if (name, EULER) in series]
    colours = dict(zip(names, ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00"]))
    figure, axes = plt.subplots(1, 2, figsize=(10., 4.2), sharey=True, constrained_layout=True)
    for axis, rule in zip(axes, (EULER, TWO_STEPS)):
        for name in names:
            errors = series[name, rule][1][1]
            points = [(n, abs(e)) for n, e in zip(sizes, errors) if e]
            if name == "bent strip":
                continue  # bent, not stretched: its thickness does not change
            axis.loglog(*zip(*points), "o-", color=colours[name], label=name, markersize=4)
        for order, style in ((1, "--"), (2, ":")):
            axis.loglog([sizes[0], sizes[-1]], [3e-2, 3e-2 * (sizes[0] / sizes[-1])**order], style, color="#888888", label=f"order {order}")
        axis.set_title(rule, fontsize=11)
        axis.set_xlabel("increments")
        axis.set_ylim(1e-6, 1e-1)
        axis.set_xticks(sizes, [str(n) for n in sizes])
        axis.minorticks_off()
        axis.grid(color="#dddddd")
    axes[0].set_ylabel("error of the smallest thickness")
    axes[1].legend(fontsize=8, loc="lower left")
    figure.savefig(PICTURE, dpi=110)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default=os.path.join(ROOT, "build", "release"), help="build folder")
    parser.add_argument("--quick", action="store_true", help="fewer and coarser runs; nothing for the page")
    parser.add_argument("--write", action="store_true", help="renew doc/measured/increments_*.csv and the picture")
    options = parser.parse_args()
    program = Program(os.path.join(options.build, "deltaform"))
    sizes = (25, 50, 100) if options.quick else (25, 50, 100, 200)
    finest = 400 if options.quick else 800
    series = {}
    tables = {"flow": flow(program, (1, 2, 4) if options.quick else (1, 2, 4, 8, 16)),
              "exact": exact_ones(program, (1, 4) if options.quick else (1, 2, 4, 8, 16)),
              "forming": forming(program, sizes, finest, series),
              "control": control(program, finest, options.quick),
              "turning": turning(program, options.quick),
              "predictor": predictor(program, options.quick)}
    for name, table in tables.items():
        print(f"{name}\n\n{table}\n")
    print(f"{program.seconds:.0f} s of computing in {len(program.known)} runs")
    if options.write:
        for name, table in tables.items():
            table.write("increments_" + name, TITLES[name])
        picture(series, sizes)


if __name__ == "__main__":
    main()
