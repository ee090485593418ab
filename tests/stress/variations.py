#!/usr/bin/env python3
"""Runs processes of a press shop that are drawn at random, and again with what must not matter:

    far        one more tool, which never touches: nothing may change at all
    mirrored   the process turned upside down
    split      the first stage in two, with increments of the same length

    variations.py PROGRAM FOLDER [--first N] [--count N] [--seconds N] [--jobs N] [--worst SHARE] [--again FILE ...] [--write]

The exit status is 1 if one of the two stops and the other does not, or if a scene without a warning differs in its largest
force or least thickness by more than --worst (far: at all). --write renews doc/measured/stress_variations.csv.
"""
import re
import shutil
import sys

import draw_shop
from shop import LARGEST, measures
from stress import MeasuredTable, run_limited, warnings_of
from study import options, results_of


class DoesNotApply(Exception):
    """The variation is not one of this scene."""


def far(text):
    names = re.search(r"(subsection Tools\n  set Names = .*)\n", text)
    if not names:
        raise DoesNotApply("no tools")
    return text.replace(names[0], names[1] + """, far
  subsection far
    set Side = top
    set Shape = plate
    set Position z = 5000
    set Friction coefficient = 0.1
  end
""")


def split(text):
    names = [name.strip() for name in re.search(r"set Stages = (.*)", text)[1].split(",")]
    first = re.search(rf"  subsection {names[0]}\n(.*?)\n  end", text, re.DOTALL)
    end = re.search(r"set End time = (\S+)", first[1])
    if "Largest increment" in first[1]:
        raise DoesNotApply("increments are not those of the default")
    half = first[1].replace(end[0], f"set End time = {float(end[1]) / 2:.12g}")
    half = re.sub(r"\n *set Ends when.*", "", half)
    text = text.replace(first[0], f"  subsection {names[0]} begins\n{half}\n  end\n{first[0]}")
    tools_of = re.compile(rf"(set Stages = )(.*\b){names[0]}\b")
    return tools_of.sub(lambda found: f"{found[1]}{found[2]}{names[0]} begins, {names[0]}", text)


def shorter(text):
    """The scene that split() is compared with: increments of half the length in its first stage."""
    end = re.search(r"set End time = (\S+)", text)
    return text.replace(end[0], f"{end[0]}\n    set Largest increment = {LARGEST / 2 * float(end[1]):.12g}", 1)


def negated(number):
    number = number.strip()
    return number[1:] if number.startswith("-") else number if float(number) == 0 else "-" + number


def mirrored_points(text, of_tool):
    points = [" ".join([r, negated(z)]) for r, z in (point.split() for point in text.split(";"))]
    return "; ".join(reversed(points) if of_tool else points)


def mirrored_value(text):
    if ":" in text:
        return ", ".join(f"{at}:{negated(value)}" for at, value in (pair.split(":") for pair in text.split(",")))
    return f"-({text})"


OTHER_SIDE = {"top": "bottom", "bottom": "top"}


def mirrored(text):
    if "subsection Loads" in text:
        raise DoesNotApply("the sign of a pressure belongs to its face")
    path, component, lines = [], "", []
    for line in text.splitlines():
        if found := re.match(r"\s*subsection (.*)", line):
            path.append(found[1])
        elif line.strip() == "end":
            path.pop()
        elif found := re.match(r"(\s*set )(.*?)( = )(.*)", line):
            begin, name, equals, value = found.groups()
            of_tool = path[:1] == ["Tools"] and len(path) > 1
            if name == "Points":
                value = mirrored_points(value, of_tool)
            elif name == "Fillet radii" and of_tool:
                value = ", ".join(reversed(value.split(", ")))
            elif name == "Position z":
                value = negated(value)
            elif name in ("Side", "Points lie on the"):
                value = OTHER_SIDE.get(value, value)
            elif name == "Direction":
                value = " ".join([value.split()[0], negated(value.split()[1])])
            elif name in ("Contact top", "Contact bottom"):
                name = "Contact " + OTHER_SIDE[name.split()[1]]
            elif name == "Component":
                component = value
            elif name == "Value" and component in ("z", "rotation"):
                value = mirrored_value(value)
            elif name == "Boundary":
                value = OTHER_SIDE.get(value, value)
            if name.startswith("Contact "):
                value = ", ".join(OTHER_SIDE.get(part, part) for part in value.split(", "))
            line = begin + name + equals + value
        lines.append(line)
    return "\n".join(lines) + "\n"


VARIATIONS = {"far": (str, far), "mirrored": (str, mirrored), "split": (shorter, split)}


def one_run(program, work, name, text, limit):
    scene, folder = work / f"{name}.prm", work / name
    shutil.rmtree(folder, ignore_errors=True)
    scene.write_text(text)
    status, said, _ = run_limited([program, str(scene), "--quiet", "--output", str(folder), "--set", "Output/Checkpoint interval=0",
                                   "--set", "Output/Pictures=0"], work / f"{name}.txt", limit)
    result = {"status": status}
    if status == 0:
        found = measures(folder)
        result.update(force=found["force"], thickness=found["thickness"], warned=bool(warnings_of(folder)))
    else:
        result["said"] = said[-400:]
    shutil.rmtree(folder, ignore_errors=True)
    scene.unlink()
    return result


def run(program, work, seed, limit):
    text, kind = draw_shop.draw(seed)
    result, known = {"seed": seed, "kind": kind}, {}
    for name, (as_it_is, change) in VARIATIONS.items():
        try:
            varied = change(text)
        except DoesNotApply:
            continue
        if as_it_is not in known:
            known[as_it_is] = one_run(program, work, f"{seed:05d}_{as_it_is.__name__}", as_it_is(text), limit)
        result[name] = [known[as_it_is], one_run(program, work, f"{seed:05d}_{name}", varied, limit)]
    return result


def difference(pair, name):
    one, other = (run_of[name] or 0. for run_of in pair)
    return abs(one - other) / max(abs(one), abs(other), 1e-300)


def table_of(results):
    table = MeasuredTable(["variation", "scenes", "both done", "without a warning", "force: median", "worst", "of seed", "thickness: worst"])
    for name in VARIATIONS:
        pairs = [(r["seed"], r[name]) for r in results if name in r]
        done = [(seed, pair) for seed, pair in pairs if all(one["status"] == 0 for one in pair)]
        silent = [(seed, pair) for seed, pair in done if not pair[0]["warned"]]
        if not silent:
            continue
        forces = sorted((difference(pair, "force"), seed) for seed, pair in silent)
        table.add(name, len(pairs), len(done), len(silent), f"{forces[len(forces) // 2][0]:.1e}", f"{forces[-1][0]:.1e}", forces[-1][1],
                  f"{max(difference(pair, 'thickness') for _, pair in silent):.1e}")
    return table


def complaints(result, worst):
    """What is wrong with a scene, in sentences."""
    texts = []
    for name in VARIATIONS:
        if name not in result:
            continue
        pair, allowed = result[name], 0. if name == "far" else worst
        if pair[0]["status"] != pair[1]["status"]:
            texts.append(f"{name}: status {pair[1]['status']} for {pair[0]['status']}: {pair[1].get('said', pair[0].get('said'))}")
        elif pair[0]["status"] == 0 and not pair[0]["warned"]:
            texts += [f"{name}: its {what} differs by {difference(pair, what):.2g}" for what in ("force", "thickness")
                      if difference(pair, what) > allowed]
    return texts


def main():
    parser = options(__doc__, 60)
    parser.add_argument("--worst", type=float, default=.02)
    arguments = parser.parse_args()
    results = results_of(arguments, run, "variations.jsonl")
    print(table_of(results))
    bad = [(result, complaint) for result in results for complaint in complaints(result, arguments.worst)]
    for result, complaint in bad:
        print(f"{result['seed']}, {result['kind']}: {complaint}")
    if arguments.write:
        table_of(results).write("stress_variations", "processes drawn at random, again with what must not matter: relative differences",
                                script="tests/stress/variations.py")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
