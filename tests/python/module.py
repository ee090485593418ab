#!/usr/bin/python3
"""The Python package against the program and its files.

    PYTHONPATH=<build>/python tests/python/module.py PROGRAM SCENE_FOLDER WORK_FOLDER
"""
import csv
import multiprocessing
import os
import pickle
import signal
import subprocess
import sys
import threading
import time
import unittest

import numpy as np

import deltaform

PROGRAM = FOLDER = WORK = None
SHORT = {"Steps/form/End time": .2}
TORN = {"Tools/punch/Friction coefficient": .3, "Tools/die/Friction coefficient": .3,
        "Tools/holder/Friction coefficient": .3, "Tools/holder/Force": 4}


def cup(entries=SHORT):
    return deltaform.Scene(os.path.join(FOLDER, "cup.prm"), entries)


def by_program(name, entries, *options):
    """Run the program; the folder of its results."""
    folder = os.path.join(WORK, name)
    sets = [word for entry, value in entries.items() for word in ("--set", f"{entry}={value}")]
    subprocess.run([PROGRAM, os.path.join(FOLDER, "cup.prm"), "--quiet", "--output", folder, *sets, *options],
                   capture_output=True)
    return folder


def csv_table(path):
    """Columns of a file, its units, read without anything of the project."""
    with open(path, newline="", encoding="utf-8") as file:
        lines = file.read().splitlines()
    units = next(line for line in lines if line.startswith("# units: "))[len("# units: "):].split(",")
    rows = list(csv.reader(line for line in lines if not line.startswith("#")))
    return {name: [row[i] for row in rows[1:]] for i, name in enumerate(rows[0])}, dict(zip(rows[0], units))


def force(friction, folder=None):
    global FOLDER
    FOLDER = folder or FOLDER  # where the process is a new one
    return cup({**SHORT, "Tools/punch/Friction coefficient": friction}).run().history["punch_force_z"][-1]


class Module(unittest.TestCase):
    def check_table(self, table, path):
        columns, units = csv_table(path)
        self.assertEqual(table.names, list(columns))
        self.assertEqual(table.units, units)
        for name, cells in columns.items():
            if table[name].dtype.kind == "f":
                # Ten digits are written.
                self.assertEqual([f"{value:.10g}" for value in table[name]], [f"{float(cell):.10g}" for cell in cells], name)
            else:
                self.assertEqual(list(table[name]), cells)

    def test_results_are_those_of_the_files(self):
        entries = {"Steps/form/End time": .3, "Output/Travels": ".1, .3"}
        folder = by_program("files", entries)
        run = cup(entries).run()
        self.check_table(run.history, os.path.join(folder, "history.csv"))
        for travel in (.1, .3):
            self.check_table(run.profile(travel), os.path.join(folder, f"profile_{travel}.csv"))
            self.check_table(run.contact(travel), os.path.join(folder, f"contact_{travel}.csv"))
            lines, _ = csv_table(os.path.join(folder, f"tools_{travel}.csv"))
            self.assertEqual(list(run.state(travel).outlines), list(dict.fromkeys(lines["tool"])))
            self.assertEqual(sum(map(len, run.state(travel).outlines.values())), len(lines["tool"]))
        self.assertEqual(run.summary["newton_iterations"], int(run.history["newton_iterations"].sum()))
        self.assertEqual(run.summary["outcome"], "done")
        self.assertEqual(run.history.unit("punch_force_z"), "tonf")
        with self.assertRaisesRegex(LookupError, "there are 0.1, 0.3"):
            run.profile(.2)

    def test_nothing_is_written(self):
        before = set(os.listdir("."))
        cup().run()
        self.assertEqual(set(os.listdir(".")), before)

    def test_every_increment_can_be_kept(self):
        run = cup().run(keep="all")
        self.assertEqual(len(run.states), len(run.history))
        self.assertEqual([state.travel for state in run.states], list(run.history["punch_travel"]))
        thinnest = [state.profile["thickness"].min() for state in run.states]
        self.assertTrue(np.all(np.diff(thinnest) <= 1e-9))

    def test_entries(self):
        scene = cup({})
        self.assertEqual(scene["Blank/Elements"], 50)
        self.assertEqual(scene["Tools/punch/Friction coefficient"], .2)
        self.assertEqual(scene["Blank/Kind"], "shell")
        scene["Blank/Points"] = [(0, 0), (2, 0)]
        self.assertEqual(scene["Blank/Points"], "0 0; 2 0")
        scene["Output/Travels"] = np.array([.1, .2])
        self.assertEqual(scene["Output/Travels"], "0.1, 0.2")
        scene["Output/Energies"] = False
        self.assertEqual(scene["Output/Energies"], "false")
        with self.assertRaisesRegex(KeyError, "nearest is 'Blank/Elements'"):
            scene["Blank/Elments"]
        # What is completed is a scene again.
        again = deltaform.Scene.from_text(scene.text())
        self.assertEqual(again.entries(), scene.entries())

    def test_a_wrong_scene_says_what_the_program_says(self):
        for entries in ({"Blank/Elements": -3}, {"Blank/Elments": 3}, {"Material/Hardening/Law": "swft"}):
            words = [word for entry, value in entries.items() for word in ("--set", f"{entry}={value}")]
            program = subprocess.run([PROGRAM, os.path.join(FOLDER, "cup.prm"), "--check", *words], capture_output=True, text=True)
            self.assertEqual(program.returncode, 1)
            with self.assertRaises(deltaform.SceneError) as caught:
                cup(entries).run()
            self.assertEqual("deltaform: " + str(caught.exception), program.stderr.strip())
        with self.assertRaisesRegex(deltaform.SceneError, "nowhere.prm: cannot be read"):
            deltaform.Scene("nowhere.prm")
        self.assertIsInstance(caught.exception, ValueError)

    def test_doubts_are_named(self):
        self.assertEqual(cup({}).check(), [])
        doubts = cup({"Tools/punch/Friction coefficient": 1.5}).check()
        self.assertRegex(" ".join(doubts), "1.5")

    def test_a_run_that_stopped(self):
        with self.assertRaises(deltaform.NotDone) as caught:
            cup(TORN).run()
        run = caught.exception.run
        self.assertIn("tears", str(caught.exception))
        self.assertEqual(run.exit_status, 2)
        self.assertFalse(run.done)
        self.assertEqual(run.states[-1].travel, run.history["punch_travel"][-1])
        self.assertGreater(len(run.history), 10)
        self.assertEqual(cup(TORN).run(check=False).message, str(caught.exception))
        again = pickle.loads(pickle.dumps(caught.exception))
        self.assertEqual(len(again.run.history), len(run.history))

    def test_progress(self):
        rows = []
        run = cup().run(progress=rows.append)
        self.assertEqual([row["punch_force_z"] for row in rows], list(run.history["punch_force_z"]))
        self.assertEqual(rows[0]["stage"], "form")

        def enough(row):
            if row["increment"] == 3:
                raise StopIteration("enough")

        with self.assertRaisesRegex(StopIteration, "enough"):
            cup().run(progress=enough)
        self.assertEqual(len(cup().run().history), len(run.history))

    def test_an_interrupt_ends_the_run(self):
        scene = cup({"Blank/Elements": 2000, "Steps/form/Largest increment": 1e-4})
        threading.Timer(.5, os.kill, (os.getpid(), signal.SIGINT)).start()
        begin = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            scene.run()
        self.assertLess(time.monotonic() - begin, 20)
        self.assertTrue(cup().run().done)

    def test_scenes_do_not_see_each_other(self):
        first, second = cup(), cup({**SHORT, "Blank/Elements": 30})
        alone = [first.run(), second.run()]
        for scene, before in ((second, alone[1]), (first, alone[0]), (second, alone[1])):
            after = scene.run()
            for name in before.history.names:
                if before.history[name].dtype.kind == "f" and name != "seconds":
                    np.testing.assert_array_equal(after.history[name], before.history[name], name)

    def test_threads_wait_for_each_other(self):
        forces = {}
        threads = [threading.Thread(target=lambda mu=mu: forces.update({mu: force(mu)})) for mu in (.1, .2, .3)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for mu, value in forces.items():
            self.assertEqual(value, force(mu))
        self.assertEqual(len(forces), 3)

    def test_processes(self):
        with multiprocessing.get_context("spawn").Pool(2) as pool:
            forces = pool.starmap(force, [(mu, FOLDER) for mu in (.1, .2, .3)])
        self.assertEqual(forces, [force(.1), force(.2), force(.3)])
        self.assertTrue(np.all(np.diff(forces) > 0))

    def test_a_copy_of_the_process_is_refused(self):
        cup().run()
        with multiprocessing.get_context("fork").Pool(1) as pool:
            with self.assertRaisesRegex(RuntimeError, "spawn"):
                pool.apply(force, (.1,))

    def test_importing_starts_nothing(self):
        words = "import deltaform; deltaform.Scene('cup.prm'); assert not deltaform._deltaform.mpi_started()"
        subprocess.run([sys.executable, "-c", words], check=True, cwd=FOLDER)


if __name__ == "__main__":
    WORK, FOLDER, PROGRAM = (os.path.abspath(sys.argv.pop()) for _ in range(3))
    os.makedirs(WORK, exist_ok=True)
    os.chdir(WORK)
    unittest.main()
