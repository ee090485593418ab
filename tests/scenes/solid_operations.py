#!/usr/bin/env python3
"""A solid in two operations, the second one on another mesh. A block is upset and released, then upset further. The second operation is
held against runs over both that kept its mesh: from a mesh half and twice as fine, of another degree, one that was refined during the first
operation and goes on as it was, or on a mesh without refinements. What is no part of the block, or of another metal, is refused. What is
measured at the points comes over.

    solid_operations.py PROGRAM FOLDER
"""
import json
import os
import sys

from operations import Runs, history, steps, tools

HEAD = """set Title = operations of a solid
set Units = mm, N, MPa
subsection Blank
  set Kind = solid
  set Symmetry = axisymmetric
  set Points = 0 3.75; 10 3.75
  set Thickness = 7.5
  set Contact top = top, end
end
subsection Material
  set Young's modulus = 200e3
  set Poisson's ratio = 0.3
  subsection Hardening
    set Law                 = linear
    set Initial flow stress = 400
    set Hardening modulus   = 400
  end
end
subsection Supports
  set Names = middle
  subsection middle
    set Boundary  = bottom
    set Component = z
  end
end
subsection Limits
  set Criteria = cockcroft-latham
end
subsection Solver
  set Force tolerance = 1e-8
end
subsection Output
  set Pictures = 0
end
"""
DIE = """  subsection die
    set Shape = plate
    set Side = top
    set Position z = 7.5
    set Motion = {motion}
    set Stages = {stages}
  end
"""
WHOLE = "'0: 0, 2: 2, 2.5: 1.9, 3.5: 2.9'"
MESHES = {"coarse": (8, 6, 1), "fine": (16, 12, 1), "quadratic": (8, 6, 2)}
REFINED = ("Blank/Refinement/Criterion=recovery", "Blank/Refinement/Every=20", "Blank/Refinement/Maximal level=1",
           "Blank/Refinement/Error share=.3")


def entries(mesh, friction, *more):
    along, across, degree = MESHES[mesh]
    return (f"Blank/Elements={along}", f"Blank/Elements through thickness={across}", f"Blank/Degree={degree}",
            f"Tools/die/Friction coefficient={friction}") + more


def scene(motion, stages, **ends):
    return HEAD + tools("die", DIE.format(motion=motion, stages=stages)) + steps(**ends)


def second(first):
    return f"set Start from = {first}\n" + scene("1.9+t", "press", press=1)


def force_at(rows, time):
    """On the line between the increments before and after @p time."""
    after = next(k for k, row in enumerate(rows) if float(row["time"]) >= time)
    (t0, f0), (t1, f1) = [(float(row["time"]), float(row["die_force_z"])) for row in (rows[max(after - 1, 0)], rows[after])]
    return f1 if t1 == time else f0 + (f1 - f0) * (time - t0) / (t1 - t0)


class Pressed:
    """What the second operation says: force, dissipation before (its share of the work is known), criterion."""

    def __init__(self, folder):
        rows = history(folder, "press")
        self.forces = [force_at(rows, float(rows[-1]["time"]) - rest) for rest in (.8, 0)]
        self.stored = float(rows[0]["elastic_energy"])
        self.damage = float(rows[0]["cockcroft_latham"])
        with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
            self.balance = json.load(file)["energy_error"]
        with open(os.path.join(folder, "run.log"), encoding="utf-8") as file:
            self.log = file.read()


def compare(name, found, kept, most_force):
    errors = [a / b - 1. for a, b in zip(found.forces, kept.forces)]
    print(f"{name}: force {found.forces[-1]:.0f}, {errors[-1]:+.1e}, early {errors[0]:+.1e}; criterion {found.damage:.4f} for "
          f"{kept.damage:.4f}; stored energy {found.stored:.3g} for {kept.stored:.3g}; balance {found.balance:.1e}")
    if not (max(map(abs, errors)) < most_force and abs(found.damage / kept.damage - 1.) < .1 and found.balance < 2e-3):
        sys.exit(f"{name}: force, criterion or balance of energies are wrong")


def another_mesh(runs, friction, errors):
    first, kept = {}, {}
    for mesh in MESHES:
        name = f"{mesh}_{friction}"
        first[mesh], _ = runs.run(f"first_{name}", scene("t", "form", form=2, release=2.5), *entries(mesh, friction))
        kept[mesh] = Pressed(runs.run(f"whole_{name}", scene(WHOLE, "form, press", form=2, release=2.5, press=3.5),
                                      *entries(mesh, friction))[0])
        same = Pressed(runs.run(f"same_{name}", second(first[mesh]), *entries(mesh, friction))[0])
        compare(f"same mesh, {name}", same, kept[mesh], 1e-6)
    print(f"coarse over fine: {kept['coarse'].forces[-1] / kept['fine'].forces[-1] - 1.:+.1e}")
    for (start, mesh), most_force in zip((("coarse", "fine"), ("fine", "coarse"), ("fine", "quadratic")), errors):
        name = f"{start}_to_{mesh}"
        folder, _ = runs.run(f"{name}_{friction}", second(first[start]), *entries(mesh, friction))
        pressed = Pressed(folder)
        compare(f"{name}, friction {friction}", pressed, kept[mesh], most_force)
        if "Equilibrium is regained" not in pressed.log:
            sys.exit(f"{name}: no word on equilibrium in\n{pressed.log}")
    return first


def refined(runs, friction):
    """Goes on as in one run; without refinements, as from any other mesh."""
    first, _ = runs.run("first_refined", scene("t", "form", form=2, release=2.5), *entries("coarse", friction, *REFINED))
    whole = Pressed(runs.run("whole_refined", scene(WHOLE, "form, press", form=2, release=2.5, press=3.5),
                             *entries("coarse", friction, *REFINED, "Blank/Refinement/Maximal level=1"))[0])
    compare("refined", Pressed(runs.run("refined", second(first), *entries("coarse", friction, *REFINED))[0]), whole, 2e-4)
    compare("refined, to coarse", Pressed(runs.run("unrefined", second(first), *entries("coarse", friction))[0]), whole, 6e-3)


def under_the_same_die(runs, friction):
    """Nothing is released: the die goes on where it stands, and the forces that held the block give way to its contact at once."""
    first, _ = runs.run("first_held", scene("t", "form", form=2), *entries("coarse", friction))
    whole, _ = runs.run("whole_held", scene("t", "form", form=3), *entries("fine", friction))
    at_once = scene("2+t", "press", press=1).replace("subsection press\n", "subsection press\n    set Release = at once\n")
    held, _ = runs.run("held", f"set Start from = {first}\n" + at_once, *entries("fine", friction))
    forces = [float(history(folder, stage)[-1]["die_force_z"]) for folder, stage in ((held, "press"), (whole, "form"))]
    start = [float(row["die_force_z"]) for row in (history(held, "press")[0], history(first, "form")[-1])]
    print(f"under the same die: force {forces[0]:.0f}, in one run {forces[1]:.0f}, {forces[0] / forces[1] - 1.:+.1e}; "
          f"at the begin {start[0] / start[1] - 1.:+.1e} from the end of the first operation")
    if abs(forces[0] / forces[1] - 1.) > 3e-4 or abs(start[0] / start[1] - 1.) > .02:
        sys.exit("under the same die the force is wrong")


def other_contact_points(runs, first, friction):
    """The block that was touched at its nodes is touched at points of its edges from here on."""
    gauss = "Blank/Contact points=gauss"
    whole = Pressed(runs.run("whole_gauss", scene(WHOLE, "form, press", form=2, release=2.5, press=3.5),
                             *entries("coarse", friction, gauss))[0])
    compare("from nodes to points", Pressed(runs.run("gauss", second(first), *entries("coarse", friction, gauss))[0]), whole, 3e-3)


def main():
    runs = Runs(*sys.argv[1:])
    another_mesh(runs, .05, (1e-4, 1e-4, 5e-4))
    first = another_mesh(runs, .15, (1e-3, 1.2e-3, 7e-3))
    refined(runs, .15)
    under_the_same_die(runs, .15)
    other_contact_points(runs, first["coarse"], .15)
    for name, sets, words in (("longer", ("Blank/Points=0 3.75; 12 3.75",), "no part of the one that was formed"),
                              ("metal", ("Material/Backstress/Law=linear", "Material/Backstress/Hardening modulus=10"), "knew other numbers")):
        _, said = runs.run(name, second(first["coarse"]), *entries("fine", .15, *sets), expected=1)
        if words not in said:
            sys.exit(f"{name}: '{words}' is not in:\n{said}")


if __name__ == "__main__":
    main()
