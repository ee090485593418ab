#!/usr/bin/env python3
"""An operation without tools lets go of what an earlier one has formed: a U-bend in two stages, and in two operations, springs back to
the same shape, with the same forces at its supports, closed balances and the same wall to measure. What the earlier run said is said
again: that it stopped, that it ended with warnings, that it has not come to its end.

    released_operation.py PROGRAM FOLDER
"""
import json
import os
import shutil
import sys

from operations import METAL, Runs, history, steps

HEAD = """set Title = a U-bend that is let go
set Units = mm, N, MPa
subsection Blank
  set Symmetry  = plane strain
  set Points    = 0 0; 90 0
  set Thickness = 1
  set Elements  = 90
end
subsection Output
  set Pictures = 0
  subsection Measures
    set Names = part
    subsection part
      set Kind   = u-bend
      set Margin = 9
      set Leg    = 6
    end
  end
end
""" + METAL
TOOLS = """subsection Tools
  set Names = punch, die, holder
  subsection punch
    set Shape       = flat punch
    set Radius      = 20
    set Edge radius = 4
    set Side        = top
    set Position z  = thickness/2
    set Motion      = 35*t
    set Friction coefficient = 0.1
    set Stages      = form
  end
  subsection die
    set Shape          = die
    set Throat radius  = 21.4
    set Profile radius = 4
    set Side           = bottom
    set Position z     = -thickness/2
    set Friction coefficient = 0.1
    set Stages         = form
  end
  subsection holder
    set Shape        = plate
    set Inner radius = 25.4
    set Side         = top
    set Position z   = thickness/2
    set Force        = 20
    set Friction coefficient = 0.1
    set Stages       = form
  end
end
"""
# The energy that is missing in the first increment of the release goes with the length of the last one before it: 1.4e-3 of the
# elastic energy after .006, 4e-4 after this one.
SHORT = "Steps/form/Largest increment=0.003"
# Increments that end at the same shares of the stage in both runs, however many iterations they take.
EVEN = ("Steps/release/First increment=0.015", "Steps/release/Largest increment=0.015")
MIDDLE = """  subsection middle r
    set Boundary  = start
    set Component = r
  end
  subsection middle rotation
    set Boundary  = start
    set Component = rotation
  end
"""
FLOOR = """  subsection floor
    set Boundary  = start
    set Component = z
    set Hold      = true
    set Stages    = release
  end
"""


def supports(names, text):
    return f"subsection Supports\n  set Names = {names}\n{text}end\n"


def summary(folder):
    with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
        return json.load(file)


def surplus(row):
    """Works minus energies, as far as a row of a history has come."""
    works, energies = ("tool_work", "load_work", "epsilon_work", "thickness_work"), ("elastic_energy", "plastic_energy", "friction_energy", "contact_energy")
    return sum(float(row[name]) for name in works) - sum(float(row[name]) for name in energies)


def demand(holds, words):
    if not holds:
        sys.exit(words)


def same_release(runs):
    """In two stages and in two operations; returns the folder of the first operation and the text of the second."""
    held = supports("middle r, middle rotation, floor", MIDDLE + FLOOR)
    whole, _ = runs.run("whole", HEAD + held + TOOLS + steps(form=1, release=2), SHORT, *EVEN)
    first, _ = runs.run("formed", HEAD + supports("middle r, middle rotation", MIDDLE) + TOOLS + steps(form=1), SHORT)
    second = HEAD + held + steps(release=1)
    let_go, _ = runs.run("let_go", f"set Start from = {first}\n" + second, *EVEN)
    for name in ("theta1", "theta2", "rho", "flange_length"):
        a, b = (summary(folder)["measures"]["part"][name] for folder in (whole, let_go))
        print(f"{name}: {a:.6g} in one run, {b:.6g} in two operations")
        demand(abs(b / a - 1) < 1e-3, f"{name} differs")
    # The forces that fade do their work from their full size on.
    before, after, stored = surplus(history(whole, "form")[-1]), surplus(history(whole, "release")[-1]), history(whole, "form")[-1]["elastic_energy"]
    demand(abs(after - before) < 1e-3 * float(stored), f"in the release {after - before:.3g} of {stored} are missing")
    rows = history(let_go, "release")
    demand(max(float(row["balance_error"]) for row in rows) < 1e-5, "forces do not balance")
    # Of the elastic energy that is let go, as what the first operation has dissipated does not count.
    demand(abs(summary(let_go)["energy_error"]) < 5e-3, f"energy error {summary(let_go)['energy_error']}")
    demand(summary(let_go)["warnings"] == [], f"warnings: {summary(let_go)['warnings']}")
    # Both fade in proportion to the time, so rows at the same share of the stage have the same reactions.
    share, n_compared = [float(row["time"]) for row in rows], 0
    for row in history(whole, "release"):
        k = min(range(len(rows)), key=lambda i: abs(share[i] - (float(row["time"]) - 1)))
        if abs(share[k] - (float(row["time"]) - 1)) < 1e-9:
            a, b = (float(line["middle_r_reaction"]) for line in (row, rows[k]))
            n_compared += 1
            demand(abs(a - b) < 1e-3 * abs(float(rows[0]["middle_r_reaction"])) + 1e-6, f"reactions {a}, {b} at {share[k]}")
    demand(n_compared > 50, f"only {n_compared} rows are at the same share")
    return first, second


def still_formed(runs, first):
    """An operation of one stage with tools is measured as it is, not as it began."""
    held = supports("middle r, middle rotation", MIDDLE)
    flat, _ = runs.run("flat", HEAD + held + TOOLS + steps(form=1), "Tools/punch/Motion=0.001*t")
    formed, _ = runs.run("formed_next", f"set Start from = {flat}\n" + HEAD + held + TOOLS + steps(form=1))
    a, b = (summary(folder)["measures"]["part"]["theta2"] for folder in (first, formed))
    print(f"theta2 under the tools: {a:.6g}, after an operation that does next to nothing {b:.6g}")
    demand(abs(b / a - 1) < 1e-3, "theta2 differs")


def small_forces(runs, second):
    """Of a strip that is hardly bent they fade as well; let go at once they lead elsewhere where they are not as small."""
    little, _ = runs.run("little", HEAD + supports("middle r, middle rotation", MIDDLE) + TOOLS + steps(form=1), "Tools/punch/Motion=1.5*t")
    let_go, _ = runs.run("little_let_go", f"set Start from = {little}\n" + second)
    energy = [float(row["elastic_energy"]) for row in history(let_go, "release")]
    print(f"elastic energy: {energy[0]:.4g}, {energy[len(energy) // 2]:.4g}, {energy[-1]:.4g}")
    demand(energy[0] > 1.2 * energy[len(energy) // 2] > 1.2 * energy[-1], "the forces do not fade")


def said_again(runs, first, second):
    stopped, _ = runs.run("stopped", HEAD + supports("middle r, middle rotation", MIDDLE) + TOOLS + steps(form=1), "Solver/Maximal increments=6",
                          expected=2)
    shutil.copytree(first, killed := os.path.join(runs.folder, "killed"), dirs_exist_ok=True)
    os.remove(os.path.join(killed, "summary.json"))
    warned = shutil.copytree(first, os.path.join(runs.folder, "warned"), dirs_exist_ok=True)
    kept = summary(first)
    kept["warnings"] = ["sharp bend: the sheet bends", "coarse mesh: too coarse"]
    with open(os.path.join(warned, "summary.json"), "w", encoding="utf-8") as file:
        json.dump(kept, file)
    for name, folder, words in (("of_stopped", stopped, "the earlier operation stopped, and the blank begins as it was then: stage 'form' stopped"),
                                ("of_killed", killed, "the earlier operation has not come to its end"),
                                ("of_warned", warned, "which are about this part as well: sharp bend; coarse mesh.")):
        of, said = runs.run(name, f"set Start from = {folder}\n" + second)
        demand(words in said and any(words in warning for warning in summary(of)["warnings"]), f"{name}: '{words}' is not in:\n{said}")


def main():
    runs = Runs(*sys.argv[1:])
    first, second = same_release(runs)
    still_formed(runs, first)
    small_forces(runs, second)
    said_again(runs, first, second)


if __name__ == "__main__":
    main()
