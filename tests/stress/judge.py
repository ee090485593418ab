#!/usr/bin/env python3
"""The judge of the stress test against results made up to be wrong: judge.py FOLDER."""
import json
import math
import pathlib
import shutil
import struct
import sys

import stress
import torn

folder = pathlib.Path(sys.argv[1])
STOPPED = "warning: stage 'form' stopped at time 0.5, in increment 3: Newton did not converge"
SCENE = """subsection Blank
  set Thickness = 1
end
subsection Tools
  set Names = punch, die
  subsection punch
    set Side = top
  end
end
subsection Steps
  set Stages = form
end
"""
# One increment of a punch that presses with 2 along 1: half of the force times travel is its work.
ROW = {"increment": "1", "stage": "form", "time": "1", "punch_travel": "1", "punch_force_z": "-2", "punch_force_r": "0", "die_travel": "0",
       "die_force_z": "2", "die_force_r": "0", "max_penetration": "1e-3", "max_penetration_over_delta": "0.99", "min_thickness": "0.9",
       "tool_work": "-1", "load_work": "0", "epsilon_work": "0", "thickness_work": "0", "elastic_energy": "-1", "plastic_energy": "0",
       "friction_energy": "0", "contact_energy": "0", "energy_error": "0"}
failures = 0


def expect(kind, status, said="", summary=None, profile="0.9", picture=None, scene=SCENE, **changed):
    """The judge calls a run this that differs in some columns of its history from one that is in order."""
    global failures
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    row = {**ROW, **changed}
    (folder / "history.csv").write_text("# units\n" + ",".join(row) + "\n" + ",".join(row.values()) + "\n")
    (folder / "profile_1.csv").write_text(f"# units\nR0,thickness\n0,1\n1,{profile}\n")
    (folder / "scene.prm").write_text(scene)
    (folder / "summary.json").write_text(json.dumps({"exit_status": status, "time": 1, **(summary or {})}))
    if picture is not None:
        head = b'<VTKFile><DataArray type="Float32" Name="thickness [mm]" format="appended" offset="0"/>\n<AppendedData encoding="raw">\n_'
        (folder / "blank_0000.vtu").write_bytes(head + struct.pack("=Qf", 4, picture) + b"\n</AppendedData></VTKFile>")
    got = stress.judge({"size": 100.}, folder, status, said, 1., 60.)
    if got[0] != kind:
        failures += 1
        print(f"expected '{kind}', the judge said {got}")


expect("done", 0)
expect("done", 0, max_penetration_over_delta="1.0000005")
expect("promise broken silently", 0, max_penetration_over_delta="1.00001")
expect("done", 0, max_penetration="1e-9", max_penetration_over_delta="1.00001")  # 1e-14 in coordinates of size 100: the last digit
expect("NaN in a result", 0, max_penetration="nan")
expect("NaN in a result", 0, max_penetration="-inf")
expect("NaN in a result", 0, picture=float("nan"))
expect("NaN in a result", 0, picture=float("inf"))
expect("done", 0, picture=1.)
expect("crash", -11)
expect("crash", 1, "deltaform: an error of the program, please report it:")
expect("crash", 134)
expect("hang", None)
expect("stopped", 2, STOPPED)
expect("stopped", 3, STOPPED)
expect("necks", 2, STOPPED + " The node 3 at R0 = 1 necks: ...")
expect("necks", 2, "warning: Blank: the shortest element is 0.1 long\n" + STOPPED + " The node 3 at R0 = 1 necks: ...")
expect("status and message disagree", 2)
expect("status and message disagree", 0, STOPPED)
expect("status and message disagree", 0, summary={"time": .5})
expect("status and message disagree", 1, "nothing")
expect("refused", 1, "deltaform: scene.prm:3: Blank/Thickness = 0: must be positive")

# Done, and wrong: not without a warning.
WARNED = {"warnings": ["thinnest point .2 of the initial thickness"]}
WRONG = (dict(die_force_z="2.01"), dict(elastic_energy="-0.9", energy_error="-0.1"), dict(elastic_energy="-0.9"), dict(tool_work="-1.01", elastic_energy="-1.01"),
         dict(min_thickness="0.3"), dict(profile="0.3"))
for changes in WRONG:
    expect("wrong without a word", 0, **changes)
    expect("wrong without a word", 0, summary={"warnings": []}, **changes)
    expect("done", 0, summary=WARNED, **changes)
expect("done", 0, die_force_z="2.0001")
expect("done", 0, elastic_energy="-0.995", energy_error="-0.005")
expect("done", 0, profile="0.34", min_thickness="0.34")
# With supports, too.
HELD = SCENE + "subsection Supports\n  set Names = rim z\n  subsection rim z\n    set Component = z\n  end\nend\n"
expect("done", 0, scene=HELD, die_force_z="0", rim_z_reaction="-2")
expect("wrong without a word", 0, scene=HELD, die_force_z="0", rim_z_reaction="-1.9")
# Stopped runs say that they are not whole: they are not judged by it.
expect("stopped", 2, STOPPED, die_force_z="2.01")

# Is the sheet of a run that stopped torn? Swift's curve K (e0 + e)^n: uniform strain n - e0, strength K n^n exp(e0 - n).
SWIFT = {"Law": "swift", "Strength coefficient": "500", "Prestrain": "0.01", "Hardening exponent": "0.2"}
uniform, strength = torn.tension(torn.flow_curve(SWIFT))
if abs(uniform - .19) > 1e-9 or abs(strength / (500 * .2 ** .2 * math.exp(-.19)) - 1) > 1e-9:
    failures += 1
    print(f"of Swift's curve uniform strain and strength are said to be {uniform}, {strength}")
STRIP = """subsection Blank
  set Thickness = 1
  set Symmetry = plane strain
end
subsection Material
  subsection Hardening
    set Law = swift
    set Strength coefficient = 500
    set Prestrain = 0.01
    set Hardening exponent = 0.2
  end
end
""" + SCENE[SCENE.index("subsection Tools"):]
WALL = 2 / math.sqrt(3) * strength
for is_torn, changes in ((False, {}), (False, dict(min_thickness="0.63")), (True, dict(min_thickness="0.61")),
                         (False, dict(punch_force_z=f"{-.96 * WALL}")), (True, dict(punch_force_z=f"{-.98 * WALL}"))):
    expect("stopped", 2, STOPPED, scene=STRIP, **changes)
    if bool(stress.torn_by(folder)) != is_torn:
        failures += 1
        print(f"a strip with {changes} is {'not ' if is_torn else ''}torn, says '{stress.torn_by(folder)}'")
if torn.tension(torn.flow_curve({"Law": "perfectly plastic", "Flow stress": "3"})) != (0., 3.):
    failures += 1
    print("a perfectly plastic bar necks at once, at its flow stress")

# What the tables count.
for text, kind in (("thinnest point .2 of the initial thickness", "thinnest point"), ("forces: out of balance", "forces"),
                   ("release not held (z)", "release not held")):
    if stress.kind_of_warning(text) != kind:
        failures += 1
        print(f"'{text}' is of the kind '{stress.kind_of_warning(text)}'")
scenes = [dict(outcome=outcome, seed=seed, sensible=seed < 3, warnings=warnings) for seed, (outcome, warnings) in enumerate(
    (("done", ["thin: 1", "thin: 2"]), ("done", ["thin: 3", "rigid: 4"]), ("done", []), ("done", ["rigid: 5"]), ("stopped", ["thin: 6"])))]
table, sentence = stress.warned(scenes, "0-4")
if table.rows != [["0-4", "thin", "2", "0", "0, 1"], ["0-4", "rigid", "1", "1", "1, 3"]] or "3 of the 4 scenes" not in sentence:
    failures += 1
    print(f"of the warnings of {scenes} the tables say\n{table}\n{sentence}")
sys.exit(1 if failures else 0)
