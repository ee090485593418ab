#!/usr/bin/env python3
"""Angles and side-wall curl of a U-bend after its release, from the tables of a run: springback.py FOLDER...

The wall is what lies more than MARGIN away from bottom and flange in height before the release. A circle is fitted to it afterwards;
its tangents at both ends are the directions of the wall:
  theta1  angle between bottom and wall (degrees; 90 without springback)
  theta2  angle between wall and flange (degrees; 90 without springback)
  rho     radius of the circle: side-wall curl (length)
Standard library only.
"""
import glob
import math
import os
import sys

from csv_file import rows_of

MARGIN = 15.


def table(path):
    return [{name: float(value) for name, value in row.items()} for row in rows_of(path)]


def solve(matrix, right):
    """Gauss elimination of a small system."""
    n = len(right)
    rows = [list(row) + [value] for row, value in zip(matrix, right)]
    for k in range(n):
        pivot = max(range(k, n), key=lambda i: abs(rows[i][k]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        for i in range(k + 1, n):
            factor = rows[i][k] / rows[k][k]
            rows[i] = [a - factor * b for a, b in zip(rows[i], rows[k])]
    result = [0.] * n
    for k in reversed(range(n)):
        result[k] = (rows[k][n] - sum(rows[k][j] * result[j] for j in range(k + 1, n))) / rows[k][k]
    return result


def circle(points):
    """Centre and radius of the circle with the least algebraic distance, x^2 + z^2 = a x + b z + c (Kasa 1976)."""
    columns = [[x, z, 1.] for x, z in points]
    squares = [x * x + z * z for x, z in points]
    normal = [[sum(row[i] * row[j] for row in columns) for j in range(3)] for i in range(3)]
    right = [sum(row[i] * square for row, square in zip(columns, squares)) for i in range(3)]
    a, b, c = solve(normal, right)
    return (a / 2, b / 2), math.sqrt(c + a * a / 4 + b * b / 4)


def direction(first, last):
    return math.degrees(math.atan2(last[1] - first[1], last[0] - first[0]))


def measure(formed, released):
    """theta1, theta2 (degrees) and rho of a strip along its nodes."""
    low, high = formed[0]["z"] + MARGIN, formed[-1]["z"] - MARGIN
    wall = [(b["r"], b["z"]) for a, b in zip(formed, released) if low < a["z"] < high]
    if len(wall) < 5:
        raise ValueError("there are fewer than five nodes on the wall")
    centre, radius = circle(wall)

    def tangent(point, along):
        angle = math.degrees(math.atan2(point[1] - centre[1], point[0] - centre[0])) + 90.
        return angle if math.cos(math.radians(angle - along)) > 0 else angle + 180.

    chord = direction(wall[0], wall[-1])
    start, end = tangent(wall[0], chord), tangent(wall[-1], chord)
    bottom = direction((released[0]["r"], released[0]["z"]), (released[3]["r"], released[3]["z"]))
    flange = direction((released[-20]["r"], released[-20]["z"]), (released[-1]["r"], released[-1]["z"]))
    turn = lambda angle: (angle + 180.) % 360. - 180.
    return 180. - turn(start - bottom), 180. - turn(end - flange), radius


def measure_run(folder):
    """Of the last two tables of a run: the last one of the stage that forms, and the last one of all."""
    tables = sorted(glob.glob(os.path.join(folder, "profile_*.csv")), key=lambda path: (os.path.getmtime(path), path))
    if len(tables) < 2:
        raise ValueError(f"{folder} has fewer than two profiles")
    return measure(table(tables[-2]), table(tables[-1]))


def main():
    if len(sys.argv) < 2 or sys.argv[1].startswith("-"):
        sys.exit("usage: springback.py FOLDER...   (runs of a U-bend and its release)")
    for folder in sys.argv[1:]:
        try:
            theta1, theta2, rho = measure_run(folder)
        except ValueError as error:
            sys.exit(f"springback.py: {error}")
        print(f"{folder}: theta1 {theta1:.2f}, theta2 {theta2:.2f} degrees, rho {rho:.1f}")


if __name__ == "__main__":
    main()
