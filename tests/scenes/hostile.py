#!/usr/bin/env python3
"""Files that are no scenes, functions that fail between samples, numbers that are too large: hostile.py PROGRAM CUP_SCENE FOLDER.

Each case has an exit status and a part of what must be said. None may crash, take long or much memory, or show a library's exception."""
import json
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys

program, cup, work = sys.argv[1], pathlib.Path(sys.argv[2]).resolve(), pathlib.Path(sys.argv[3])
shutil.rmtree(work, ignore_errors=True)
work.mkdir(parents=True)
failures = 0
MEGABYTE = 1 << 20


def limited():
    resource.setrlimit(resource.RLIMIT_CPU, (30, 30))
    resource.setrlimit(resource.RLIMIT_AS, (4096 * MEGABYTE, 4096 * MEGABYTE))


def expect(status, message, *options, scene=cup, command=()):
    """Run, and compare exit status and message."""
    global failures
    done = subprocess.run([program, *command, str(scene), *options], capture_output=True, timeout=60, preexec_fn=limited)
    said = (done.stdout + done.stderr).decode("latin-1")
    wrong = done.returncode != status or message not in said
    wrong = wrong or "error of the program" in said or re.search(r"[\x00-\x08\x0b-\x1f\x7f]", said)
    if wrong or len(said) > 20000:
        failures += 1
        print(f"{scene} {' '.join(option[:100] for option in options)}: exit status {done.returncode}, expected {status} and "
              f"'{message}'; it said\n{said[:1000]}")
    return said


def check(message, *entries, status=1):
    """Entries of the cup that must be refused before anything is computed."""
    expect(status, message, "--check", *[word for entry in entries for word in ("--set", entry)])


def refused(message, content, name="scene.prm"):
    """A file that must be refused."""
    file = work / name
    file.write_bytes(content if isinstance(content, bytes) else content.encode())
    return expect(1, message, "--check", scene=file)


def table(folder):
    """The cells of history.csv."""
    lines = [line for line in (folder / "history.csv").read_text().splitlines() if not line.startswith("#")]
    return [dict(zip(lines[0].split(","), line.split(","))) for line in lines[1:]]


# Functions between the samples: the run stops with entry, time and value, keeps what it has, and writes no row with nan. An increment
# ends at t = .02004, because a table is asked for there.
fine = ["Steps/form/End time=.05", "Blank/Elements=30", "Tools/punch/Motion=t", "Output/Travels=.02004", "Output/Pictures=0"]
for entry, message in (
        ("Tools/holder/Motion=if(abs(t-.02004)<.00002,0/0,0)", "Tools/holder/Motion is no finite number at t = 0.02004"),
        ("Contact/Allowed penetration=0: 1e-4, .02002: 1e-4, .02003: 0, .02006: 0, .02007: 1e-4",
         "Contact/Allowed penetration must be positive at all times; it is 0 at t = 0.02004"),
        ("Contact/Allowed penetration=0: 1e-4, .02002: 1e-4, .02003: 1e-20, .02006: 1e-20, .02007: 1e-4",
         "at t = 0.02004 cannot be told from round-off"),
        ("Contact/Allowed penetration=0: 1e-4, .02002: 1e-4, .02003: -1, .02006: -1, .02007: 1e-4",
         "it is -1 at t = 0.02004")):
    folder = work / "between"
    shutil.rmtree(folder, ignore_errors=True)
    sets = [word for one in (*fine, entry) for word in ("--set", one)]
    expect(2, message, *sets, "--output", str(folder), "--quiet")
    rows = table(folder) if (folder / "history.csv").exists() else []
    if not rows or not all(re.fullmatch(r"[-+0-9.e]+|form|", cell) for row in rows for cell in row.values()):
        failures += 1
        print(f"{entry}: no rows, or one with what is no number")
    if not (folder / "summary.json").exists() or json.loads((folder / "summary.json").read_text())["exit_status"] != 2:
        failures += 1
        print(f"{entry}: the summary does not say 2")
check("must be positive, and more than the round-off of coordinates, at all times; it is -0.001 at t = 0",
      "Contact/Allowed elastic slip=-1e-3", "Tools/punch/Friction coefficient=.1")
check("it is 0 at t =", "Contact/Allowed elastic slip=0", "Tools/punch/Friction coefficient=.1")
check("Grading = if(abs(t-.3)<.001,0/0,1): must lie between 1e-6 and 1e6", "Blank/Grading=if(abs(t-.3)<.001,0/0,1)")

# Products of numbers.
check("Blank/Points = 0 0; 1e160 0: must lie between 1e-60 and 1e60", "Blank/Points=0 0; 1e160 0")
check("Blank/Points = 0 0; 1e40 0: is more than 1e12 times larger than Blank/Thickness", "Blank/Points=0 0; 1e40 0")
check("Tools/punch/Radius = 1e-300: must lie between", "Tools/punch/Radius=1e-300")
check("Tools/punch/Radius = 1e200: must lie between", "Tools/punch/Radius=1e200")
check("Tools/punch/Radius = 1e-20: is more than 1e12 times smaller than", "Tools/punch/Radius=1e-20")
check("Smallest increment = 1e-17: is lost in the round-off of the time", "Steps/form/Smallest increment=1e-17")
check("need about", "Blank/Kind=solid", "Blank/Elements=100000", "Blank/Elements through thickness=100000")

# Memory is asked for before a million elements are placed, and counts layers.
check("Blank/Elements = 1000000: 1000000 elements need about", "Blank/Kind=solid", "Blank/Elements=1000000", "Blank/Grading=1+t",
      "Blank/Elements through thickness=40")
check("Blank/Elements = 1000000: 1000000 elements need about 35", "Blank/Degree=2", "Blank/Elements=1000000", "Blank/Layers=61")

# Scenes that are none.
nested = "".join(f"subsection s{i}\n" for i in range(20000)) + "end\n" * 20000
refused("scene.prm:21: subsections are nested more than 20 deep", nested)
refused("this is too much: a scene has at most 10000 entries", "".join(f"set x{i} = 1\n" for i in range(50000)))
refused("... and 80 more.", cup.read_text() + "".join(f"set x{i} = 1\n" for i in range(100)))
refused("has 1600000 bytes; 200 are allowed", "set " + "x" * 1600000 + " = 1\n")
refused("is too long: a scene with all that it includes has at most 16 MB", "# comment\n" * 2000000)
refused("include /dev/zero: '/dev/zero' cannot be read: it is a pipe or a device", "include /dev/zero\n")
os.mkfifo(work / "fifo")
refused("it is a pipe or a device, not a file", "include fifo\n")
os.symlink("loop", work / "loop")
refused("'%s' cannot be read: Too many levels of symbolic links" % (work / "loop"), "include loop\n")
refused("File name too long", "include " + "n" * 300 + "\n")
expect(1, "Too many levels of symbolic links", "--check", scene=work / "loop")
for i in range(200):
    (work / f"chain_{i}.prm").write_text(f"include chain_{i + 1}.prm\n")
refused("files include one another more than 50 deep", "include chain_0.prm\n")
for i in range(10):
    (work / f"ten_{i}.prm").write_text(f"include ten_{i + 1}.prm\n" * 10)
(work / "ten_10.prm").write_text("# nothing\n")
refused("a scene includes at most 1000 files", "include ten_0.prm\n")
refused("closes a cycle", "include scene.prm\n")
refused("cannot be read: it is UTF-16", cup.read_text().encode("utf-16"))
refused("it contains zero bytes", cup.read_text().encode("utf-16-le"))
said = refused("cannot understand", b"\x1b[2J\x07 and \xff\n")
if "\\x1b[2J\\x07 and \\xff" not in said:
    failures += 1
    print("control characters are not escaped:", repr(said))
file = work / "with_mark.prm"
file.write_bytes(b"\xef\xbb\xbf" + cup.read_bytes())
expect(0, "is a valid scene", "--check", scene=file)
expect(1, "there is a cell with edges of", "--check", "--set", "Blank/Thickness=1e-8",
       scene=cup.parent / "indentation.prm")
check("the stage must last at least 1e-60", "Steps/form/End time=5e-324")
check("cannot be a name: it becomes part of columns and of file names", "Steps/Stages=a/b", "Steps/a/b/End time=1")
check("a formula has at most 10000 characters", "Tools/punch/Motion=t" + "+0" * 6000)

expect(0, "is a valid scene: \\x1b[2J", "--check", "--svg", str(work / "title.svg"), "--set", "Title=\x1b[2J")
drawing = (work / "title.svg").read_text()
if "\\x1b[2J" not in drawing or "\x1b" in drawing:
    failures += 1
    print("control characters of a title are not escaped in the drawing")

# Titles are bytes; what is said of them is text.
folder = work / "title"
done = subprocess.run([program, str(cup), "--quiet", "--output", str(folder), "--set", "Steps/form/End time=.01", "--set",
                       "Blank/Elements=20", "--set", "Output/Travels=", "--set", b"Title=\xff\x1b[2J \xc3\xa9 \xed\xa0\x80"], check=False)
if done.returncode != 0 or "\u00e9" not in json.loads((folder / "summary.json").read_bytes().decode("utf-8"))["title"]:
    failures += 1
    print(f"a title of bytes: exit status {done.returncode}")

# Folders.
(work / "file").write_text("")
expect(1, "Cannot make the folder", "--output", str(work / "file" / "x"))
expect(1, "Cannot make the folder", "--output", str(work / ("d" * 300)))
blocked = work / "blocked"
(blocked / "summary.json" / "x").mkdir(parents=True)
expect(1, "Cannot remove '", "--output", str(blocked), "--quiet")
blocked = work / "sweep" / "run_001" / "summary.json" / "x"
blocked.mkdir(parents=True)
expect(1, "of an earlier sweep", "--output", str(work / "sweep"), "--vary", "Blank/Elements=20,30", command=["sweep"])
many = ",".join(str(i) for i in range(1000))
expect(64, "a sweep has at most 10000", "--vary", "Blank/Elements=" + many, "--vary", "Steps/form/End time=" + many, command=["sweep"])

# Meshes.
solid = ["--set", "Blank/Kind=solid", "--set", "Blank/Mesh=gmsh", "--set"]
for content, message in ((b"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n", "is no mesh of quadrilaterals that can be read: line"),
                         (b"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n2147483647\n1 0 0 0\n", "does not hold so many"),
                         (b"", "the file is empty"), (b"\0" * 1000, "stands where $MeshFormat should")):
    (work / "mesh.msh").write_bytes(content)
    expect(1, message, "--check", *solid, f"Blank/File={work}/mesh.msh")
expect(1, "cannot read '", "--check", *solid, f"Blank/File={work}/fifo")
expect(1, "cannot read '/dev/zero'", "--check", *solid, "Blank/File=/dev/zero")
expect(1, "cannot read '", "--check", *solid, f"Blank/File={work}")

# Outlines.
outline = ["Tools/punch/Shape=outline", "Tools/punch/Position z=0"]
check("Tools/punch/File = %s: '%s': it is a folder" % (work, work), *outline, f"Tools/punch/File={work}")
check("the file cannot be read: No such file or directory", *outline, "Tools/punch/File=nowhere.dxf")
sys.exit(1 if failures else 0)
