#!/usr/bin/env python3
"""Run the cup to a travel of .1 with four pictures, and the undeformed blank before them, and look at them as ParaView would.

    pictures.py PROGRAM CUP.prm FOLDER THICK_SPHERE.prm

scene.pvd must name every picture, at the asked times, with the blank and each tool under its name; no other file may lie about, although another run
with more pictures went into the same folder before. The pole of the
blank follows the punch: from picture to picture its faces move by the travel between them, but for what bending and
thinning add (at most 3 % at this depth, where the punch touches on a ring; 5 % are allowed, a picture too early or too
late is 30 % off). In the first picture nothing has moved and the punch touches the blank. The plastic strain tensor of the last keeps
the volume, and is one that VTK knows: six components. The sphere's pressure, 0 to 250 and back to 0 at times 0, 1, 2, is shown at the nodes
of its inner face, at no others. Exit status 1 if not.
"""
import math
import shutil
import subprocess
import sys
import xml.etree.ElementTree as xml
from pathlib import Path

from run_files import VtuFile

END, PICTURES = .1, 4
PARTS, THICKNESS = ["blank", "punch", "die", "holder"], .035
EARLIER_END, EARLIER_PICTURES = .06, 7


def points(path):
    return VtuFile(path).points()


def field(path, name):
    picture = VtuFile(path)
    return picture.numbers(picture.field(name))


def pole(path):
    """z of the outermost points on the axis: bottom and top of the blank there."""
    values = points(path)
    heights = [z for r, z in zip(values[0::3], values[1::3]) if abs(r) < 1e-6]
    return min(heights), max(heights)


def check_first(folder, parts):
    """What is wrong with the undeformed blank and the tools at their start."""
    failures = []
    blank, punch = folder / parts["blank"], folder / parts["punch"]
    if any(field(blank, "displacement")):
        failures.append("the first picture is displaced")
    if any(field(blank, "equivalent_plastic_strain")):
        failures.append("the first picture is strained")
    bottom, top = pole(blank)
    if abs(top - bottom - THICKNESS) > 1e-6 or abs(min(points(punch)[1::3]) - top) > 1e-6:
        failures.append(f"at the start the blank lies from {bottom} to {top}, the punch at {min(points(punch)[1::3])}")
    return failures


def check_tensor(path):
    """What is wrong with the plastic strain of a picture."""
    picture = VtuFile(path)
    data = picture.field("plastic_strain")
    names = [data.get(f"ComponentName{k}") for k in range(6)]
    if data.get("NumberOfComponents") != "6" or names[:4] != ["rr", "zz", "hoop", "rz"]:
        return [f"plastic_strain has components {names}"]
    values = picture.numbers(data)
    largest = max(map(abs, values))
    traces = [abs(sum(values[i:i + 3])) for i in range(0, len(values), 6)]
    return [] if largest > 1e-3 and max(traces) < 1e-5 * largest else [f"plastic strains to {largest}, traces to {max(traces)}"]


def check_load_pressure(program, scene, folder):
    """What is wrong with the pressure of the sphere in its pictures."""
    subprocess.run([program, scene, "--quiet", "--output", str(folder), "--set", "Output/Pictures=4"], check=True)
    failures, inner = [], None
    for entry in xml.parse(folder / "scene.pvd").getroot().iter("DataSet"):
        time, path = float(entry.get("timestep")), folder / entry.get("file")
        place, pressure = points(path), field(path, "load_pressure")
        radii = [math.hypot(r, z) for r, z in zip(place[0::3], place[1::3])]
        inner = inner or [radius < min(radii) * (1 + 1e-6) for radius in radii]  # of the undeformed sphere
        expected = 250 * (time if time <= 1 else 2 - time)
        if any(abs(p - expected * on) > 1e-4 for p, on in zip(pressure, inner)):
            failures.append(f"pressure at time {time}: {min(pressure)} to {max(pressure)}, asked for was {expected}")
    return failures


def main():
    program, scene, folder = sys.argv[1], sys.argv[2], Path(sys.argv[3])
    shutil.rmtree(folder, ignore_errors=True)
    for end, pictures in ((EARLIER_END, EARLIER_PICTURES), (END, PICTURES)):
        subprocess.run([program, scene, "--quiet", "--output", str(folder), "--set", f"Steps/form/End time={end}",
                        "--set", f"Output/Pictures={pictures}"], check=True)
    series = {}
    for entry in xml.parse(folder / "scene.pvd").getroot().iter("DataSet"):
        series.setdefault(float(entry.get("timestep")), {})[entry.get("name")] = entry.get("file")
    times = list(series)
    named = [name for files in series.values() for name in files.values()]
    failures = []
    if times != sorted(times) or len(times) != PICTURES + 1 or abs(times[-1] - END) > 1e-12:
        failures.append(f"times {times}")
    for i, time in enumerate(times):
        asked = END * i / PICTURES
        if not asked - 1e-9 <= time < asked + (END / PICTURES if i > 0 else 1e-12):
            failures.append(f"picture {i} is of {time}, asked for was {asked}")
    if any(list(files) != PARTS for files in series.values()) or len(set(named)) != len(named):
        failures.append(f"parts {series}")
    if sorted(named) != sorted(path.name for path in folder.glob("*.vtu*")):
        failures.append(f"files {sorted(path.name for path in folder.glob('*.vtu*'))}, named {sorted(named)}")
    tables = sorted(path.name for path in folder.glob("*_*.csv"))
    if tables != [f"{kind}_{END}.csv" for kind in ("contact", "profile", "tools")]:
        failures.append(f"tables {tables}")
    if not failures:
        failures += check_first(folder, series[0.]) + check_tensor(folder / series[times[-1]]["blank"])
        poles = [pole(folder / series[time]["blank"]) for time in times[1:]]
        times = times[1:]
        for before, after, travel in zip(poles, poles[1:], (b - a for a, b in zip(times, times[1:]))):
            for one, other in zip(before, after):
                if abs(abs(other - one) - travel) > .05 * travel:
                    failures.append(f"the pole moves from {one} to {other}, the punch by {travel}")
    failures += check_load_pressure(program, sys.argv[4], folder.with_name(folder.name + "_sphere"))
    print("\n".join(failures) or f"{len(times)} pictures, complete and in order")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
