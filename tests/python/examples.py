#!/usr/bin/python3
"""The examples that drive deltaform, each with what its result has to be.

    PYTHONPATH=<build>/python tests/python/examples.py SCRIPTS WORK_FOLDER
"""
import csv
import os
import subprocess
import sys
import unittest

SCRIPTS = WORK = None


def run(name, *options):
    """Run an example; the rows of its table."""
    subprocess.run([sys.executable, os.path.join(SCRIPTS, name + ".py"), "--folder", WORK, *options], check=True)
    with open(os.path.join(WORK, name + ".csv"), newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


class Examples(unittest.TestCase):
    def tearDown(self):
        with open(os.path.join(WORK, self.picture), "rb") as file:
            self.assertEqual(file.read(4), b"\x89PNG")

    def test_process_window(self):
        self.picture = "process_window.png"
        rows = run("process_window", "--points", "3")
        self.assertEqual(len(rows), 9)
        # A harder grip thins more, and with the most friction it tears.
        for friction in {row["friction"] for row in rows}:
            values = [float(row["thinning"]) for row in rows if row["friction"] == friction and row["exit_status"] == "0"]
            self.assertEqual(values, sorted(values))
        self.assertEqual(rows[0]["exit_status"], "0")
        self.assertEqual(rows[-1]["exit_status"], "2")

    def test_fit(self):
        self.picture = "fit_hardening.png"
        known = {"strength coefficient [MPa]": 560, "hardening exponent [-]": .24, "friction coefficient [-]": .12}
        rows = run("fit_hardening")
        self.assertEqual(len(rows), 6)
        for row in rows:
            error = abs(float(row["value"]) - known[row["constant"]])
            # Three standard deviations; 95 % are two.
            self.assertLess(error, 1.5 * float(row["half_width_95"]), row)
        # Strains tell the friction, which the force hardly knows.
        by_force, by_both = (float(row["half_width_95"]) for row in rows if row["constant"].startswith("friction"))
        self.assertLess(by_both, by_force / 4)
        self.assertLess(by_both, .04)

    def test_die_radius(self):
        self.picture = "die_radius.png"
        rows = run("die_radius", "--thinning", ".2")
        self.assertAlmostEqual(float(rows[-1]["thinning"]), .2, delta=1e-3)


if __name__ == "__main__":
    WORK, SCRIPTS = (os.path.abspath(sys.argv.pop()) for _ in range(2))
    os.makedirs(WORK, exist_ok=True)
    unittest.main()
