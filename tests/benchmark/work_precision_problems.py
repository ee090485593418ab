"""The problems of work_precision.py: scene, what is measured, the exact answer or the runs to compare with, and the choices."""
import math
from dataclasses import dataclass, field
from typing import Callable, Optional


@dataclass
class Problem:
    key: str
    name: str
    scene: str
    quantities: tuple                #: names, in the order of values
    values: Callable                 #: Outcome -> a list of numbers per quantity
    base: dict                       #: what all lines share, but for what they vary
    lines: dict                      #: name -> [(label, entries)]
    fixed: dict = field(default_factory=dict)
    reference: Optional[list] = None  #: exact values, as of values; else
    overkill: tuple = ()             #: entries of two runs, the second to compare with, the first to tell how good that is
    slow: bool = False


def steps(stage, length, n):
    """About n equal increments."""
    return {f"Steps/{stage}/First increment": f"{length / n:.9g}", f"Steps/{stage}/Largest increment": f"{length / n:.9g}",
            "Solver/Target iterations": 1000}


TWO_STEPS = {"Material/Integration": "two steps"}
EULER = {"Material/Integration": "backward Euler"}


def delta(share, length="thickness"):
    return {"Contact/Allowed penetration": f"{share:g}*{length}"}


def delta_of_edge(share):
    return delta(share, "edge")


def elements(n, degree=1, **more):
    return {"Blank/Elements": n, "Blank/Degree": degree, **more}


def labelled(maker, values, *more):
    return [(f"{value:g}", maker(value, *more)) for value in values]


DRAWN = ("force", "thickness")


def drawn(travels, places):
    """Punch forces at some travels; thickness of some material points at the last. Not the smallest thickness: that of the
    stretched shell is at the pole, on which one node is pressed alone at first touch, and goes on falling with the mesh."""
    def values(run):
        profile = run.profiles[max(run.profiles)]
        return [[run.at("punch_force_z", travel, "punch_travel") for travel in travels],
                [interpolate(profile["R0"], profile["thickness"], place) for place in places]]
    return values


def interpolate(x, y, place):
    above = next(i for i in range(1, len(x)) if x[i] >= place)
    share = (place - x[above - 1]) / (x[above] - x[above - 1])
    return (1 - share) * y[above - 1] + share * y[above]


def rules(softness):
    """The rules beside 'adaptive'; a constant factor needs a value that suits the problem."""
    return [("constant", {"Contact/Penalty rule": "constant", "Contact/Penalty factor": softness}),
            ("compensated", {"Contact/Enforcement": "adaptive compensated"}),
            ("active set", {"Contact/Enforcement": "active set"})]


def stretching_shell(friction):
    def step(n):
        return steps("form", 40., n)
    return Problem(
        key=f"stretching_shell_{friction:g}".replace(".", ""), name=f"19: stretching, shell, mu = {friction:g}", scene="osu_stretching",
        quantities=DRAWN, values=drawn((10., 20., 30., 40.), (20., 30., 40.)), slow=friction > 0,
        fixed={"Tools/punch/Friction coefficient": friction, "Tools/die/Friction coefficient": friction},
        base={**elements(100), **delta(1e-3), **step(100), **TWO_STEPS, "Blank/Layers": 5},
        # Not finer: elements shorter than the thickness see single nodes press, and the thickness drifts by .5 %.
        overkill=({**elements(50, 2), **delta(1e-3), **step(200), "Blank/Layers": 7},
                  {**elements(100, 2), **delta(3e-4), **step(400), "Blank/Layers": 7}),
        lines={
            "elements, degree 1": labelled(elements, (12, 25, 50, 100)),
            "elements, degree 2": labelled(elements, (12, 25, 50), 2),
            "layers": [(str(n), {"Blank/Layers": n}) for n in (2, 3, 5, 7)],
            "increments": labelled(step, (12, 25, 50, 100, 200)),
            "increments, backward Euler": [(label, {**own, **EULER})
                                           for label, own in labelled(step, (12, 25, 50, 100, 200))],
            "delta/thickness": labelled(delta, (1e-1, 3e-2, 1e-2, 1e-3, 1e-4)),
            "rule": rules(1e5),
            "all together": [(f"{n}, {m}, {d:g}", {**elements(n), **step(m), **delta(d), "Blank/Layers": layers})
                             for n, m, d, layers in ((20, 12, 1e-2, 2), (30, 16, 1e-2, 2), (40, 25, 1e-2, 3), (60, 33, 1e-2, 3), (100, 50, 1e-2, 3))],
        })


def stretching_solid(friction):
    def step(n):
        return steps("form", 40., n)
    return Problem(
        key=f"stretching_solid_{friction:g}".replace(".", ""), name=f"19: stretching, solid, mu = {friction:g}", scene="osu_stretching_solid",
        quantities=DRAWN, values=drawn((10., 20., 30., 40.), (20., 30., 40.)), slow=True,
        fixed={"Tools/punch/Friction coefficient": friction, "Tools/die/Friction coefficient": friction},
        base={**elements(80, 2), "Blank/Elements through thickness": 1, **delta_of_edge(1e-3), **step(50), **TWO_STEPS},
        overkill=({**elements(80, 2), "Blank/Elements through thickness": 2, **delta_of_edge(3e-4), **step(100)},
                  {**elements(160, 2), "Blank/Elements through thickness": 2, **delta_of_edge(1e-4), **step(200)}),
        lines={
            "elements, degree 2, one across": labelled(elements, (20, 40, 80), 2),
            "elements, degree 1, two across": [(str(n), {**elements(n, 1), "Blank/Elements through thickness": 2}) for n in (40, 80, 160)],
            "across": [(str(n), {"Blank/Elements through thickness": n}) for n in (1, 2)],
            "increments": labelled(step, (12, 25, 50, 100)),
            "delta/edge": labelled(delta_of_edge, (1e-1, 1e-2, 1e-3)),
            "all together": [(f"{n}, {m}, {d:g}", {**elements(n, 2), **step(m), **delta_of_edge(d)})
                             for n, m, d in ((20, 12, 3e-2), (30, 16, 1e-2), (40, 25, 1e-2), (60, 25, 3e-3))],
        })


def cup():
    def step(n):
        return steps("form", 1., n)
    return Problem(
        key="cup", name="20: cup", scene="cup", quantities=DRAWN, values=drawn((.4, .6, .8, 1.), (.3, .6, .9, 1.2, 1.5, 1.8)),
        fixed={"Output/Travels": "0.2, 0.4, 0.6, 0.8, 1"},
        base={**elements(100), **delta(1e-3), **step(100), **TWO_STEPS, "Blank/Layers": 7},
        overkill=({**elements(800), **delta(1e-3), **step(200), "Blank/Layers": 9},
                  {**elements(1600), **delta(1e-3), **step(400), "Blank/Layers": 9}),
        lines={
            "elements, degree 1": labelled(elements, (25, 50, 100, 200, 400)),
            "elements, degree 2": labelled(elements, (15, 25, 50, 100, 200), 2),
            "layers": [(str(n), {"Blank/Layers": n}) for n in (2, 3, 5, 7)],
            "increments": labelled(step, (25, 50, 100, 200)),
            "increments, backward Euler": [(label, {**own, **EULER})
                                           for label, own in labelled(step, (25, 50, 100, 200))],
            "delta/thickness": labelled(delta, (1e-1, 3e-2, 1e-2, 1e-3, 1e-4)),
            "rule": rules(1e5),
            "all together": [(f"{n}, {m}, {d:g}", {**elements(n), **step(m), **delta(d), "Blank/Layers": layers})
                             for n, m, d, layers in ((25, 25, 1e-2, 3), (40, 30, 1e-2, 3), (60, 40, 1e-2, 3), (100, 50, 1e-2, 5), (200, 100, 1e-2, 5),
                                                     (400, 100, 3e-3, 5), (400, 200, 3e-3, 5), (800, 200, 1e-2, 5))],
        })


def hertz(exact):
    del exact  # F = 4/3 E* sqrt(R) d^1.5 is that of the half-space; the finite block's boundary is good to 1e-3 of it
    def mesh(n, degree):
        return {**elements(n, degree), "Blank/Elements through thickness": n}
    def penalty(value):
        return {"Contact/Enforcement": "penalty", "Contact/Penalty rule": "adaptive", "Contact/Allowed penetration": f"{value:g}"}
    def step(n):
        return steps("press", 1., n)
    return Problem(
        key="hertz", name="11: Hertz, sphere", scene="hertz_sphere", quantities=("force",),
        values=lambda run: [[run.history["sphere_force_z"][-1]]], reference=[[7.326007]],
        base={**mesh(40, 2), **step(1)},
        lines={
            "elements, degree 1": labelled(mesh, (10, 20, 40, 80), 1),
            "elements, degree 2": labelled(mesh, (10, 20, 40), 2),
            "increments": labelled(step, (1, 2, 4)),
            "delta [mm], adaptive": labelled(penalty, (1e-3, 1e-4, 1e-5, 1e-6)),
            "rule": [("auto", {**penalty(0), "Contact/Allowed penetration": "auto"}),
                     ("compensated", {"Contact/Enforcement": "adaptive compensated", "Contact/Allowed penetration": "1e-5"}),
                     ("active set", {"Contact/Enforcement": "active set"})],
            "all together": [(f"{n}, degree 2", {**mesh(n, 2), **step(1)}) for n in (8, 14, 20, 28)],
        })


def sphere(exact):
    del exact
    def mesh(n, degree):
        return {**elements(n, degree), "Blank/Elements through thickness": n}
    def step(n):
        return {**steps("load", 1., n), "Steps/unload/First increment": 1, "Steps/unload/Largest increment": 1}
    return Problem(
        key="sphere", name="2: thick sphere", scene="thick_sphere", quantities=("displacement",),
        values=lambda run: [[run.profiles[1.]["u_r_bottom"][0]]], reference=[[.04712229]], base={**mesh(16, 2), **step(4)},
        lines={
            "elements, degree 1": labelled(mesh, (4, 8, 16, 32), 1),
            "elements, degree 2": labelled(mesh, (2, 4, 8, 16), 2),
            "increments": labelled(step, (1, 2, 4, 20)),
            "all together": [(f"{n} x {m}, degree {degree}", {"Blank/Elements": n, "Blank/Elements through thickness": m, "Blank/Degree": degree, **step(1)})
                             for n, m, degree in ((2, 8, 2), (3, 16, 2), (2, 16, 2), (3, 32, 2))],
        })


def upsetting(exact):
    del exact
    def force(h):
        """Yield in the Kirchhoff stress."""
        stress = 700.
        for _ in range(100):
            stress = 700. + 300. * (math.log(15. / h) - stress / 200e3)
        return stress * math.pi * 100. * 15. / h
    def mesh(n, degree):
        return {**elements(n, degree), "Blank/Elements through thickness": max(1, 3 * n // 2)}
    def step(n):
        return steps("press", 9., n)
    return Problem(
        key="upsetting", name="18: upsetting, smooth", scene="upsetting", quantities=("force",),
        values=lambda run: [[run.at("die_force_z", travel, "die_travel") for travel in (6., 9.)]], reference=[[force(9.), force(6.)]],
        base={**mesh(4, 1), **step(20), **delta_of_edge(1e-5)},
        lines={
            "elements, degree 1": labelled(mesh, (1, 2, 4, 8, 16), 1),
            "elements, degree 2": labelled(mesh, (1, 2, 4, 8), 2),
            "increments": labelled(step, (10, 20, 50)),
            "delta/edge": labelled(delta_of_edge, (1e-2, 1e-3, 1e-4, 1e-5, 1e-6)),
            "all together": [(f"1, {m}, {d:g}", {**mesh(1, 1), **step(m), **delta_of_edge(d)}) for m, d in ((10, 1e-2), (10, 1e-3), (10, 1e-4))],
        })


def capstan(exact):
    def step(n):
        return steps("draw", 1., n)
    def slip(share):
        return {"Contact/Allowed elastic slip": f"{share:g}*thickness"}
    return Problem(
        key="capstan", name="16: capstan", scene="capstan_90", quantities=("tension",),
        values=lambda run: [[run.history["drum_force_r"][-1]]], reference=[[100. * exact.capstan(.2, math.pi / 2, 50., 1.)]],
        base={**elements(50), **step(10), **delta(1e-4)},
        lines={
            "elements, degree 1": labelled(elements, (6, 12, 25, 50, 100)),
            "elements, degree 2": labelled(elements, (6, 12, 25), 2),
            "increments": labelled(step, (2, 5, 10, 20)),
            "delta/thickness": labelled(delta, (1e-1, 1e-2, 1e-3, 1e-4)),
            "elastic slip/thickness": labelled(slip, (1e-1, 1e-2, 1e-3, 1e-4)),
            "all together": [(f"{n}, {m}, {d:g}", {**elements(n), **step(m), **delta(d)}) for n, m, d in ((6, 2, 1e-2), (12, 2, 1e-2), (25, 4, 1e-3))],
        })


def problems(exact):
    return [sphere(exact), hertz(exact), capstan(exact), upsetting(exact), stretching_shell(0.), stretching_shell(.15), cup(),
            stretching_solid(0.), stretching_solid(.15)]
