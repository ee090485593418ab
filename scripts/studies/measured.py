"""Measured tables: printed as text, written as CSV into doc/measured. Standard library only.

A file opens with comments: what is measured, and by which script and version of the program. Pages quote and link it, so that a number
stands once.
"""
import argparse
import csv
import os
import re
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
FOLDER = os.path.join(ROOT, "doc", "measured")
sys.path.insert(0, os.path.join(ROOT, "scripts"))  # csv_file, plot, results and their like


def arguments_of(documentation, output=None, write=None):
    """Parser of a study that runs the program, with --program, --write and, if the runs leave files, --output (output/OUTPUT)."""
    parser = argparse.ArgumentParser(description=documentation, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default=os.path.join(ROOT, "build", "release", "deltaform"))
    if output:
        parser.add_argument("--output", default=os.path.join(ROOT, "output", output))
    parser.add_argument("--write", action="store_true", help=write)
    return parser


def version():
    with open(os.path.join(ROOT, "CMakeLists.txt"), encoding="utf-8") as file:
        return re.search(r"project\(deltaform VERSION (\S+)", file.read()).group(1)


class MeasuredTable:
    """Names of the columns, and rows of words; an empty cell stays empty."""

    def __init__(self, head, rows=()):
        self.head, self.rows = list(head), [[str(cell) for cell in row] for row in rows]

    def add(self, *cells):
        self.rows.append([str(cell) for cell in cells])

    def __str__(self):
        widths = [max(map(len, column)) for column in zip(self.head, *self.rows)]
        return "\n".join("  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip() for row in [self.head, *self.rows])

    def write(self, name, title, script=None):
        """doc/measured/NAME.csv; @p script is the calling one unless it is named."""
        script = script or os.path.relpath(os.path.abspath(sys.argv[0]), ROOT)
        os.makedirs(FOLDER, exist_ok=True)
        path = os.path.join(FOLDER, name.replace(" ", "_").replace(",", "") + ".csv")
        with open(path, "w", newline="", encoding="utf-8") as file:
            file.write(f"# {title}\n# {script}, deltaform {version()}\n")
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(self.head)
            writer.writerows(self.rows)
        print(f"wrote {os.path.relpath(path, ROOT)}")
