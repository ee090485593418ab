#!/usr/bin/env python3
"""What a scene does not ask for costs nothing: measures it.

    scripts/studies/skip.py [--write] [--build FOLDER] [--only WORD]

For each feature, a scene with and without it:
* instructions of an increment and of a Newton iteration, counted by callgrind: the difference of a long and a short run over
  the difference of their numbers of increments, so that start-up cancels;
* the proof: how often callgrind saw the functions of the feature called over the whole run. Without it never, with it at
  least once, or the status is 1 and the table says so.

--write renews doc/measured/skip.csv. Builds deltaform. Needs valgrind (scripts/setup.sh installs it); ten minutes, most of them under callgrind.
"""
import argparse
import json
import os
import shutil
import subprocess
import sys
import tempfile

from measured import ROOT, MeasuredTable

sys.path.insert(0, os.path.join(ROOT, "tests", "benchmark"))
from callgrind import Counts, callgrind  # noqa: E402

HEAD = ["feature", "scene", "million instructions per increment, without", "with",
        "per iteration, without", "with", "its functions without it"]
NO_CHECKPOINT = "Output/Checkpoint interval=1e6"  # it goes by the clock, which callgrind stretches
QUIET = ["Output/Pictures=0", "Output/Travels=", NO_CHECKPOINT]


def steps(stage, size):
    """Increments of one size, so that runs with and without a feature have as many."""
    return [f"Steps/{stage}/First increment={size}", f"Steps/{stage}/Largest increment={size}"]


class Feature:
    """One row: a scene, what both runs set, what the feature adds, and the names of its functions (and of those that it must
    not call more often, once the first increments are over)."""

    def __init__(self, name, scene, stage, ends, size, functions, on=(), off=(), common=(), equal=None, ranks=1,
                 output=QUIET):
        self.name, self.scene, self.stage, self.ends, self.functions = name, scene, stage, ends, functions
        self.on, self.off, self.equal, self.ranks = list(on), list(off), equal, ranks
        self.common = [*output, *steps(stage, size), *common]


FAR_TOOL = ["Tools/Names=punch, other", "Tools/other/Shape=plate", "Tools/other/Side=bottom", "Tools/other/Position z=-100"]
NO_FRICTION = [f"Tools/{tool}/Friction coefficient=0" for tool in ("punch", "die", "holder")]
FEATURES = [
    Feature("friction", "prm/cup.prm", "form", (.1, .2), .01,
            r"Coulomb::limit|FrictionLaw::update|InterfaceFriction::|Shape::mean_curvature|Shape::curvature_change", off=NO_FRICTION),
    Feature("plasticity", "prm/pressed_plate.prm", "form", (2, 4), .2,
            r"plane_stress_return|radial_return|PerfectlyPlastic|Elastoplastic::",
            on=["Material/Model=elastoplastic", "Material/Hardening/Law=perfectly plastic", "Material/Hardening/Flow stress=400"]),
    Feature("finite strain", "prm/hertz_sphere.prm", "press", (.5, 1), .125,
            r"LogarithmicStrain::", on=["Blank/Kinematics=finite"],
            common=["Blank/Elements=10", "Blank/Elements through thickness=10"]),
    Feature("second tool, far away", "prm/pressed_plate.prm", "form", (2, 4), .2, r"Plate::", on=FAR_TOOL, equal=r"Curve::project$"),
    Feature("condition number", "prm/cup.prm", "form", (.05, .1), .01,
            r"ConditionReport::|condition::", on=["Output/Condition number every=1"]),
    Feature("pictures (VTU)", "prm/cup.prm", "form", (.1, .2), .01,
            r"write_vtu|PictureObserver::write|::draw$|PictureSeries::add", output=["Output/Travels=", NO_CHECKPOINT],
            on=["Output/Pictures=20"], off=["Output/Pictures=0"]),
    Feature("energies", "prm/cup.prm", "form", (.1, .2), .01,
            r"elastic_energy|thickness_strain_work|stored_energy", off=["Output/Energies=false"]),
    Feature("tool driven by a force", "prm/cup.prm", "form", (.1, .2), .01,
            r"Tool::force$|bring_into_contact|add_elsewhere", on=["Tools/holder/Force=0.2"]),
    Feature("refinement", "prm/upsetting.prm", "press", (.2, .4), .05,
            r"SolidRefinement::mark|SolidRefinement::refine$|estimate_error|SolidTransfer::|ContactInterface::transfer", on=["Blank/Refinement/Criterion=recovery"]),
    Feature("two processes", "prm/upsetting.prm", "press", (.2, .4), .05,
            r"DistributedRows::|MPI_Alltoall|MPI_Allgatherv", ranks=2),
]


def sets(entries):
    return [word for entry in entries for word in ("--set", entry)]


def command(program, feature, entries, end, folder):
    return [program, os.path.join(ROOT, feature.scene), "--quiet", "--output", folder,
            *sets([*feature.common, *entries, f"Steps/{feature.stage}/End time={end}"])]


def load(folder, name):
    with open(os.path.join(folder, name), encoding="utf-8") as file:
        return json.load(file)


class Cost:
    """Of one of the two runs of a feature."""

    def __init__(self, program, feature, entries, ranks, folder):
        launcher = ["mpirun", "--allow-run-as-root", "--oversubscribe", "-np", str(ranks)] if ranks > 1 else []
        counts, summaries = [], []
        for end in feature.ends:
            counts.append(callgrind(command(program, feature, entries, end, folder), launcher))
            summaries.append(load(folder, "summary.json"))
            shutil.rmtree(folder)
        increments = summaries[1]["increments"] - summaries[0]["increments"]
        iterations = summaries[1]["newton_iterations"] - summaries[0]["newton_iterations"]
        instructions = counts[1].total - counts[0].total
        self.per_increment = 1e-6 * instructions / increments
        self.per_iteration = 1e-6 * instructions / iterations
        self.called = counts[1].called(feature.functions)
        self.more = [sum(count.called(feature.equal).values()) for count in counts] if feature.equal else [0, 0]


def proof(feature, without, with_it):
    """Words about the calls, and whether they are as they should be."""
    if without.called:
        return "CALLED WITHOUT IT: " + ", ".join(f"{name} {n}" for name, n in without.called.items()), False
    if not with_it.called:
        return f"NONE OF /{feature.functions}/ IS CALLED WITH IT: nothing is proved", False
    most = with_it.called
    names = sorted(most, key=most.get, reverse=True)[:5]
    if feature.equal:
        more = [cost.more[1] - cost.more[0] for cost in (without, with_it)]
        if more[0] != more[1] or more[0] == 0:
            return f"/{feature.equal}/ CALLED {more[0]} TIMES WITHOUT AND {more[1]} WITH IT in the second half", False
        return f"{feature.equal[:-1]} {more[0]} times in the second half, with it as without", True
    return "0 calls; with it " + ", ".join(f"{name} {most[name]}" for name in names), True


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default=os.path.join(ROOT, "build", "release"), help="build folder")
    parser.add_argument("--program", help="measure this deltaform and build none")
    parser.add_argument("--only", default="", help="features whose name contains this")
    parser.add_argument("--write", action="store_true", help="renew doc/measured/skip.csv")
    options = parser.parse_args()
    program = options.program
    if not program:
        build = os.path.abspath(options.build)
        subprocess.run([os.path.join(ROOT, "scripts", "build.sh"), build, "deltaform"], check=True, stdout=sys.stderr)
        program = os.path.join(build, "deltaform")

    table, good = MeasuredTable(HEAD), True
    with tempfile.TemporaryDirectory() as folder:
        for feature in FEATURES:
            if options.only not in feature.name:
                continue
            without = Cost(program, feature, feature.off, 1, os.path.join(folder, "run"))
            with_it = Cost(program, feature, feature.on, feature.ranks, os.path.join(folder, "run"))
            words, right = proof(feature, without, with_it)
            words += "; instructions of waiting for each other included" if feature.ranks > 1 else ""
            good &= right
            table.add(feature.name, feature.scene, f"{without.per_increment:.2f}", f"{with_it.per_increment:.2f}",
                      f"{without.per_iteration:.3f}", f"{with_it.per_iteration:.3f}", words)
            print(*table.rows[-1], file=sys.stderr, flush=True)
    print(table)
    if options.write:
        table.write("skip", "a scene without and with a feature: instructions, calls")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
