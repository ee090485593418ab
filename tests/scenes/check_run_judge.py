#!/usr/bin/env python3
"""Does check_run.py say no? check_run_judge.py PROGRAM PRESSED_AND_RELEASED.prm FOLDER.

The scene is run, its files must be in order; then copies of them are damaged, one thing at a time, and each damage must be
found under its heading.
"""
import shutil
import struct
import subprocess
import sys
from pathlib import Path

import check_run
from run_files import Table, VtuFile


class Files:
    """A copy of the files of a run that can be damaged."""

    def __init__(self, original, folder):
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(original, folder)
        self.folder = folder

    def change(self, name, column, change, row=-1, where=None):
        """Replace cells of a table by change(value): in one row, or in all rows for which where(row)."""
        path = self.folder / name
        table = Table(path)
        k = table.names.index(column)
        rows = [table.rows[row]] if where is None else [cells for cells in table.rows if where(dict(zip(table.names, cells)))]
        for cells in rows:
            cells[k] = change(cells[k])
        head = [line for line in path.read_text().splitlines() if line.startswith("#")]
        path.write_text("\n".join(head + [",".join(cells) for cells in [table.names] + table.rows]) + "\n")

    def spoil_picture(self, name):
        """Write a NaN into the last array of floats."""
        path = self.folder / name
        picture = VtuFile(path)
        content = bytearray(path.read_bytes())
        struct.pack_into("=f", content, picture.place([data for data in picture.arrays() if data.get("type") == "Float32"][-1]), float("nan"))
        path.write_bytes(content)


def times(factor):
    return lambda text: repr(float(text) * factor)


def plus(amount):
    return lambda text: repr(float(text) + amount)


def in_form(row):
    return row["stage"] == "form" and float(row["time"]) > .99


# Heading of the finding, and what is done to the files.
DAMAGES = [
    ("forces in z", lambda files: files.change("history.csv", "round_punch_force_z", times(1.001), where=in_form)),
    ("forces in r", lambda files: files.change("history.csv", "symmetry_r_reaction", times(1.001), where=in_form)),
    ("released", lambda files: files.change("history.csv", "round_punch_force_z", lambda _: "1e-3")),
    ("energy", lambda files: files.change("history.csv", "plastic_energy", times(1.001))),
    ("energy", lambda files: files.change("history.csv", "energy_error", plus(1e-4))),
    ("energy", lambda files: files.change("history.csv", "round_punch_travel", times(1.01), where=in_form)),
    ("thinnest", lambda files: files.change("history.csv", "min_thickness", times(.95), where=in_form)),
    ("promise", lambda files: files.change("contact_3.csv", "penetration", times(10.),
                                          where=lambda row: float(row["penetration"]) > .1 * float(row["delta"]))),
    ("promise", lambda files: files.change("history.csv", "max_penetration_over_delta", times(.5), where=in_form)),
    ("outlines", lambda files: files.change("profile_3.csv", "z", plus(.02), row=0)),
    ("outlines", lambda files: files.change("tools_3.csv", "z", plus(-.02), where=lambda row: row["tool"] == "round punch")),
    ("outlines", lambda files: files.change("tools_3.csv", "z", plus(.02), where=lambda row: row["tool"] == "die")),
    ("numbers", lambda files: files.change("profile_3.csv", "eps_hoop", lambda _: "nan")),
    ("numbers", lambda files: files.change("history.csv", "tool_work", lambda _: "-inf")),
    ("numbers", lambda files: files.spoil_picture("blank_0001.vtu")),
]


def main():
    program, scene, folder = sys.argv[1], sys.argv[2], Path(sys.argv[3])
    original = folder / "original"
    subprocess.run([program, scene, "--quiet", "--output", str(original)], check=True)
    failures = [f"in order, but: {sentence}" for sentence in check_run.check(original).wrong]
    for number, (heading, damage) in enumerate(DAMAGES):
        files = Files(original, folder / "damaged")
        damage(files)
        wrong = check_run.check(files.folder).wrong
        if not any(sentence.startswith(heading) for sentence in wrong):
            failures.append(f"damage {number + 1} was not found under '{heading}', only {wrong}")
    # The exit status is what ctest sees.
    for status, run in ((0, original), (1, folder / "damaged"), (1, folder / "nothing")):
        if subprocess.run([sys.executable, check_run.__file__, str(run)], stdout=subprocess.DEVNULL).returncode != status:
            failures.append(f"check_run.py {run.name} does not end with status {status}")
    print("\n".join(failures) or f"{len(DAMAGES)} damages found")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
