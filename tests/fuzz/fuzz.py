#!/usr/bin/env python3
"""Bad input by the thousand: no crash, no hang, no number that is none, no exception without a name, no memory out of
proportion.

    fuzz.py scenes      PROGRAM RUN_MANY SCENES FOLDER [--seed N] [--count N]  mutated scenes are checked; some are run
    fuzz.py meshes      PROGRAM RUN_MANY SCENES FOLDER [--seed N] [--count N]  mutated Gmsh files, formats 2.2, 4.0, 4.1
    fuzz.py checkpoints PROGRAM RUN_MANY SCENES FOLDER [--seed N] [--count N]  damaged states whose sums are right
    fuzz.py writes      PROGRAM RUN_MANY SCENES FOLDER [--seed N] [--count N]  killed at the n-th write, then resumed
    fuzz.py full        PROGRAM RUN_MANY SCENES FOLDER [--seed N] [--count N]  a disk that is full from the n-th write on

RUN_MANY is the program with many command lines (run_many.cc). What fails is kept in FOLDER. A seed is a case: the same ones
come again."""
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

CHECKING, RUNNING = 20, 100  # seconds of processor time that a case may take
LATIN = "latin-1"  # a byte is a character


class Findings:
    """How the cases ended, and those that must not have."""

    def __init__(self, folder):
        self.folder, self.ends, self.runs, self.bad, self.kills = folder, collections.Counter(), collections.Counter(), [], 0

    def add(self, end, case, wrong=None):
        self.ends[end] += 1
        if wrong:
            self.bad.append(f"{case}: {wrong}")

    def report(self, what):
        total = sum(self.ends.values())
        listed = lambda ends: ", ".join(f"{n} {end}" for end, n in ends.most_common())
        runs = f"; {sum(self.runs.values())} of them run: {listed(self.runs)}" if self.runs else ""
        kills = f"; {self.kills} kills" if self.kills else ""
        print(f"{total} {what}: {listed(self.ends)}{runs}{kills}; {len(self.bad)} findings")
        for line in self.bad[:20]:
            print("  " + line[:600])
        return 1 if self.bad or total == 0 else 0


def ends_of(run_many, seconds, commands):
    """(end, kB, seconds, said) of each command, a list of words."""
    lines = "\n".join("\t".join(map(str, words)) for words in commands)
    process = subprocess.run([run_many, str(seconds)], input=lines + "\n" if lines else "", stdout=subprocess.PIPE,
                             stderr=subprocess.DEVNULL, encoding=LATIN, check=True)
    ends = process.stdout.split("\n")[:-1]
    if len(ends) != len(commands):
        sys.exit(f"run_many has ended itself: {len(ends)} of {len(commands)} ends")
    for line in ends:
        end, kilobytes, taken, _, said = line.split("\t", 4)
        said = re.sub(r"\\(.)", lambda found: {"n": "\n", "t": "\t"}.get(found.group(1), found.group(1)), said)
        yield end, int(kilobytes), float(taken), said


def n_calls_of(run_many, command):
    """How often a command changes files."""
    line = "\t".join(map(str, command)) + "\n"
    return int(subprocess.run([run_many, str(RUNNING)], input=line, stdout=subprocess.PIPE, encoding=LATIN,
                              check=True).stdout.split("\t")[3])


def not_finite(folder):
    """A cell of a table that is no number, or a file that should not be there, or None."""
    for path in folder.glob("*.csv"):
        for line in path.read_text(encoding=LATIN).splitlines():
            if not line.startswith("#") and re.search(r"(^|,)[+-]?(nan|inf)(,|$)", line):
                return f"{path.name}: {line[:100]}"
    for path in folder.glob("*.vtu"):
        if re.search(rb"[ >][+-]?(nan|inf)[ <]", path.read_bytes()):
            return f"{path.name} has numbers that are none"
    for path in folder.glob("*.json"):
        try:
            found = re.search(r"\b(NaN|Infinity)\b", path.read_text(encoding="utf-8"))
        except UnicodeDecodeError:
            return f"{path.name} is no UTF-8"
        if found:
            return f"{path.name}: {found.group()}"
    left = [path.name for path in folder.glob("*.part")] + [path.name for path in folder.glob("deltaform.lock")]
    return f"left behind: {left}" if left else None


def wrong_words(end, said):
    """Why a command must not have ended like this and said that, or None."""
    if end not in ("status 0", "status 1", "status 2", "status 3"):
        return f"{end}: {said[-300:]}"
    if "error of the program" in said:
        return said[-400:]
    if "not enough memory" in said:
        return "memory over the limit: " + said[-300:]
    if "dealii::" in said or "boost::" in said or "std::" in said:
        return "shows an exception of a library: " + said[-400:]
    if re.search(r"[\x00-\x08\x0b-\x1f\x7f]", said):
        return "control characters on the terminal: " + repr(said[:200])
    if end == "status 1" and ":" not in said:
        return "names no place: " + said
    return None


def run(program, scene, folder, *options):
    """(exit status, what it said) of a process of its own; status None: it did not end."""
    try:
        done = subprocess.run([program, scene, "--quiet", "--output", str(folder), *options], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, timeout=RUNNING)
        return done.returncode, done.stdout.decode(LATIN)
    except subprocess.TimeoutExpired:
        return None, "not ended"


def batches(count, size):
    for first in range(0, count, size):
        yield range(first, min(first + size, count))


def read_originals(root):
    """The shipped scenes and those of tests, as they are; what they include lies where it says."""
    result = []
    for path in sorted(root.glob("prm/*.prm")) + sorted(root.glob("tests/scenes/*.prm")):
        text = path.read_text()
        result.append(re.sub(r"(?m)^include (.*)$", lambda found: f"include {(path.parent / found.group(1)).resolve()}", text))
    return result


def with_defaults(run_many, root):
    """The shipped scenes with every entry."""
    commands = [(path, "--print-parameters") for path in sorted(root.glob("prm/*.prm"))]
    return [said for _, _, _, said in ends_of(run_many, CHECKING, commands)]


def fuzz_scenes(arguments, findings):
    originals, full = read_originals(arguments.scenes), with_defaults(arguments.run_many, arguments.scenes)
    vocabulary = mutations.Vocabulary(originals + full)
    for batch in batches(arguments.count, 200):
        files = []
        for i in batch:
            chance = random.Random(f"scene {arguments.seed} {i}")
            file = arguments.folder / f"scene_{i}.prm"
            text = mutations.scene(chance, chance.choice(chance.choice((originals, full))), vocabulary)
            file.write_bytes(text.encode("utf-8" if chance.random() < .7 else LATIN, "replace"))
            files.append(file)
        valid = check_scenes(arguments, findings, batch, files)
        run_scenes(arguments, findings, [case for case in valid if case[0] % arguments.run_every == 0])
        for _, file in valid:
            if file.exists() and not any(str(file) in line for line in findings.bad):
                file.unlink()


def check_scenes(arguments, findings, batch, files):
    """Numbers and files of those that are valid; those that are refused as they should be are removed."""
    valid = []
    svg = arguments.folder / "drawing.svg"
    commands = [(file, "--check", *(("--svg", svg) if i % 10 == 0 else ())) for i, file in zip(batch, files)]
    for i, file, (end, _, _, said) in zip(batch, files, ends_of(arguments.run_many, CHECKING, commands)):
        wrong = wrong_words(end, said)
        findings.add({"status 0": "valid", "status 1": "refused"}.get(end, end), file, wrong)
        if end == "status 0" and not wrong:
            valid.append((i, file))
        elif not wrong:
            file.unlink()
    return valid


def run_scenes(arguments, findings, cases):
    folders = [arguments.folder / f"run_{i}" for i, _ in cases]
    commands = [(file, "--quiet", "--output", folder, "--set", "Solver/Maximal increments=4", "--set",
                 "Solver/Maximal iterations=20") for (_, file), folder in zip(cases, folders)]
    for (_, file), folder, (end, _, _, said) in zip(cases, folders, ends_of(arguments.run_many, RUNNING, commands)):
        wrong = wrong_words(end, said) or not_finite(folder)
        findings.runs[end] += 1
        if wrong:
            findings.bad.append(f"{file}, run: {wrong}")
        shutil.rmtree(folder, ignore_errors=True)


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
        commands = [(scene, "--check", "--set", f"Blank/File={file}") for file in files]
        for i, file, (end, kilobytes, _, said) in zip(batch, files, ends_of(arguments.run_many, CHECKING, commands)):
            wrong = wrong_words(end, said)
            if end != "status 0" and i < 3 and not wrong:
                wrong = "a right mesh is refused: " + said
            elif not wrong and kilobytes > 64 * 1024 + len(file.read_bytes().splitlines()):
                wrong = f"{kilobytes} kB"
            findings.add({"status 0": "valid", "status 1": "refused"}.get(end, end), file, wrong)
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
    for batch in batches(arguments.count, 100):
        folders, commands = [], []
        for i in batch:
            chance = random.Random(f"checkpoint {arguments.seed} {i}")
            scene, original, sets = chance.choice(kept)
            folder = arguments.folder / f"state_{i}"
            shutil.rmtree(folder, ignore_errors=True)
            shutil.copytree(original, folder)
            head, rest = (folder / "checkpoint.bin").read_bytes().split(b"\n", 1)
            (folder / "checkpoint.bin").write_bytes(forged((head, mutations.content(chance, rest))))
            folders.append(folder)
            commands.append((scene, "--quiet", "--output", folder, *sets, "--resume", "--set", "Solver/Maximal increments=4",
                             "--set", "Solver/Maximal iterations=20"))
        for folder, (end, _, _, said) in zip(folders, ends_of(arguments.run_many, RUNNING, commands)):
            wrong = wrong_words(end, said) or not_finite(folder)
            findings.add(end, folder, wrong)
            if not wrong:
                shutil.rmtree(folder)


class Interrupted:
    """The cup with many files, and what it leaves behind when it is left alone."""

    def __init__(self, arguments):
        self.arguments, self.alone = arguments, arguments.folder / "alone"
        self.sets = [word for entry in ("Blank/Elements=20", "Output/Pictures=4", "Output/Checkpoint interval=0",
                                        "Steps/form/End time=.1", "Output/Travels=.05") for word in ("--set", entry)]
        (end, _, _, said), = self.run([self.command(self.alone)])
        if end != "status 0":
            sys.exit("the run that is left alone is not done: " + said)
        self.n_calls = n_calls_of(arguments.run_many, self.command(arguments.folder / "counted"))

    def command(self, folder, *options):
        return [self.arguments.scenes / "prm/cup.prm", "--quiet", "--output", folder, *self.sets, *options]

    def run(self, commands):
        return list(ends_of(self.arguments.run_many, RUNNING, commands))

    def resumed(self, folder):
        """Why the results of a run that goes on in @p folder to its end are not those of one left alone, or None."""
        (end, _, _, said), = self.run([self.command(folder, "--resume")])
        if end != "status 0":
            return f"resumed: {end}, {said[-300:]}"
        different = compare(self.alone, folder)
        return f"different: {different}" if different else not_finite(folder)


def fuzz_writes(arguments, findings):
    """Killed just before the n-th call that changes a file, up to three times, and resumed."""
    cup = Interrupted(arguments)
    for i in range(arguments.count):
        chance = random.Random(f"write {arguments.seed} {i}")
        folder = arguments.folder / f"killed_{i}"
        commands = []
        for attempt in range(chance.choice((1, 1, 2, 3))):
            n = 1 + int(cup.n_calls * chance.random() * (1 if attempt == 0 else .5))
            commands.append([f"@killed={n}"] + cup.command(folder, *(["--resume"] if attempt else [])))
        ends = cup.run(commands)
        n_kills = sum(end == "signal 9" for end, _, _, _ in ends)
        unwanted = [f"{end}: {said[-300:]}" for end, _, _, said in ends if end not in ("signal 9", "status 0")]
        wrong = unwanted[0] if unwanted else cup.resumed(folder)
        findings.kills += n_kills
        findings.add("different" if wrong else "killed and identical" if n_kills else "not hit", folder, wrong)
        if not wrong:
            shutil.rmtree(folder)


def half_rows(folder):
    """A table whose last row is not whole, or None."""
    for path in folder.glob("*.csv"):
        content = path.read_text(encoding=LATIN)
        rows = [line.count(",") for line in content.splitlines() if not line.startswith("#")]
        if content and not content.endswith("\n") or len(set(rows)) > 1:
            return f"{path.name} ends with half a row"
    return None


def fuzz_full(arguments, findings):
    """From the n-th call on nothing can be written; there is room again, and the run goes on."""
    cup = Interrupted(arguments)
    for i in range(arguments.count):
        chance = random.Random(f"full {arguments.seed} {i}")
        folder = arguments.folder / f"full_{i}"
        n = 1 + int(cup.n_calls * chance.random())
        (end, _, _, said), = cup.run([[f"@full={n}"] + cup.command(folder)])
        # The last calls only remove files.
        wrong = wrong_words(end, said) or half_rows(folder) or not_finite(folder)
        if not wrong and end != "status 0" and "No space left on device" not in said:
            wrong = f"{end}, and does not say why: {said}"
        findings.add("said so" if end == "status 1" else end, folder, wrong or cup.resumed(folder))
        if not wrong:
            shutil.rmtree(folder)


KINDS = {"scenes": fuzz_scenes, "meshes": fuzz_meshes, "checkpoints": fuzz_checkpoints, "writes": fuzz_writes, "full": fuzz_full}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("kind", choices=KINDS)
    parser.add_argument("program")
    parser.add_argument("run_many")
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
    KINDS[arguments.kind](arguments, findings)
    return findings.report(arguments.kind)


if __name__ == "__main__":
    sys.exit(main())
