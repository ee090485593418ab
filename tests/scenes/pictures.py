#!/usr/bin/env python3
"""Run the cup to a travel of .1 with four pictures and look at them as ParaView would.

    pictures.py PROGRAM CUP.prm FOLDER

scene.pvd must name every picture, at the asked times, with blank and tools; no other file may lie about, although another run
with more pictures went into the same folder before. The pole of the
blank follows the punch: from picture to picture its faces move by the travel between them, but for what bending and
thinning add (at most 3 % at this depth, where the punch touches on a ring; 5 % are allowed, a picture too early or too
late is 30 % off). Exit status 1 if not.
"""
import base64
import shutil
import struct
import subprocess
import sys
import xml.etree.ElementTree as xml
from pathlib import Path

END, PICTURES = .1, 4
EARLIER_END, EARLIER_PICTURES = .06, 7


def pole(path):
    """z of the outermost points on the axis: bottom and top of the blank there."""
    data = xml.parse(path).getroot().find("UnstructuredGrid/Piece/Points/DataArray")
    content = base64.b64decode(data.text.strip())
    size, = struct.unpack_from("<I", content)
    values = struct.unpack_from(f"<{size // 4}f", content, 4)
    heights = [z for r, z in zip(values[0::3], values[1::3]) if abs(r) < 1e-6]
    return min(heights), max(heights)


def main():
    program, scene, folder = sys.argv[1], sys.argv[2], Path(sys.argv[3])
    shutil.rmtree(folder, ignore_errors=True)
    for end, pictures in ((EARLIER_END, EARLIER_PICTURES), (END, PICTURES)):
        subprocess.run([program, scene, "--quiet", "--output", str(folder), "--set", f"Steps/form/End time={end}",
                        "--set", f"Output/Pictures={pictures}"], check=True)
    series = {}
    for entry in xml.parse(folder / "scene.pvd").getroot().iter("DataSet"):
        series.setdefault(float(entry.get("timestep")), []).append(entry.get("file"))
    times = list(series)
    named = [name for files in series.values() for name in files]
    failures = []
    if times != sorted(times) or len(times) != PICTURES or abs(times[-1] - END) > 1e-12:
        failures.append(f"times {times}")
    for i, time in enumerate(times):
        asked = END * (i + 1) / PICTURES
        if not asked - 1e-9 <= time < asked + END / PICTURES:
            failures.append(f"picture {i} is of {time}, asked for was {asked}")
    if any(len(files) != 2 for files in series.values()) or len(set(named)) != len(named):
        failures.append(f"parts {named}")
    if sorted(named) != sorted(path.name for path in folder.glob("*.vtu*")):
        failures.append(f"files {sorted(path.name for path in folder.glob('*.vtu*'))}, named {sorted(named)}")
    tables = sorted(path.name for path in folder.glob("*_*.csv"))
    if tables != [f"{kind}_{END}.csv" for kind in ("contact", "profile", "tools")]:
        failures.append(f"tables {tables}")
    if not failures:
        poles = [pole(folder / series[time][0]) for time in times]
        for before, after, travel in zip(poles, poles[1:], (b - a for a, b in zip(times, times[1:]))):
            for one, other in zip(before, after):
                if abs(abs(other - one) - travel) > .05 * travel:
                    failures.append(f"the pole moves from {one} to {other}, the punch by {travel}")
    print("\n".join(failures) or f"{len(times)} pictures, complete and in order")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
