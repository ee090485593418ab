#!/usr/bin/env python3
"""The data of a report against the tables of the run, read with nothing of the project. Standard library only.

    tests/report/data.py PROGRAM REPORT_SCRIPT SCENE WORK_FOLDER
"""
import base64
import csv
import glob
import gzip
import json
import math
import os
import re
import shutil
import subprocess
import sys
import unittest

PROGRAM = SCRIPT = SCENE = WORK = None


def report(*folders):
    """The exit status, what was said, and the runs in the page."""
    library = os.path.join(WORK, "library.js")
    with open(library, "w", encoding="utf-8") as file:
        file.write("var Plotly;")
    path = os.path.join(WORK, "report.html")
    done = subprocess.run([sys.executable, SCRIPT, *folders, "--file", path, "--plotly", library], capture_output=True, text=True)
    if done.returncode != 0:
        return done.returncode, done.stderr, None
    with open(path, encoding="utf-8") as file:
        page = file.read()
    packed = {name: gzip.decompress(base64.b64decode(letters)).decode()
              for name, letters in re.findall(r'<script type="application/gzip" id="(\w+)">([^<]*)</script>', page)}
    assert packed["library"] == "var Plotly;"
    assert not re.search(r'(src|href)="(?!data:)', page), "the page loads something"
    return 0, done.stdout, json.loads(packed["data"])


def rows_of(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


class Data(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = os.path.join(WORK, "run")
        subprocess.run([PROGRAM, SCENE, "--quiet", "--output", cls.folder, "--set", "Steps/form/End time=.4", "--set", "Output/Travels=.2, .4",
                        "--set", "Output/Pictures=8", "--set", "Tools/holder/Force=.2"], check=True)
        cls.status, cls.said, cls.runs = report(cls.folder)
        cls.run_ = cls.runs[0]

    def same(self, columns, path):
        rows = rows_of(path)
        self.assertEqual(set(columns), set(rows[0]))
        for name, values in columns.items():
            self.assertEqual(len(values), len(rows))
            for value, row in zip(values, rows):
                word = row[name]
                self.assertEqual(value, float(word) if isinstance(value, float) else word, f"{path}: {name}")

    def test_tables(self):
        self.same(self.run_["history"]["columns"], os.path.join(self.folder, "history.csv"))
        self.assertEqual(self.run_["history"]["units"]["punch_force_z"], "tonf")
        self.assertEqual([state["travel"] for state in self.run_["states"]], [.2, .4])
        for state in self.run_["states"]:
            self.same(state["profile"]["columns"], os.path.join(self.folder, f"profile_{state['travel']:g}.csv"))
            self.same(state["contact"]["columns"], os.path.join(self.folder, f"contact_{state['travel']:g}.csv"))
        self.assertEqual(self.run_["main_tool"], "punch")

    def test_film(self):
        frames, fields = self.run_["film"]["frames"], [name for name, _ in self.run_["film"]["fields"]]
        self.assertEqual(len(frames), 9)
        with open(os.path.join(self.folder, "scene.pvd"), encoding="utf-8") as file:
            times = sorted(set(float(time) for time in re.findall(r'timestep="([^"]*)"', file.read())))
        self.assertEqual([frame["time"] for frame in frames], times)
        last = frames[-1]
        self.assertEqual(last["time"], self.run_["history"]["columns"]["time"][-1])
        for frame in frames:
            for values in frame["values"]:
                self.assertEqual(4 * len(values), len(frame["cells"]))
            self.assertLess(max(frame["cells"]), len(frame["r"]))
        # Outlines, contact and thickness are those of the tables at the same time.
        lines = rows_of(os.path.join(self.folder, "tools_0.4.csv"))
        for tool, (r, z) in last["tools"].items():
            own = [(float(row["r"]), float(row["z"])) for row in lines if row["tool"] == tool]
            self.assertEqual(len(own), len(r))
            for (one, other), x, y in zip(own, r, z):
                self.assertTrue(math.isclose(one, x, rel_tol=1e-4, abs_tol=1e-6) and math.isclose(other, y, rel_tol=1e-4, abs_tol=1e-6))
        self.assertEqual(set(last["tools"]), {"punch", "die", "holder"})
        contact = rows_of(os.path.join(self.folder, "contact_0.4.csv"))
        worst = max(float(row["penetration"]) / float(row["delta"]) for row in contact)
        self.assertAlmostEqual(max(last["values"][fields.index("penetration_over_delta")]), worst, delta=1e-3)
        profile = rows_of(os.path.join(self.folder, "profile_0.4.csv"))
        thickness = [float(row["thickness"]) for row in profile]
        for value in last["values"][fields.index("thickness")]:
            self.assertTrue(min(thickness) - 1e-4 <= value <= max(thickness) + 1e-4)
        self.assertAlmostEqual(min(last["z"]), min(float(row["z"]) - float(row["thickness"]) / 2 for row in profile), delta=1e-4)

    def test_scene_and_cost(self):
        self.assertEqual(self.run_["scene"]["Tools/holder/Force"], ".2")
        self.assertEqual(self.run_["scene"]["Blank/Elements"], "50")
        with open(os.path.join(self.folder, "scene.prm"), encoding="utf-8") as file:
            n_entries = sum(line.strip().startswith("set ") for line in file)
        self.assertEqual(len(self.run_["scene"]), n_entries)
        with open(os.path.join(self.folder, "summary.json"), encoding="utf-8") as file:
            self.assertEqual(self.run_["summary"], json.load(file))
        self.assertEqual(len(self.run_["cuts"]), self.run_["summary"]["cutbacks"])
        self.assertGreater(len(self.run_["timing"]["sections"]), 5)

    def test_the_limit_of_the_sheet(self):
        self.assertIsNone(self.run_["limit"])
        folder = os.path.join(WORK, "limited")
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(self.folder, folder)
        with open(os.path.join(folder, "fld.csv"), "w", encoding="utf-8") as file:
            file.write("# forming limit of a scene, logarithmic strains\nminor_strain,major_strain\n-.1,.3\n0,.2\n")
        self.assertEqual(report(folder)[2][0]["limit"], {"minor": [-.1, 0], "major": [.3, .2]})

    def test_cuts_have_their_causes(self):
        folder = os.path.join(WORK, "cut")
        subprocess.run([PROGRAM, SCENE, "--quiet", "--output", folder, "--set", "Solver/Maximal iterations=5", "--set", "Output/Pictures=0"],
                       capture_output=True)
        one = report(folder)[2][0]
        self.assertGreater(len(one["cuts"]), 0)
        self.assertEqual(len(one["cuts"]), one["summary"]["cutbacks"])
        for cut in one["cuts"]:
            self.assertIn("Newton did not converge", cut["why"])
        self.assertEqual(one["film"]["frames"], [])

    def test_a_killed_run(self):
        folder = os.path.join(WORK, "killed")
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(self.folder, folder)
        for name in ["summary.json", "timing.json", "scene.pvd", *glob.glob(os.path.join(folder, "profile_*"))]:
            os.remove(os.path.join(folder, name))
        with open(os.path.join(folder, "history.csv"), "a", encoding="utf-8") as file:
            file.write("99,form,0.3")
        one = report(folder)[2][0]
        self.assertEqual(one["history"], self.run_["history"])
        self.assertEqual((one["summary"], one["states"]), (None, []))

    def test_a_film_that_is_too_long(self):
        sys.path.insert(0, os.path.dirname(SCRIPT))
        from report_page import data
        runs = [{"film": {"fields": [], "frames": list(range(9))}}, {"film": {"fields": [], "frames": []}}]
        lengths = []
        while data.thin_films(runs):
            lengths.append(runs[0]["film"]["frames"])
        self.assertEqual(lengths, [[0, 2, 4, 6, 8], [0, 4, 8], [0, 8]])
        self.assertTrue(runs[0]["film"]["thinned"])

    def test_two_runs_of_a_name(self):
        self.assertEqual([one["name"] for one in report(self.folder, self.folder)[2]], ["run", "run (2)"])

    def test_what_is_no_run(self):
        status, said, _ = report(os.path.join(WORK, "nowhere"))
        self.assertEqual(status, 1)
        self.assertRegex(said, "there is no history.csv in '.*nowhere'")


if __name__ == "__main__":
    WORK, SCENE, SCRIPT, PROGRAM = (os.path.abspath(sys.argv.pop()) for _ in range(4))
    os.makedirs(WORK, exist_ok=True)
    unittest.main()
