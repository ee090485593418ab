#!/usr/bin/env python3
"""New scenes, explained entries, drawings, and sweeps that are printed, stopped and gone on with.

    tests/app/commands.py PROGRAM SCENE WORK_FOLDER

Standard library only.
"""
import csv
import json
import os
import re
import shutil
import subprocess
import sys
import unittest
import xml.etree.ElementTree as xml

PROGRAM = SCENE = WORK = None
SVG = "{http://www.w3.org/2000/svg}"


def run(*words, status=0):
    """What the program says. @p status it must end with; None: any."""
    done = subprocess.run([PROGRAM, *words], capture_output=True, text=True, cwd=WORK)
    assert status is None or done.returncode == status, (words, done.returncode, done.stdout, done.stderr)
    return done.stdout + done.stderr


class Commands(unittest.TestCase):
    def setUp(self):
        shutil.rmtree(WORK, ignore_errors=True)
        os.makedirs(WORK)

    def test_every_template_is_a_scene_that_runs(self):
        kinds = re.findall(r"^(\w+) {2,}[a-z]", run("new"), re.MULTILINE)
        self.assertEqual(kinds, ["cup", "stretch", "bend", "upset"])
        for kind in kinds:
            run("new", kind, kind + ".prm")
            with open(os.path.join(WORK, kind + ".prm"), encoding="utf-8") as file:
                self.assertFalse(re.search(r"[{}]", file.read()), "all gaps are filled")
            run(kind + ".prm", "--check")
            run(kind + ".prm", "--quiet", "--output", kind)
            with open(os.path.join(WORK, kind, "summary.json"), encoding="utf-8") as file:
                summary = json.load(file)
            self.assertEqual(summary["warnings"], [])
            if kind == "bend":
                # The strip has been bent by more than half a right angle, and has not gone through it.
                self.assertTrue(45 < abs(summary["measures"]["bend"]["bend_angle"]) < 90)

    def test_sizes_of_the_user(self):
        run("new", "cup", "cup.prm", "thickness=.8", "punch radius=30", "friction=0")
        with open(os.path.join(WORK, "cup.prm"), encoding="utf-8") as file:
            text = file.read()
        for line in ("set Thickness = 0.8", "set Throat radius        = 31", "set Elements  = 63", "set Friction coefficient = 0\n"):
            self.assertIn(line, text)
        self.assertIn("exists; it is not written over", run("new", "cup", "cup.prm", status=64))
        self.assertIn("there are cup, stretch, bend, upset", run("new", "cap", "a.prm", status=64))
        self.assertIn("the nearest is 'punch radius'", run("new", "cup", "a.prm", "punch radus=3", status=64))
        for value in ("-3", "0", "nan", "x", ""):
            self.assertIn("above 0 is needed", run("new", "cup", "a.prm", f"thickness={value}", status=64))
        self.assertFalse(os.path.exists(os.path.join(WORK, "a.prm")))
        run("new", "cup", "nowhere/a.prm", status=1)

    def test_forming_limit(self):
        # Points as they are given; the cup's metal neither draws nor needs tools for it.
        run("fld", SCENE, "--output", "limit", "--set", "Limits/forming limit/Curve=points",
            "--set", "Limits/forming limit/Points=-0.2 0.45; 0 0.25; 0.3 0.4")
        with open(os.path.join(WORK, "limit", "fld.csv"), encoding="utf-8") as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
        self.assertEqual([(float(row["minor_strain"]), float(row["major_strain"])) for row in rows],
                         [(-.2, .45), (0., .25), (.3, .4)])
        picture = xml.parse(os.path.join(WORK, "limit", "fld.svg"))
        self.assertEqual(len(picture.findall(f".//{SVG}circle")), 3)
        self.assertIn("No scene is named", run("fld", status=64))
        self.assertIn("--vary goes with", run("fld", SCENE, "--vary", "a=1", status=64))
        self.assertIn("it is no function", run("fld", SCENE, "--set", "Limits/forming limit/Curve=points",
                                               "--set", "Limits/forming limit/Points=0 .2; 0 .3", status=1))

    def test_explain(self):
        text = run("explain", "Tools/punch/Friction coefficient")
        for words in ("Coulomb's coefficient", "[0, inf)", "default  0", "pure number"):
            self.assertIn(words, text)
        self.assertEqual(run("explain", "tools/anything/friction Coefficient"), text)
        self.assertIn("(with Shape: die)", run("explain", "Profile radius"))
        self.assertEqual(run("explain", "Friction coefficient").count("Tools/<name>/Friction coefficient"), 1)
        self.assertIn("Steps/<name>/End time", run("explain", "Steps/my stage/End time"))
        self.assertIn("nearest known one is 'Layers'", run("explain", "Layrs", status=64))
        self.assertIn("nearest known one is 'Friction law'", run("explain", "Tools/punch/Friction lwa", status=64))
        self.assertIn("--print-parameters lists all", run("explain", "xyzzy", status=64))
        section = run("explain", "Tools/punch").splitlines()
        self.assertIn("a section with the entries", section[0])
        self.assertTrue({"  Side", "  Shape", "  Motion", "  Fillet radii"} <= set(section))
        self.assertIn("Tools/<name>/Friction coefficient; Tools/<name>/Friction law", run("explain", "friction", status=64))

    def test_drawing(self):
        said = run(SCENE, "--check", "--svg", "cup.svg")
        self.assertIn("is a valid scene", said)
        drawing = xml.parse(os.path.join(WORK, "cup.svg")).getroot()
        groups = {group.get("id"): group for group in drawing.iter(SVG + "g") if group.get("id")}
        self.assertEqual(set(groups), {"blank", "punch", "die", "holder"})
        cells = [[float(x) for x in re.split("[ ,]+", cell.get("points").strip())] for cell in groups["blank"]]
        xs, ys = [x for cell in cells for x in cell[0::2]], [y for cell in cells for y in cell[1::2]]
        # 2.22 by .035.
        self.assertAlmostEqual((max(xs) - min(xs)) / (max(ys) - min(ys)), 2.22 / .035, delta=1)
        start, end = ([float(x) for x in re.split("[ ,]+", line.get("points").strip())] for line in groups["punch"])
        moved = {round(b - a, 1) for a, b in zip(start[1::2], end[1::2])}
        self.assertEqual(len(moved), 1)
        self.assertAlmostEqual(moved.pop() / (max(xs) - min(xs)), 1 / 2.22, delta=.01)  # down by 1 in
        width, height = (float(x) for x in drawing.get("viewBox").split()[2:])
        self.assertTrue(0 < min(xs) and max(xs) < width and 0 < min(ys) and max(ys) < height)
        run(SCENE, "--check", "--svg", "nowhere/cup.svg", status=1)
        # A punch that goes deeper than half of the blank: where its face ends is in the picture.
        run(SCENE, "--check", "--svg", "deep.svg", "--set", "Tools/punch/Motion=2*t")
        deep = xml.parse(os.path.join(WORK, "deep.svg")).getroot()
        lowest = max(float(y) for line in deep.iter(SVG + "polyline") if line.get("stroke-dasharray")
                     for y in re.split("[ ,]+", line.get("points").strip())[1::2])
        self.assertLess(lowest, float(deep.get("viewBox").split()[3]))

    def test_words_that_are_no_commands(self):
        said = run("run", SCENE, status=64)
        self.assertIn("'run' is no command", said)
        self.assertIn("deltaform SCENE.prm", said)

    def test_an_earlier_operation_that_is_missing_or_damaged(self):
        self.assertIn("warning: Start from = first: there is no saved state (first/checkpoint.bin). Run the earlier operation",
                      run(SCENE, "--check", "--set", "Start from=first"))
        os.makedirs(os.path.join(WORK, "first"))
        for content in (b"", b"deltaform ", b"hello", b"deltaform 0.1.0 checkpoint, layout 1, 3 bytes, CRC-32 0\nabc"):
            with open(os.path.join(WORK, "first", "checkpoint.bin"), "wb") as file:
                file.write(content)
            for words in (("--check",), ("--quiet", "--output", "second")):
                said = run(SCENE, *words, "--set", "Start from=first", status=1)
                self.assertIn("--set: Start from = first: the saved state (first/checkpoint.bin) is damaged or was written by "
                              "another version. Run the earlier operation again", said)
                self.assertNotIn("--resume", said)
            other = "another version" if content.startswith(b"deltaform 0.1.0") else "is damaged"
            self.assertIn(other, run(SCENE, "--resume", "--output", "first", status=1))

    def sweep(self, *words, status=0):
        return run("sweep", SCENE, "--set", "Steps/form/End time=.1", "--set", "Output/Pictures=0", "--vary", "Blank/Elements=20:40:10",
                   "--output", "sweep", *words, status=status)

    def table(self):
        with open(os.path.join(WORK, "sweep", "sweep.csv"), newline="", encoding="utf-8") as file:
            return list(csv.DictReader(line for line in file if not line.startswith("#")))

    def test_a_printed_sweep_runs_elsewhere_and_is_collected(self):
        commands = self.sweep("--print").splitlines()
        self.assertEqual(len(commands), 3)
        self.assertFalse(os.path.exists(os.path.join(WORK, "sweep")))
        path = os.path.dirname(PROGRAM) + os.pathsep + os.environ["PATH"]
        for command in commands:
            subprocess.run(["bash", "-c", command], cwd=WORK, env={**os.environ, "PATH": path}, check=True)
        before = {folder: os.stat(os.path.join(WORK, "sweep", folder, "history.csv")).st_mtime_ns for folder in ("run_001", "run_002", "run_003")}
        self.assertIn("3 of 3 runs had ended before", self.sweep("--resume"))
        for folder, time in before.items():
            self.assertEqual(os.stat(os.path.join(WORK, "sweep", folder, "history.csv")).st_mtime_ns, time)
        self.assertEqual([row["Blank/Elements"] for row in self.table()], ["20", "30", "40"])
        self.assertEqual([row["exit_status"] for row in self.table()], ["0", "0", "0"])

    def test_a_stopped_sweep_goes_on(self):
        self.sweep("--quiet")
        whole = self.table()
        # As if it had been stopped in its second run: no summary, and the third was not begun.
        os.remove(os.path.join(WORK, "sweep", "run_002", "summary.json"))
        shutil.rmtree(os.path.join(WORK, "sweep", "run_003"))
        first = os.stat(os.path.join(WORK, "sweep", "run_001", "history.csv")).st_mtime_ns
        self.assertIn("1 of 3 runs had ended before", self.sweep("--resume"))
        self.assertEqual(os.stat(os.path.join(WORK, "sweep", "run_001", "history.csv")).st_mtime_ns, first)
        for before, after in zip(whole, self.table()):
            for name in ("Blank/Elements", "exit_status", "travel", "force_z", "increments", "min_thickness"):
                self.assertEqual(before[name], after[name], name)
        # A run of another scene is not taken for one of this.
        said = run("sweep", SCENE, "--set", "Steps/form/End time=.05", "--set", "Output/Pictures=0", "--vary", "Blank/Elements=20:40:10",
                   "--output", "sweep", "--resume")
        self.assertNotIn("had ended before", said)
        self.assertEqual({float(row["travel"]) for row in self.table()}, {.05})

    def test_a_latin_hypercube(self):
        def rows(*words):
            run("sweep", SCENE, "--set", "Steps/form/End time=.05", "--set", "Output/Pictures=0", "--vary", "Contact/Penalty rule=adaptive,paper",
                "--vary", "Tools/punch/Friction coefficient=.1:.3", "--vary", "Tools/die/Profile radius=.2:.4", "--samples", "10",
                "--quiet", "--output", "sampled", *words, status=None)
            with open(os.path.join(WORK, "sampled", "sweep.csv"), newline="", encoding="utf-8") as file:
                return list(csv.DictReader(line for line in file if not line.startswith("#")))
        first = rows()
        self.assertEqual(len(first), 10)
        # Every tenth of every interval has one sample, and half of the samples have each of two values.
        for name, low, high in (("Tools/punch/Friction coefficient", .1, .3), ("Tools/die/Profile radius", .2, .4)):
            self.assertEqual(sorted(int((float(row[name]) - low) / (high - low) * 10) for row in first), list(range(10)))
        self.assertEqual([row["Contact/Penalty rule"] for row in first].count("paper"), 5)
        # Two entries are not sampled in step, the same seed gives the same samples, and another one others.
        order = [[row[name] for row in sorted(first, key=lambda row: float(row[name]))] for name in
                 ("Tools/punch/Friction coefficient", "Tools/die/Profile radius")]
        self.assertNotEqual([row["run"] for row in sorted(first, key=lambda row: float(row["Tools/punch/Friction coefficient"]))],
                            [row["run"] for row in sorted(first, key=lambda row: float(row["Tools/die/Profile radius"]))], order)
        values = [row["Tools/die/Profile radius"] for row in first]
        self.assertEqual(values, [row["Tools/die/Profile radius"] for row in rows("--seed", "1")])
        self.assertNotEqual(values, [row["Tools/die/Profile radius"] for row in rows("--seed", "2")])

    def test_values_with_commas_and_semicolons(self):
        said = run("sweep", SCENE, "--vary", "Blank/Points={0 0; 2.22 0},{0 0; 2 0}", "--vary", "Output/Travels={.1, .2}", "--print",
                   "--output", "points")
        self.assertEqual([re.search(r"Points=([^']*)'", line).group(1) for line in said.splitlines()], ["0 0; 2.22 0", "0 0; 2 0"])
        self.assertEqual(said.count("Travels=.1, .2'"), 2)
        self.assertIn("stand in braces", run("sweep", SCENE, "--vary", "Tools/punch/Motion=0: 0, 1: 1", "--print", status=1))

    def test_a_law_changed_on_the_command_line(self):
        law = ("--set", "Material/Hardening/Law=voce", "--set", "Material/Hardening/Initial flow stress=6", "--set",
               "Material/Hardening/Saturation stress=30", "--set", "Material/Hardening/Saturation rate=4")
        said = run(SCENE, "--check", *law)
        self.assertIn("is a valid scene", said)
        self.assertEqual(said.count("is not used: it does not go with Material/Hardening/Law = voce"), 4)
        self.assertIn("unknown entry Material/Hardening/Prestrain", run(SCENE, "--check", *law, "--set", "Material/Hardening/Prestrain=1", status=1))
        # The shape of a tool, the yield surface, and a sweep over laws whose constants stand before.
        run(SCENE, "--check", "--set", "Tools/punch/Shape=flat punch", "--set", "Tools/punch/Edge radius=.2")
        run(SCENE, "--check", "--set", "Material/Yield surface/Law=hosford", "--set", "Material/Yield surface/Exponent=8", "--set",
            "Material/Yield surface/r-bar=1.4")
        run("sweep", SCENE, "--set", "Steps/form/End time=.05", "--set", "Output/Pictures=0", *law[2:], "--set", "Material/Hardening/Strength coefficient=40",
            "--set", "Material/Hardening/Prestrain=.01", "--set", "Material/Hardening/Hardening exponent=.3",
            "--vary", "Material/Hardening/Law=voce,swift", "--quiet", "--output", "laws")
        forces = []
        for k, (used, dropped) in enumerate((("Saturation stress", "Prestrain"), ("Prestrain", "Saturation stress"))):
            with open(os.path.join(WORK, "laws", f"run_00{k + 1}", "scene.prm"), encoding="utf-8") as file:
                scene = file.read()
            self.assertIn(f"set {used} =", scene)
            self.assertNotIn(f"set {dropped} =", scene)

    def test_a_metal_by_name(self):
        self.assertRegex(run("--list"), r"Material/Name\n  AA2024-T351 +G\.R\. Johnson")
        with open(SCENE, encoding="utf-8") as file:
            text = file.read()
        start, end = text.index("subsection Material"), text.index("subsection Tools")
        scene = text[:start] + "subsection Material\n  set Name = OFHC copper\nend\n\n" + text[end:]
        with open(os.path.join(WORK, "copper.prm"), "w", encoding="utf-8") as file:
            file.write(scene)
        run("copper.prm", "--quiet", "--set", "Steps/form/End time=.05", "--output", "copper")
        with open(os.path.join(WORK, "copper", "scene.prm"), encoding="utf-8") as file:
            echo = file.read()
        # 117 GPa in long tons-force per square inch of 15.4443 MPa.
        self.assertAlmostEqual(float(re.search(r"set Young's modulus = (\S+)", echo).group(1)), 117e3 / 15.4443, delta=.1)
        run("copper/scene.prm", "--check")


if __name__ == "__main__":
    WORK, SCENE, PROGRAM = (os.path.abspath(sys.argv.pop()) for _ in range(3))
    unittest.main()
