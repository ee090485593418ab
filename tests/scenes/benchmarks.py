#!/usr/bin/env python3
"""Runs the shipped reference problems in series of meshes, layers and increments: errors and orders of convergence.

    python3 tests/scenes/benchmarks.py build/release/deltaform [--write] [TABLE ...]

Without names all tables are made; --write renews doc/measured/verification_*.csv. Standard library only; about two minutes.
"""
import argparse
import math
import os
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
sys.path.append(os.path.join(ROOT, "scripts", "studies"))  # behind this folder: both have a shell_and_solid.py
import reference_values as exact
import solid_tables
from measured import MeasuredTable
from run_files import rows_of


class Runner:
    def __init__(self, program):
        self.program = os.path.abspath(program)

    def __call__(self, scene, file, *sets):
        """One run; the named table as a list of rows, each a dictionary. None where the run fails."""
        with tempfile.TemporaryDirectory() as folder:
            command = [self.program, os.path.join(ROOT, "prm", scene + ".prm"), "--quiet", "--output", folder,
                       "--set", "Output/Pictures=0"]
            for entry in sets:
                command += ["--set", entry]
            files = [file] if isinstance(file, str) else file
            run = subprocess.run(command, capture_output=True, text=True)
            if run.returncode != 0:
                sys.stderr.write("%s %s: status %d\n%s" % (scene, sets, run.returncode, run.stderr))
                return None
            tables = [self.read(os.path.join(folder, name)) for name in files]
            return tables[0] if isinstance(file, str) else tables

    @staticmethod
    def read(path):
        def number(cell):
            try:
                return float(cell)
            except ValueError:
                return cell
        return [{name: number(cell) for name, cell in row.items()} for row in rows_of(path)]


def error(value, reference):
    return "%.1e" % (value / reference - 1)


def series(sizes, errors, floor=0.):
    """Error and observed order of each member; no order where an error is below the floor that others set."""
    cells, before = [], None
    for size, value in zip(sizes, errors):
        if value is None:
            cells.append("failed")
        elif before is None or not min(abs(before[1]), abs(value)) > floor:
            cells.append("%.1e" % value)
        else:
            cells.append("%.1e (%.1f)" % (value, math.log(abs(before[1] / value)) / math.log(size / before[0])))
        before = None if value is None else (size, value)
    return cells


def mesh_table(run, scene, sizes, quantities, floor, extra=()):
    """Errors over the number of elements for degrees 1 and 2; a quantity is (title, file, function of rows, reference)."""
    rows = []
    for degree in (1, 2):
        errors = [[] for _ in quantities]
        for n in sizes:
            tables = run(scene, [q[1] for q in quantities], "Blank/Degree=%d" % degree, "Blank/Elements=%d" % n, *extra)
            for i, (_, _, value, reference) in enumerate(quantities):
                errors[i].append(value(tables[i]) / reference - 1 if tables else None)
        columns = [series(sizes, e, floor) for e in errors]
        for i, n in enumerate(sizes):
            rows.append([str(degree), str(n)] + [column[i] for column in columns])
    return MeasuredTable(["degree", "elements"] + [q[0] for q in quantities], rows)


def stretch(run):
    first = lambda rows: rows[0]
    rows = []
    for scene, reference, thickness in (
            ("equibiaxial_stretch", exact.equibiaxial_stretch(exact.SWIFT, 69004., .3, .8), 1.),
            ("uniaxial_stretch", exact.uniaxial_stretch(exact.SWIFT, 69004., .3, .8), 1.),
            ("plane_strain_stretch", exact.plane_strain_swift(), 1.)):
        row = first(run(scene, "profile_1.csv"))
        rows.append([scene, error(row["stress_meridional_mid"], reference[0]),
                     error(row["equivalent_plastic_strain"], reference[1]),
                     error(row["thickness"] / thickness, reference[2])])
    return MeasuredTable(["scene", "Kirchhoff stress", "equivalent plastic strain", "thickness"], rows)


def stretch_increments(run):
    """The stress ratio turns while the plastic strain is of the size of the elastic one: the first increments matter."""
    reference = exact.plane_strain_swift()
    sizes, errors, increments = (1, 2, 4, 8, 16), [], []
    for n in sizes:
        rows = run("plane_strain_stretch", ["profile_1.csv", "history.csv"], "Steps/stretch/First increment=%.9g" % (1e-3 / n),
                   "Solver/Growth=%.9g" % (1 + .4 / n))
        errors.append(rows[0][0]["equivalent_plastic_strain"] / reference[1] - 1)
        increments.append(len(rows[1]))
    return MeasuredTable(["first increment, growth", "increments", "plastic strain"],
                    [["%.1e, %.3f" % (1e-3 / n, 1 + .4 / n), str(count), cell]
                     for n, count, cell in zip(sizes, increments, series(sizes, errors))])


def plate_large(run):
    centre = lambda rows: rows[0]["u_z"] / 1e-3
    return mesh_table(run, "clamped_plate_large", (5, 10, 20, 40, 80),
                      [("P = %d" % p, "profile_%d.csv" % p, centre, w)
                       for p, w in ((1, .168034), (5, .679604), (10, 1.051956), (20, 1.493792))], 1e-5)


def plate_linear(run):
    return mesh_table(run, "clamped_plate_linear", (5, 10, 20, 40, 80),
                      [("w0 with shear", "profile_1.csv", lambda rows: rows[0]["u_z"] / 1e-7, 178.425)], 1e-8)


def cylinder(run):
    """Uniform meshes, with a node at z = 8."""
    def at(place):
        return lambda rows: min(rows, key=lambda row: abs(row["z"] - place))["u_r"] / .01
    quantities = []
    for name, file, moment, force in (("moment", "profile_1.csv", 1., 0.), ("force", "profile_2.csv", 0., 1.)):
        for place in (0., 8.):
            quantities.append(("%s, z = %g" % (name, place), file, at(place),
                               exact.cylinder_edge(100., 1., 2.1e5, .3, moment, force, place)[2]))
    return mesh_table(run, "cylinder_edge_loads", (10, 20, 40, 80, 160), quantities, 1e-6, ["Blank/Grading=1"])


def cylinder_thickness(run):
    rows = []
    for ratio in (100, 1000):
        for name, file, moment, force in (("moment", "profile_1.csv", 1., 0.), ("force", "profile_2.csv", 0., 1.)):
            load = .01 if ratio == 100 else 1e-5
            value = run("cylinder_edge_loads", file, "Blank/Thickness=%.9g" % (100 / ratio), "Blank/Elements=80",
                        "Loads/moment/Value=0: 0, 1: %g, 2: 0" % load, "Loads/force/Value=1: 0, 2: %g" % load)[0]["u_r"] / load
            _, thin, thick = exact.cylinder_edge(100., 100. / ratio, 2.1e5, .3, moment, force)
            rows.append([str(ratio), name, "%.7g" % value, "%.7g" % thick, error(value, thick), "%.7g" % thin, error(value, thin)])
    return MeasuredTable(["R/h", "load", "w/load", "with shear deformation", "error", "thin shell", "difference"], rows)


def elastica(run):
    tip = lambda rows: rows[-1]["u_z"]
    return mesh_table(run, "elastica", (5, 10, 20, 40, 80),
                      [("P = %d" % p, "profile_%d.csv" % p, tip, exact.elastica(p)) for p in (1, 2, 5, 10)], 5e-6)


def springback(run):
    sizes, columns = (3, 5, 7, 9, 11, 13, 15), []
    for rule in ("gauss", "lobatto"):
        radii = [50. / run("springback_bending", "profile_2.csv", "Blank/Layers=%d" % layers,
                           "Blank/Layer rule=" + rule)[-1]["rotation"] for layers in sizes]
        columns.append(["%.5f" % radius for radius in radii])
        columns.append(series(sizes, [radius / exact.SPRINGBACK_FIBRES - 1 for radius in radii]))
    return MeasuredTable(["layers", "R' Gauss", "error", "R' Lobatto", "error"],
                    [[str(layers)] + [column[i] for column in columns] for i, layers in enumerate(sizes)])


def ratio_of(rows, degrees):
    last = rows[-1]
    return last["drum_force_r"] / 100 if degrees == 90 else -last["drum_force_z"] / 100 - 1


def capstan(run):
    rows = []
    for friction in (.1, .2, .3):
        for degrees in (90, 180):
            reference = exact.capstan(friction, math.radians(degrees), 50., 1.)
            value = ratio_of(run("capstan_%d" % degrees, "history.csv", "Tools/drum/Friction coefficient=%g" % friction), degrees)
            rows.append(["%g" % friction, str(degrees), "%.6f" % value, "%.6f" % reference, error(value, reference)])
    return MeasuredTable(["mu", "wrap", "T2/T1", "exact", "error"], rows)


def capstan_series(run):
    """A hundredth of the tension: the strip stretches, moves and bends a hundred times less, so that the mesh is seen."""
    rows, sizes, deltas = [], (25, 50, 100, 200), ("1e-2", "1e-4", "1e-6")
    reference = exact.capstan(.2, math.pi / 2, 50., 1.)
    for degree in (1, 2):
        columns = []
        for delta in deltas:
            errors = []
            for n in sizes:
                table = run("capstan_90", "history.csv", "Blank/Elements=%d" % n, "Blank/Degree=%d" % degree,
                            "Loads/tension/Value=0: 0, 1: -1, 2: -1", "Supports/draw/Value=0: 0, 1: 0, 2: 5e-4",
                            "Contact/Allowed elastic slip=1e-5*thickness", "Contact/Allowed penetration=%s*thickness" % delta)
                errors.append(ratio_of(table, 90) * 100 / reference - 1 if table else None)
            columns.append(series(sizes, errors, 1.5e-5))
        rows += [[str(degree), str(n)] + [column[i] for column in columns] for i, n in enumerate(sizes)]
    return MeasuredTable(["degree", "elements"] + ["delta = %s h" % delta for delta in deltas], rows)


TABLES = {"stretch": stretch, "stretch increments": stretch_increments, "plate large": plate_large,
          "plate linear": plate_linear, "cylinder": cylinder, "cylinder thickness": cylinder_thickness,
          "elastica": elastica, "springback": springback, "capstan": capstan, "capstan series": capstan_series}
TABLES.update(solid_tables.make(MeasuredTable, series))


TITLES = {
    "stretch": "1: stretch to a logarithmic strain of .8 (Swift's law): relative errors",
    "stretch increments": "1: plane-strain stretch over the first increments: relative error of the plastic strain (observed order)",
    "plate large": "4: clamped circular plate, large deflection: relative error of the centre deflection (observed order)",
    "plate linear": "5: clamped circular plate, linear: relative error of the centre deflection (observed order)",
    "cylinder": "6: long cylinder with edge loads, R/h = 100: relative error of the radial displacement (observed order)",
    "cylinder thickness": "6: long cylinder: displacement of the loaded edge against theories with and without shear deformation",
    "elastica": "7: elastica: relative error of the tip's deflection under P L^2/(E'I) (observed order)",
    "springback": "9: springback after pure bending: radius over the number of layers, relative error (observed order)",
    "capstan": "16: belt friction, tension 100 per unit width: ratio of the tensions and its relative error",
    "capstan series": "16: belt friction, a hundredth of the tension: relative error over the mesh (observed order)",
    "thick sphere": "2: thick sphere, elastic-plastic: relative error of the outer displacement (observed order)",
    "thick cylinder": "3: thick cylinder at large strain: relative error of the radial stress at the inner wall",
    "thick cylinder mesh": "3: thick cylinder: error of the mesh alone, against 80 elements of degree 2 (observed order)",
    "necking": "8: necking of a round bar at an elongation of 4: force and r/R (relative error)",
    "contact patch": "10: contact patch test: largest relative deviation of a nodal contact pressure",
    "hertz": "11 sphere, 12 cylinder, 13 flat punch: relative errors of force and largest pressure (observed order)",
    "delta": "11: sphere, adaptive penalty: largest penetration [mm] and relative change of the force against the active set",
    "half space": "11 and 13, degree 2, active set: uniform and refined meshes, relative errors",
    "half space delta": "11 refined, rule adaptive: relative errors over delta [mm]",
    "greco": "14: stick, slip and separation: u_x of the bottom [micrometre]",
    "indentation": "17: elastic-plastic indentation: F/(2 pi d) [N/mm]",
    "upsetting": "18: upsetting: forces, iterations and cutbacks",
    "stretching": "19: hemispherical stretching: forces (difference to the solid with 160 x 2), "
        "thickness strain at 40 mm, largest difference",
    "stretching published": "19: hemispherical stretching, mu = 0: forces [kN] at the published "
        "travels (difference to the published force)",
    "stretching refined": "19: solid refined during the run, mu = 0: forces (difference to 160 x 2), penetrations [mm], energy error",
    "cup models": "20: cup, shell and solid: force, thickness strain, draw-in"}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("tables", nargs="*", metavar="TABLE", help="one of: " + ", ".join(TABLES))
    parser.add_argument("--write", action="store_true", help="renew doc/measured/verification_*.csv")
    options = parser.parse_args()
    unknown = [name for name in options.tables if name not in TABLES]
    if unknown:
        parser.error(f"there is no table '{unknown[0]}'")
    run = Runner(options.program)
    for name in options.tables or TABLES:
        table = TABLES[name](run)
        print(f"{TITLES[name]}\n{table}\n", flush=True)
        if options.write:
            table.write("verification_" + name, TITLES[name])


if __name__ == "__main__":
    main()
