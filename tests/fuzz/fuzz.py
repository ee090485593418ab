#!/usr/bin/env python3
"""Bad input by the thousand: no crash, no hang, no number that is none, no exception without a name, no memory out of
proportion.

    fuzz.py scenes      PROGRAM JUDGE SCENES FOLDER [--seed N] [--count N]     mutated scenes are built; some are run
    fuzz.py meshes      PROGRAM JUDGE SCENES FOLDER [--seed N] [--count N]     mutated Gmsh files, formats 2.2, 4.0, 4.1
    fuzz.py checkpoints PROGRAM JUDGE SCENES FOLDER [--seed N] [--count N]     damaged states whose sums are right
    fuzz.py writes      PROGRAM JUDGE SCENES FOLDER [--seed N] [--count N]     killed at the n-th write, then resumed (strace)

JUDGE is the program judge_inputs. What fails is kept in FOLDER. A seed is a case: the same ones come again."""
import argparse
import collections
import pathlib
import random
import re
import shutil
import subprocess
import sys
import zlib

import mutations

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "scenes"))
from resume import compare  # noqa: E402

PATIENCE = 100  # seconds of a run
LATIN = "latin-1"  # a byte is a character


class Findings:
    """How the cases ended, and those that must not have."""

    def __init__(self, folder):
        self.folder, self.ends, self.runs, self.bad = folder, collections.Counter(), collections.Counter(), []

    def add(self, end, case, wrong=None):
        self.ends[end] += 1
        if wrong:
            self.bad.append(f"{case}: {wrong}")

    def report(self, what):
        total = sum(self.ends.values())
        listed = lambda ends: ", ".join(f"{n} {end}" for end, n in ends.most_common())
        runs = f"; {sum(self.runs.values())} of them run: {listed(self.runs)}" if self.runs else ""
        print(f"{total} {what}: {listed(self.ends)}{runs}; {len(self.bad)} findings")
        for line in self.bad[:20]:
            print("  " + line[:600])
        return 1 if self.bad or total == 0 else 0


def judged(judge, cases):
    """(verdict, kB, seconds, said) of each line of judge_inputs."""
    process = subprocess.run([judge], input="\n".join(cases) + "\n", stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                             encoding=LATIN, check=True)
    for line in process.stdout.splitlines():
        verdict, kilobytes, seconds, said = line.split("\t", 3)
        yield verdict, int(kilobytes), float(seconds), said


def run(program, scene, folder, *options):
    """(exit status, what it said); status None: it did not end."""
    try:
        done = subprocess.run([program, scene, "--quiet", "--output", str(folder), *options], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, timeout=PATIENCE)
        return done.returncode, done.stdout.decode(LATIN)
    except subprocess.TimeoutExpired:
        return None, "not ended"


def not_finite(folder):
    """A cell of a table that is no number, or None."""
    for path in folder.glob("*.csv"):
        for line in path.read_text(encoding=LATIN).splitlines():
            if not line.startswith("#") and re.search(r"(^|,)[+-]?(nan|inf)(,|$)", line):
                return f"{path.name}: {line[:100]}"
    return None


def wrong_end(status, said, folder):
    """Why a run must not have ended like this, or None."""
    if status is None:
        return "does not end"
    if status not in (0, 1, 2, 3):
        return f"exit status {status}: {said[-300:]}"
    if "error of the program" in said:
        return said[-400:]
    if re.search(r"[\x00-\x08\x0b-\x1f\x7f]", said):
        return "control characters on the terminal: " + repr(said[:200])
    return not_finite(folder)


def batches(count, size):
    for first in range(0, count, size):
        yield range(first, min(first + size, count))


def fuzz_scenes(arguments, findings):
    originals = sorted(arguments.scenes.glob("prm/*.prm")) + sorted(arguments.scenes.glob("tests/scenes/*.prm"))
    originals = [path for path in originals if "\ninclude" not in "\n" + path.read_text()]
    for batch in batches(arguments.count, 200):
        files = []
        for i in batch:
            chance = random.Random(f"scene {arguments.seed} {i}")
            file = arguments.folder / f"scene_{i}.prm"
            file.write_bytes(mutations.scene(chance, chance.choice(originals).read_text()).encode("utf-8", "replace")
                             if chance.random() < .7 else
                             mutations.scene(chance, chance.choice(originals).read_text()).encode(LATIN, "replace"))
            files.append(file)
        for i, file, (verdict, kilobytes, seconds, said) in zip(batch, files, judged(arguments.judge, map(str, files))):
            wrong = None
            if verdict not in ("valid", "refused"):
                wrong = f"{verdict}: {said}"
            elif verdict == "refused" and (":" not in said or "dealii::" in said or "boost::" in said):
                wrong = "names no place, or shows an exception of a library: " + said
            findings.add(verdict, file, wrong)
            if verdict == "valid" and not wrong and i % arguments.run_every == 0:
                folder = arguments.folder / f"run_{i}"
                status, said = run(arguments.program, file, folder, "--set", "Solver/Maximal increments=4", "--set",
                                   "Solver/Maximal iterations=20")
                wrong = wrong_end(status, said, folder)
                findings.runs[f"status {status}"] += 1
                if wrong:
                    findings.bad.append(f"{file}, run: {wrong}")
                shutil.rmtree(folder, ignore_errors=True)
            if not wrong:
                file.unlink()


def grid(chance):
    """A mesh of n x m cells in one of the formats of Gmsh."""
    n, m, kind = chance.randrange(1, 6), chance.randrange(1, 5), chance.choice(("2.2", "4", "4.1"))
    number = lambda i, k: 1 + i + k * (n + 1)
    nodes = [(number(i, k), i + .1 * k, k) for k in range(m + 1) for i in range(n + 1)]
    quads = [(number(i, k), number(i + 1, k), number(i + 1, k + 1), number(i, k + 1)) for k in range(m) for i in range(n)]
    curves = {1: [(number(i, 0), number(i + 1, 0)) for i in range(n)], 2: [(number(i, m), number(i + 1, m)) for i in range(n)]}
    head = f"$MeshFormat\n{kind} 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n1 1 \"foot\"\n1 2 \"head\"\n$EndPhysicalNames\n"
    n_elements = len(quads) + 2 * n
    if kind == "2.2":
        body = f"$Nodes\n{len(nodes)}\n" + "".join("%d %g %g 0\n" % node for node in nodes) + "$EndNodes\n"
        elements = [f"1 2 {tag} {tag} {a} {b}" for tag, all_lines in curves.items() for a, b in all_lines]
        elements += ["3 2 9 9 %d %d %d %d" % quad for quad in quads]
        return head + body + f"$Elements\n{len(elements)}\n" + "".join(
            f"{i + 1} {text}\n" for i, text in enumerate(elements)) + "$EndElements\n"
    entities = "$Entities\n0 2 1 0\n" + "".join(f"{tag} 0 0 0 1 1 0 1 {tag} 0\n" for tag in curves) + "1 0 0 0 1 1 0 0 0\n$EndEntities\n"
    new = kind == "4.1"
    pair = (lambda dimension, tag: f"{dimension} {tag}") if new else (lambda dimension, tag: f"{tag} {dimension}")
    first = f"1 {len(nodes)}" + (f" 1 {len(nodes)}" if new else "") + f"\n{pair(2, 1)} 0 {len(nodes)}\n"
    if new:
        first += "".join("%d\n" % node[0] for node in nodes) + "".join("%g %g 0\n" % node[1:] for node in nodes)
    else:
        first += "".join("%d %g %g 0\n" % node for node in nodes)
    blocks, last = "", 0
    for dimension, tag, kind_of, elements in ((1, 1, 1, curves[1]), (1, 2, 1, curves[2]), (2, 1, 3, quads)):
        blocks += f"{pair(dimension, tag)} {kind_of} {len(elements)}\n"
        for element in elements:
            last += 1
            blocks += " ".join(map(str, (last, *element))) + "\n"
    return (head + entities + "$Nodes\n" + first + "$EndNodes\n$Elements\n" + f"3 {n_elements}" +
            (f" 1 {n_elements}" if new else "") + "\n" + blocks + "$EndElements\n")


MESH_SCENE = """subsection Blank
  set Kind = solid
  set Mesh = gmsh
  set Contact bottom = foot
  set Contact top = head
end
subsection Material
  set Model = linear elastic
  set Young's modulus = 1000
  set Poisson's ratio = .3
end
subsection Supports
  set Names = foot
  subsection foot
    set Boundary = foot
  end
end
subsection Loads
  set Names = head
  subsection head
    set Kind = pressure
    set Face = head
    set Value = t
  end
end
subsection Steps
  set Stages = press
end
"""


def fuzz_meshes(arguments, findings):
    scene = arguments.folder / "mesh.prm"
    scene.write_text(MESH_SCENE)
    for batch in batches(arguments.count, 200):
        files = []
        for i in batch:
            chance = random.Random(f"mesh {arguments.seed} {i}")
            file = arguments.folder / f"mesh_{i}.msh"
            text = grid(chance)
            file.write_bytes((text if i < 3 else mutations.mesh(chance, text)).encode(LATIN, "replace"))
            files.append(file)
        lines = [f"{scene}\tBlank/File={file}" for file in files]
        for i, file, (verdict, kilobytes, seconds, said) in zip(batch, files, judged(arguments.judge, lines)):
            wrong = None
            if verdict not in ("valid", "refused"):
                wrong = f"{verdict}: {said}"
            elif verdict != "valid" and i < 3:
                wrong = "a right mesh is refused: " + said
            elif kilobytes > 64 * 1024 + len(file.read_bytes().splitlines()):
                wrong = f"{kilobytes} kB"
            findings.add(verdict, file, wrong)
            if not wrong:
                file.unlink()


def forged(content):
    """A checkpoint with the sum of what it holds."""
    head, rest = content
    opening = head[:head.index(b", layout")] + re.search(rb", layout \d+, ", head).group()
    return opening + b"%d bytes, CRC-32 %d\n" % (len(rest), zlib.crc32(rest)) + rest


def fuzz_checkpoints(arguments, findings):
    kept = []
    for name, scene, increments, options in (
            ("shell", "prm/cup.prm", 3, ("Blank/Elements=20", "Output/Travels=")),
            ("solid", "prm/upsetting.prm", 3, ("Output/Travels=",)),
            ("refined", "tests/scenes/osu_stretching_solid_refined.prm", 2, ())):
        sets = [word for option in (*options, "Output/Pictures=0") for word in ("--set", option)]
        folder = arguments.folder / name
        status, said = run(arguments.program, arguments.scenes / scene, folder, *sets, "--set",
                           f"Solver/Maximal increments={increments}")
        if status != 2:
            findings.add("no state", name, said)
            return
        kept.append((arguments.scenes / scene, folder, sets))
    for i in range(arguments.count):
        chance = random.Random(f"checkpoint {arguments.seed} {i}")
        scene, original, sets = chance.choice(kept)
        folder = arguments.folder / f"state_{i}"
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(original, folder)
        head, rest = (folder / "checkpoint.bin").read_bytes().split(b"\n", 1)
        (folder / "checkpoint.bin").write_bytes(forged((head, mutations.content(chance, rest))))
        status, said = run(arguments.program, scene, folder, *sets, "--resume", "--set", "Solver/Maximal increments=4", "--set",
                           "Solver/Maximal iterations=20")
        wrong = wrong_end(status, said, folder)
        findings.add(f"status {status}", folder, wrong)
        if not wrong:
            shutil.rmtree(folder)


def fuzz_writes(arguments, findings):
    """Killed just before the n-th call that changes a file, and resumed; then every file is that of a run left alone."""
    scene = arguments.scenes / "prm/cup.prm"
    sets = ["--set", "Blank/Elements=20", "--set", "Output/Pictures=4", "--set", "Output/Checkpoint interval=0", "--set",
            "Steps/form/End time=.1", "--set", "Output/Travels="]
    alone = arguments.folder / "alone"
    run(arguments.program, scene, alone, *sets)
    calls = "write,writev,rename,ftruncate,unlink,openat"
    for i in range(arguments.count):
        chance = random.Random(f"write {arguments.seed} {i}")
        folder = arguments.folder / f"killed_{i}"
        shutil.rmtree(folder, ignore_errors=True)
        n_kills = 0
        for attempt in range(chance.choice((1, 1, 2, 3))):
            call, n = chance.choice(calls.split(",")), round(10 ** chance.uniform(0., 2.3))
            done = subprocess.run(["strace", "-f", "-qq", "-o", "/dev/null", "-e", f"trace={call}", "-e",
                                   f"inject={call}:signal=SIGKILL:when={n}", arguments.program, scene, "--quiet", "--output",
                                   str(folder), *sets, *(["--resume"] if attempt else [])],
                                  stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            n_kills += done.returncode not in (0, 1, 2, 3)
        status, said = run(arguments.program, scene, folder, *sets, "--resume")
        different = compare(alone, folder) if status == 0 else []
        wrong = f"exit status {status}, {said[-300:]}" if status != 0 else f"different: {different}" if different else None
        findings.add("killed and identical" if n_kills and not wrong else "not hit" if not wrong else "different", folder, wrong)
        if not wrong:
            shutil.rmtree(folder)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("kind", choices=("scenes", "meshes", "checkpoints", "writes"))
    parser.add_argument("program")
    parser.add_argument("judge")
    parser.add_argument("scenes", type=pathlib.Path, help="the root of the source tree")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=300)
    parser.add_argument("--run-every", type=int, default=10, help="of the scenes that can be run")
    arguments = parser.parse_args()
    arguments.folder = arguments.folder.resolve()
    shutil.rmtree(arguments.folder, ignore_errors=True)
    arguments.folder.mkdir(parents=True)
    findings = Findings(arguments.folder)
    {"scenes": fuzz_scenes, "meshes": fuzz_meshes, "checkpoints": fuzz_checkpoints, "writes": fuzz_writes}[arguments.kind](
        arguments, findings)
    return findings.report(arguments.kind)


if __name__ == "__main__":
    sys.exit(main())
