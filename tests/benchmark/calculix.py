#!/usr/bin/env python3
"""Hertz (11), upsetting (18) and the cup (20, solid) in deltaform and in CalculiX: error against processor time.

    tests/benchmark/calculix.py [--program PROGRAM] [--ccx ccx] [--problem hertz upsetting cup] [--limit SECONDS] [--write]

Meshes, materials, tools and motions are the same in both. In CalculiX a tool is a chain of fixed elements finer than the
sheet's (faces within 1e-6 of the true shape), contact is face-to-face penalty. Both run with one thread; measured
is the processor time of the process, which other work on the machine lengthens least, and the start-up of either (the time of a
job of one element) is taken off. Reports that CalculiX is missing instead of failing. Standard library only.
"""
import argparse
import math
import os
import shutil
import subprocess
import sys
import tempfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(0, os.path.join(ROOT, "scripts", "studies"))
import calculix_input as inp
from measure import Measured, measure
from measured import MeasuredTable

WEDGES = 180  # CalculiX expands axisymmetric elements to a wedge of 2 degrees and prints its reactions


class Deltaform:
    name = "deltaform"

    def __init__(self, program, limit):
        self.program, self.limit = os.path.abspath(program), limit

    def run(self, folder, scene, *sets):
        command = [self.program, os.path.join(ROOT, "prm", scene + ".prm"), "--quiet", "--output", folder,
                   "--set", "Output/Pictures=0"]
        for entry in sets:
            command += ["--set", entry]
        return measure(command, folder, self.limit)

    @staticmethod
    def column(folder, *names):
        path = os.path.join(folder, "history.csv")
        if not os.path.exists(path):
            return []
        with open(path) as stream:
            lines = [line.strip().split(",") for line in stream if not line.startswith("#")]
        places = [lines[0].index(name) for name in names]
        return [tuple(float(cells[i]) for i in places) for cells in lines[1:]]


class CalculiX:
    name = "CalculiX"

    def __init__(self, program, limit):
        self.program, self.limit = program, limit

    def run(self, folder, job):
        with open(os.path.join(folder, "job.inp"), "w") as stream:
            stream.write(job)
        return measure([self.program, "-i", "job"], folder, self.limit)

    @staticmethod
    def forces(folder, nodes):
        """(time, sum of the reactions of a set along z) of every increment, from job.dat."""
        path, found, time, inside = os.path.join(folder, "job.dat"), [], None, False
        if not os.path.exists(path):
            return found
        with open(path) as stream:
            for line in stream:
                words = line.split()
                if "total force" in line:
                    inside = ("set " + nodes.upper() + " ") in line
                    time = float(words[-1])
                elif inside and len(words) == 3:
                    found.append((time, WEDGES * float(words[1])))
                    inside = False
        return found


def at(points, place):
    """Linear interpolation; None where the run has not come so far."""
    for (x0, y0), (x1, y1) in zip(points, points[1:]):
        if x0 <= place <= x1 * (1 + 1e-9):
            return y0 + (y1 - y0) * (min(place, x1) - x0) / (x1 - x0)
    return None


def hertz(deltaform, calculix, folder_of):
    """Force at the approach .005 against Hertz, 4/3 E* sqrt(R) d^1.5 = 7.326007 N."""
    exact = 4. / 3. * 1000. / .91 * math.sqrt(200.) * .005 ** 1.5
    for degree, sizes in ((1, (20, 40, 80, 160)), (2, (10, 20, 40, 80))):
        for n in sizes:
            mesh = "%d x %d, degree %d" % (n, n, degree)
            folder = folder_of()
            cost = deltaform.run(folder, "hertz_sphere", "Blank/Degree=%d" % degree, "Blank/Elements=%d" % n,
                                 "Blank/Elements through thickness=%d" % n, "Steps/press/First increment=1",
                                 "Steps/press/Largest increment=1")
            rows = deltaform.column(folder, "sphere_force_z")
            yield deltaform.name, mesh, cost, rows[-1][0] / exact - 1 if cost.good else None
            if calculix:
                folder = folder_of()
                kind = "CAX4" if degree == 1 else "CAX8"
                cost = calculix.run(folder, inp.hertz(n, kind))
                rows = calculix.forces(folder, "tool")
                yield calculix.name + " " + kind, mesh, cost, abs(rows[-1][1]) / exact - 1 if cost.good and rows else None


def hertz_graded(deltaform, calculix, folder_of):
    """The same force on meshes that are fine under the sphere alone, of degree 2.

    The error depends on where in its element the rim of contact ends: three sizes of the first element show by how much.
    """
    exact = 4. / 3. * 1000. / .91 * math.sqrt(200.) * .005 ** 1.5
    for n, first, steady in ((15, .22, 5), (15, .25, 5), (15, .28, 5), (28, .125, 10)):
        line, ratio = inp.steady_then_growing(n, 50., first, steady)
        mesh = "%d x %d, degree 2, first element %g a" % (n, n, first)
        grading = "max(1,1+%.10g*(50*t/%g-%d))" % (math.log(ratio), first, steady)
        folder = folder_of()
        cost = deltaform.run(folder, "hertz_sphere", "Blank/Degree=2", "Blank/Elements=%d" % n,
                             "Blank/Elements through thickness=%d" % n, "Blank/Grading=" + grading,
                             "Blank/Grading through thickness=" + grading.replace("50*t", "50*(1-t)"),
                             "Steps/press/First increment=1", "Steps/press/Largest increment=1")
        rows = deltaform.column(folder, "sphere_force_z")
        yield deltaform.name, mesh, cost, rows[-1][0] / exact - 1 if cost.good else None
        for stiffness in (1e7, 1e9) if calculix else ():
            folder = folder_of()
            cost = calculix.run(folder, inp.hertz(n, "CAX8", line, stiffness))
            rows = calculix.forces(folder, "tool")
            yield ("%s CAX8, K = %.0e" % (calculix.name, stiffness), mesh, cost,
                   abs(rows[-1][1]) / exact - 1 if cost.good and rows else None)


def cup_through(deltaform, calculix, folder_of):
    """Force at a travel of 1 in; CalculiX with nodes against faces and a soft contact, which it likes best."""
    for scene, elements, across in (("cup", 50, 0), ("cup", 400, 0), ("cup_solid", 60, 2)):
        folder = folder_of()
        sets = ["Blank/Elements=%d" % elements] + (["Blank/Elements through thickness=%d" % across] if across else [])
        cost = deltaform.run(folder, scene, *sets)
        rows = deltaform.column(folder, "punch_force_z")
        mesh = "%d x %d, degree 2" % (elements, across) if across else "shell, %d elements" % elements
        yield deltaform.name, mesh, cost, rows[-1][0] / CUP_THROUGH_REFERENCE - 1 if cost.good else None
    if calculix:
        folder = folder_of()
        cost = calculix.run(folder, inp.cup(60, 2, "CAX8R", 1., 1e4, "NODE TO SURFACE"))
        rows = calculix.forces(folder, "punch")
        yield (calculix.name + " CAX8R, K = 1e4", "60 x 2, degree 2", cost,
               abs(rows[-1][1]) / CUP_THROUGH_REFERENCE - 1 if cost.good and rows else None)


def upsetting(deltaform, calculix, folder_of):
    """Force at 60 % without friction against s(e) A0 h0/h."""
    strain = math.log(15. / 6.)
    for _ in range(50):
        strain = math.log(15. / 6.) - (700. + 300. * strain) / 200e3
    exact = (700. + 300. * strain) * math.pi * 100. * 15. / 6.
    for degree, n in ((1, 10), (1, 20), (1, 40), (2, 5), (2, 10), (2, 20)):
        mesh = "%d x %d, degree %d" % (n, 3 * n // 2, degree)
        folder = folder_of()
        cost = deltaform.run(folder, "upsetting", "Blank/Degree=%d" % degree, "Blank/Elements=%d" % n,
                             "Blank/Elements through thickness=%d" % (3 * n // 2))
        rows = deltaform.column(folder, "die_force_z")
        yield deltaform.name, mesh, cost, rows[-1][0] / exact - 1 if cost.good else None
        # Its force is of first order in the increments also where the strain is uniform.
        for largest in (.05, .01, .0025) if calculix and n == (10, 5)[degree - 1] else (.05,) if calculix else ():
            folder, kind = folder_of(), "CAX4" if degree == 1 else "CAX8R"
            cost = calculix.run(folder, inp.upsetting(n, 3 * n // 2, kind, largest))
            rows = calculix.forces(folder, "tool")
            yield ("%s %s, increments %g" % (calculix.name, kind, largest), mesh, cost,
                   abs(rows[-1][1]) / exact - 1 if cost.good and rows else None)


def rough(deltaform, calculix, folder_of):
    """Force at 40 %, friction .1, against a fine mesh of deltaform: CalculiX seldom gets to 60 %."""
    for degree, n in ((1, 10), (1, 20), (2, 5), (2, 10)):
        mesh = "%d x %d, degree %d" % (n, 3 * n // 2, degree)
        folder = folder_of()
        cost = deltaform.run(folder, "upsetting", "Blank/Degree=%d" % degree, "Blank/Elements=%d" % n,
                             "Blank/Elements through thickness=%d" % (3 * n // 2), "Steps/press/End time=6",
                             "Tools/die/Friction coefficient=0.1", "Output/Travels=")
        rows = deltaform.column(folder, "die_force_z")
        yield deltaform.name, mesh, cost, rows[-1][0] / ROUGH_REFERENCE - 1 if cost.good else None
        for kind in (("CAX4", "CAX4R") if degree == 1 else ("CAX8R",)) if calculix else ():
            for largest in (.02, .005):
                folder = folder_of()
                cost = calculix.run(folder, inp.upsetting(n, 3 * n // 2, kind, largest, 6., .1))
                rows = calculix.forces(folder, "tool")
                if not cost.good and rows:
                    cost.note = (cost.note or "stopped") + " at %.2f mm" % (6. * rows[-1][0])
                yield ("%s %s, increments %g" % (calculix.name, kind, largest), mesh, cost,
                       abs(rows[-1][1]) / ROUGH_REFERENCE - 1 if cost.good and rows else None)


def cup(deltaform, calculix, folder_of):
    """Force at a travel of .6 in against fine meshes of deltaform: there is no closed form."""
    exact = CUP_REFERENCE
    for degree, n, across in ((2, 50, 1), (2, 100, 2), (1, 100, 4), (1, 200, 4)):
        mesh = "%d x %d, degree %d" % (n, across, degree)
        folder = folder_of()
        cost = deltaform.run(folder, "cup_solid", "Blank/Degree=%d" % degree, "Blank/Elements=%d" % n,
                             "Blank/Elements through thickness=%d" % across, "Steps/form/End time=0.6")
        rows = deltaform.column(folder, "punch_travel", "punch_force_z")
        yield deltaform.name, mesh, cost, rows[-1][1] / exact - 1 if cost.good else None
        for kind in (("CAX4", "CAX4R") if degree == 1 else ("CAX8R",)) if calculix else ():
            folder = folder_of()
            cost = calculix.run(folder, inp.cup(n, across, kind, .6))
            rows = [(time, abs(force)) for time, force in calculix.forces(folder, "punch")]
            reached = .6 * rows[-1][0] if rows else 0.
            if not cost.good:
                cost.note = (cost.note or "stopped") + " at %.3f in" % reached
            yield calculix.name + " " + kind, mesh, cost, rows[-1][1] / exact - 1 if cost.good and rows else None


# 1.17761 with 200 x 2, 1.17750 with 400 x 3 elements of degree 2
CUP_REFERENCE = 1.1775
# 2.9191 with 200 x 2 elements of degree 2; the shell with 400 elements: 2.9022
CUP_THROUGH_REFERENCE = 2.919
# 454 280 with 20 x 30, 454 025 with 40 x 60 elements of degree 2
ROUGH_REFERENCE = 454025.
TITLES = {"start_up": "time of a job of one element", "hertz": "11: Hertz, error of the force against time",
          "upsetting": "18: upsetting to 60 %, no friction, error of the force against time",
          "rough": "18: upsetting to 40 %, friction .1, error of the force (454.03 kN) against time",
          "hertz_graded": "11: Hertz, graded meshes, error of the force against time",
         "cup_through": "20: cup to 1 in, error of the force (2.919 tonf) against time",
         "cup": "20: cup, solid, to .6 in, error of the force (1.1775 tonf) against time"}
PROBLEMS = {"hertz": hertz, "hertz_graded": hertz_graded, "cup_through": cup_through, "upsetting": upsetting, "rough": rough, "cup": cup}


def start_up(deltaform, calculix, folder_of):
    """Processor and wall seconds of a job of one element: the least of three."""
    times = {}
    def least(run):
        return min((run() for _ in range(3)), key=lambda cost: cost.processor)
    times[deltaform.name] = least(lambda: deltaform.run(folder_of(), "uniaxial_stretch", "Steps/stretch/End time=1e-3"))
    if calculix:
        times[calculix.name] = least(lambda: calculix.run(folder_of(), inp.one_element()))
    return times


def measured(problem, deltaform, calculix, folder_of):
    """Rows: program, mesh, error (or why there is none), cost."""
    rows = []
    for name, mesh, cost, error in PROBLEMS[problem](deltaform, calculix, folder_of):
        rows.append((name, mesh, cost.note or "no convergence" if error is None else "%+.1e" % error, cost))
        print("%s, %s: %s, %.2f s" % (name, mesh, rows[-1][2], cost.processor), flush=True)
    return rows


def table(rows, times):
    return MeasuredTable(["program", "mesh", "error", "processor time [s]", "without start-up [s]", "wall time [s]"], (
        (name, mesh, error, "%.2f" % cost.processor, "%.2f" % max(0., cost.processor - times[name.split()[0]].processor), "%.2f" % cost.wall)
        for name, mesh, error, cost in rows))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=os.path.join(ROOT, "build", "release", "deltaform"))
    parser.add_argument("--ccx", default="ccx")
    parser.add_argument("--problem", nargs="+", choices=sorted(PROBLEMS), default=sorted(PROBLEMS))
    parser.add_argument("--limit", type=float, default=300., help="seconds of processor time after which a run is given up")
    parser.add_argument("--keep", metavar="FOLDER", help="leave the files of the runs here")
    parser.add_argument("--write", action="store_true", help="renew doc/measured/calculix_*.csv")
    arguments = parser.parse_args()

    deltaform = Deltaform(arguments.program, arguments.limit)
    calculix = CalculiX(arguments.ccx, arguments.limit) if shutil.which(arguments.ccx) else None
    if not calculix:
        print("'%s' is not installed (Debian: calculix-ccx): deltaform alone" % arguments.ccx)
    with tempfile.TemporaryDirectory() as temporary:
        base, count = arguments.keep or temporary, [0]
        def folder_of():
            count[0] += 1
            folder = os.path.join(base, "%03d" % count[0])
            os.makedirs(folder, exist_ok=True)
            return folder
        times = start_up(deltaform, calculix, folder_of)
        rows = {}
        for problem in arguments.problem:
            print(problem, flush=True)
            rows[problem] = measured(problem, deltaform, calculix, folder_of)
        # Before and after: what other work on the machine adds to a start is not to be taken off the runs.
        for name, later in start_up(deltaform, calculix, folder_of).items():
            times[name] = min(times[name], later, key=lambda cost: cost.processor)
        parts = {"start_up": MeasuredTable(["program", "processor time [s]", "wall time [s]"], (
            (name, "%.3f" % t.processor, "%.3f" % t.wall) for name, t in times.items()))}
        parts.update({problem: table(own, times) for problem, own in rows.items()})
    for name, part in parts.items():
        print(part)
        if arguments.write:
            part.write("calculix_" + name, TITLES[name])


if __name__ == "__main__":
    main()
