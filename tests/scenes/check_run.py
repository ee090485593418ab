#!/usr/bin/env python3
"""Checks the files of a run against mechanics, with nothing of the program that wrote them.

    tests/scenes/check_run.py FOLDER...        exit status 1, with a sentence for each finding, if a run is wrong

Read are scene.prm, history.csv, profile_*.csv, contact_*.csv, tools_*.csv, summary.json and blank_*.vtu. Recomputed are

  numbers    no NaN and no infinity in a table or picture
  forces     the blank is in equilibrium in every row of history.csv: in z, and in plane strain in r as well,
             - forces on the tools + reactions + loads = 0 within 1e-4 of the largest force of the row and 1e-6 of the run's
  released   tools that have left exert no force at the end of a stage
  energy     the balance from its parts, and the work of the tools from their forces and travels
  thinnest   the thinnest node of a profile is as thin as the history says
  promise    p <= delta in contact_*.csv; and again from the nodes and outlines (see outlines.py)

A check that the files do not allow is skipped, and the report says why. Standard library only.
"""
import argparse
import sys

import outlines
from run_files import NoRun, Run, not_finite

SHARE = 1e-4    # of the largest force of a row that may be out of balance
FLOOR = 1e-6    # of the largest force of the run: round-off, and rows in which hardly anything is loaded
ENERGY = 0.01   # largest error of the energy balance at the end
DIGITS = 1e-8   # ten digits are printed; sums of some numbers lose two of them
THIN = 0.03     # of the thickness: values at nodes are means of those at the points around


class Report:
    """What the checks found: wrong is a list of sentences, skipped and found are for the reader."""

    def __init__(self):
        self.wrong, self.skipped, self.found = [], [], []


def terms(run, component):
    """The forces on the blank in a direction ('z' or 'r'), each a name and a column; None where a load has no column."""
    history, result = run.history, []
    for tool in run.tools:
        result.append((f"tool '{tool.name}'", [-value for value in history.column(f"{tool.column}_force_{component}")]))
    for support in run.supports:
        if support.entries.get("Component", "z") == component:
            result.append((f"support '{support.name}'", history.column(f"{support.column}_reaction")))
    for load in run.loads:
        if f"{load.column}_force_{component}" not in history:
            return None
        result.append((f"load '{load.name}'", history.column(f"{load.column}_force_{component}")))
    if f"earlier_operation_force_{component}" in history:
        result.append(("the earlier operation", history.column(f"earlier_operation_force_{component}")))
    return result


def force_floor(run):
    """Round-off of a sum of forces: a share of the largest force of the run, in any direction. Moments count by the thickness."""
    history, largest = run.history, 0.
    thickness = float(run.scene["Blank"].get("Thickness") or 1)
    for name in history.names:
        if name.endswith(("_force_z", "_force_r", "_reaction")):
            moment = any(name == f"{support.column}_reaction" and support.entries.get("Component") == "rotation"
                         for support in run.supports)
            largest = max([largest] + [abs(value) / (thickness if moment else 1.) for value in history.column(name)])
    return FLOOR * largest


def share_a_corner(run, component):
    """Do two supports of a solid hold the same component at parts of the boundary that may meet in a corner?

    The force there is part of both reactions. Opposite edges of a strip have no common node.
    """
    if run.scene["Blank"].get("Kind") != "solid":
        return False
    held = [support for support in run.supports if support.entries.get("Component", "z") == component]
    for k, one in enumerate(held):
        for other in held[:k]:
            edges = {one.entries.get("Boundary"), other.entries.get("Boundary")}
            if edges not in ({"start", "end"}, {"bottom", "top"}) and any(
                    one.acts_in(stage) and other.acts_in(stage) for stage in run.stages):
                return True
    return False


def fading_rows(run):
    """Rows of stages in which something fades out whose force the file does not show: all but the last of the stage.

    Such files were written before history.csv showed the forces of what has left. They show zeros there.
    """
    stages, history, result = run.words("stage"), run.history, set()
    for before, stage in zip(run.stages, run.stages[1:]):
        rows = [i for i, name in enumerate(stages) if name == stage]
        last = [i for i, name in enumerate(stages) if name == before][-1:]
        for actors, ending in ((run.tools, "_force_z"), (run.supports, "_reaction"), (run.loads, "_force_z")):
            for actor in actors:
                if not rows or not last or actor.column + ending not in history:
                    continue
                values = history.column(actor.column + ending)
                if actor.acts_in(before) and not actor.acts_in(stage) and values[last[0]] != 0 and \
                        all(values[i] == 0 for i in rows):
                    result.update(rows[:-1])
    return result


def check_forces(run, report, share=SHARE):
    """Equilibrium of the blank in every row."""
    hidden, floor = fading_rows(run), force_floor(run)
    if hidden:
        report.skipped.append(f"forces: {len(hidden)} rows of stages with a release, whose fading forces the file does not show")
    components = {component: terms(run, component) for component in (("z", "r") if run.plane_strain else ("z",))}
    largest = [max([floor] + [abs(values[i]) for forces in components.values() if forces for _, values in forces])
               for i in range(len(run.history))]
    for component, forces in components.items():
        if forces is None:
            report.skipped.append(f"forces in {component}: there are loads, and history.csv has no columns of them")
        elif share_a_corner(run, component):
            report.skipped.append(f"forces in {component}: two supports may share a corner, whose force is in both reactions")
        elif forces:
            shares = {i: abs(sum(values[i] for _, values in forces)) / (share * size + floor)
                      for i, size in enumerate(largest) if i not in hidden and size > 0}
            where = max(shares, key=shares.get, default=None)
            if where is None:
                continue
            report.found.append(f"forces in {component}: at most {shares[where]:.2g} of what is allowed, in {len(shares)} rows")
            if shares[where] > 1:
                parts = ", ".join(f"{name} {values[where]:.6g}" for name, values in forces)
                report.wrong.append(f"forces in {component}: row {where + 1} (stage '{run.words('stage')[where]}', time "
                                    f"{run.history.column('time')[where]:g}) sums to "
                                    f"{sum(values[where] for _, values in forces):.3g}: {parts}")


def check_released(run, report):
    """What has left exerts no force at the end of a stage."""
    stages = run.words("stage")
    for tool in run.tools:
        for component in ("z", "r"):
            values = run.history.column(f"{tool.column}_force_{component}")
            largest = max(map(abs, values), default=0.)
            for stage in run.stages:
                rows = [i for i, name in enumerate(stages) if name == stage]
                # A stage that was not completed has not let go yet.
                ended = stage != run.stages[-1] or (run.summary or {}).get("exit_status") == 0
                if rows and rows[-1] + 1 == len(stages) and not ended:
                    continue
                if rows and not tool.acts_in(stage) and abs(values[rows[-1]]) > 1e-9 * largest:
                    report.wrong.append(f"released: tool '{tool.name}' takes no part in stage '{stage}' and still exerts "
                                        f"{values[rows[-1]]:.3g} in {component} at its end")


def check_energy(run, report):
    """The balance from its parts, and the tools' work from forces and travels."""
    history = run.history
    if "energy_error" not in history:
        report.skipped.append("energy: the scene asks for none (Output/Energies = false)")
        return
    put_in = [history.column(name) for name in ("tool_work", "load_work", "epsilon_work", "thickness_work")]
    kept = [history.column(name) for name in ("elastic_energy", "plastic_energy", "friction_energy", "contact_energy")]
    for i, said in enumerate(history.column("energy_error")):
        given, taken = (sum(column[i] for column in side) for side in (put_in, kept))
        size = max(abs(put_in[0][i]), abs(put_in[1][i]), abs(taken))
        error = (given - taken) / size if size > 0 else 0.
        # The parts are printed to ten digits; the largest of them may be larger than what is left.
        largest = max(abs(column[i]) for column in put_in + kept)
        if size > 0 and abs(error - said) > 1e-9 + DIGITS * largest / size:
            report.wrong.append(f"energy: row {i + 1} says energy_error = {said:.6g}, its parts give {error:.6g}")
            break
    if len(history) and abs(error) > ENERGY:
        report.wrong.append(f"energy: {100 * error:.2g} % of the work are missing at the end, allowed are {100 * ENERGY:g} %")
    if len(history):
        report.found.append(f"energy: {100 * error:.2g} % of the work are missing at the end")
        check_tool_work(run, report)


def check_tool_work(run, report):
    """The trapezoidal sum of - force times travel along the direction, tool by tool. What a tool under a force does in the row in which it
    first touches may be less: most of its way it falls."""
    history, work, falls = run.history, [0.] * len(run.history), [0.] * len(run.history)
    for tool in run.tools:
        default = "0 -1" if tool.entries.get("Side") == "top" else "0 1"
        r, z = map(float, tool.entries.get("Direction", default).split())
        length = (r * r + z * z)**.5
        along = [(r * a + z * b) / length for a, b in zip(history.column(f"{tool.column}_force_r"),
                                                         history.column(f"{tool.column}_force_z"))]
        travel = history.column(f"{tool.column}_travel")
        total, force_before, travel_before = 0., 0., 0.
        for i, stage in enumerate(run.words("stage")):
            if i == 0 and travel[0] != 0 and not tool.acts_in(stage):
                travel_before = travel[0]
            force = along[i] if tool.acts_in(stage) else 0.
            step = -.5 * (force + force_before) * (travel[i] - travel_before)
            total += step
            if tool.entries.get("Force") and abs(force_before) < 1e-3 * abs(force):
                falls[i] += max(step, 0.)
            work[i] += total
            force_before, travel_before = force, travel[i]
    said = history.column("tool_work")
    largest = max(map(abs, said), default=0.)
    fallen = 0.
    for i, (own, theirs) in enumerate(zip(work, said)):
        off = own - fallen - theirs
        if not -1e-6 * largest <= off <= falls[i] + 1e-6 * largest:
            report.wrong.append(f"energy: row {i + 1} says tool_work = {theirs:.8g}, forces and travels give {own - fallen:.8g}")
            return
        fallen += off if falls[i] > 0 else 0.


def check_thinnest(run, report):
    """The thinnest node of each profile against the history."""
    initial = float(run.scene["Blank"]["Thickness"]) if run.scene["Blank"].get("Thickness") else None
    if run.scene["Blank"].get("Kind") == "solid" or initial is None:
        report.skipped.append("thinnest: a solid's profile holds distances between its faces, the history the thinnest column")
        return
    for label, profile in run.tables("profile").items():
        row = run.row_of(profile)
        if row is None or "thickness" not in profile or not len(profile):
            continue
        nodes, said = profile.column("thickness"), run.history.column("min_thickness")[row]
        node = min(nodes)
        # A mean is not thinner than the thinnest point, and not thicker by more than what it changes by from node to node.
        steepest = max((abs(b - a) for a, b in zip(nodes, nodes[1:])), default=0.)
        if node < said - 1e-8 * initial or node > said + max(THIN * initial, steepest):
            report.wrong.append(f"thinnest: the thinnest node of profile_{label}.csv has {node:.6g}, history.csv says {said:.6g}")
        report.found.append(f"thinnest, {label}: node {node:.5g}, point {said:.5g}")


def promises(run):
    """Does the scene promise p <= delta? Only the rule adaptive does, with penalty factors that it chooses."""
    contact = run.scene.get("Contact", {})
    return contact.get("Penalty rule") == "adaptive" and contact.get("Enforcement") == "penalty"


def check_promise(run, report):
    """p <= delta of the rows of contact_*.csv, and whether the history tells the same of that increment."""
    for label, contact in run.tables("contact").items():
        size = max((abs(x) for name in ("r", "z") for x in run.tables("profile")[label].column(name)), default=0.)
        penetration, delta = contact.column("penetration"), contact.column("delta")
        ratios = [p / d for p, d in zip(penetration, delta)]
        if promises(run):
            for p, d, tool, place in zip(penetration, delta, contact.column("tool"), contact.column("S0")):
                if p > d * (1 + 1e-6) + 1e-12 * size:
                    report.wrong.append(f"promise: contact_{label}.csv: node at S0 = {place:g} penetrates '{tool}' by {p:.6g}, "
                                        f"allowed are {d:.6g}")
        row = run.row_of(contact)
        if row is None or run.words("cells" if "cells" in run.history else "stage")[row] == "":
            continue
        said, own = run.history.column("max_penetration_over_delta")[row], max(ratios, default=0.)
        if abs(said - own) > 1e-6 * max(1., said):
            report.wrong.append(f"promise: history.csv says max_penetration_over_delta = {said:.8g} in row {row + 1}, "
                                f"contact_{label}.csv gives {own:.8g}")
        report.found.append(f"promise, {label}: p/delta <= {own:.6g} in {len(contact)} pairs")


def check_numbers(run, report):
    try:
        where = not_finite(run.folder)
    except ValueError as error:
        where = str(error)
    if where:
        report.wrong.append(f"numbers: not finite or not readable: {where}")


def check(folder, share=SHARE):
    """The report on a run. @raise NoRun if the folder holds none."""
    run, report = Run(folder), Report()
    check_numbers(run, report)
    if report.wrong:
        return report  # sums with NaN say nothing
    check_forces(run, report, share)
    for one in (check_released, check_energy, check_thinnest, check_promise):
        one(run, report)
    outlines.check(run, report, promises(run))
    return report


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", metavar="FOLDER", help="of the results of a run")
    parser.add_argument("--share", type=float, default=SHARE, help="of the largest force of a row that may be out of balance; of "
                        "thin sheets Solver/Balance tolerance, 5e-4 (default: %(default)g)")
    parser.add_argument("--quiet", action="store_true", help="findings only")
    arguments = parser.parse_args()
    failed = 0
    for folder in arguments.folders:
        try:
            report = check(folder, arguments.share)
        except NoRun as error:
            report = Report()
            report.wrong.append(str(error))
        failed += bool(report.wrong)
        print(f"{folder}: {'wrong' if report.wrong else 'in order'}")
        for sentence in report.wrong:
            print("  WRONG " + sentence)
        if not arguments.quiet:
            for sentence in report.found + ["skipped " + text for text in report.skipped]:
                print("  " + sentence)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
