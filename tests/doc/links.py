#!/usr/bin/env python3
"""Links of the pages lead somewhere, and their tables are whole: links.py [ROOT].

Checks every page (*.md): relative links and pictures name files, anchors name headings, and code and scenes name pages that exist ('doc/...').
Every page of doc/ can be reached from doc/README.md, every recipe links develop.md, every measured table is
linked from a page and names its script. A row of a table is one line with as many cells as its head. Exit status 1 and a line per finding.
Standard library only.
"""
import pathlib
import re
import sys
import urllib.parse

LINK = re.compile(r"(?<!\\)!?\[[^\]\[]*(?:\[[^\]]*\][^\]\[]*)*\]\(([^()\s]*(?:\([^()\s]*\))?[^()\s]*)\)")
NAMED = re.compile(r"(?<![\w/])doc/[\w./-]*\w\.(?:md|csv|png)\b")
OUTSIDE = re.compile(r"[a-z]+:")
CODE = re.compile(r"```.*?```|`(?:[^`\n]|\n(?!\n))*`", re.DOTALL)


def pages(root):
    return sorted([*root.glob("*.md"), *(root / "doc").rglob("*.md")])


def anchors(page):
    """As GitHub makes them of headings: lower case, hyphens for blanks, punctuation left out, -1, -2 for headings met before."""
    found, text = set(), re.sub(r"```.*?```", "", page.read_text(encoding="utf-8"), flags=re.DOTALL)
    for heading in re.findall(r"^#{1,6} +(.*?) *#*$", text, flags=re.MULTILINE):
        heading = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading).lower()
        name = re.sub(r"[^\w\- ]", "", heading).replace(" ", "-")
        number, unique = 0, name
        while unique in found:
            number += 1
            unique = f"{name}-{number}"
        found.add(unique)
    return found | set(re.findall(r'<a (?:id|name)="([^"]+)"', text))


def links(page):
    return [urllib.parse.unquote(link) for link in LINK.findall(CODE.sub(lambda match: "`" if match.group().startswith("`") else "",
                                                                         page.read_text(encoding="utf-8")))]


def broken_rows(page):
    """Lines of tables that do not end as they begin, or that have other cells than the head of the table."""
    found, in_code, cells = [], False, 0
    for number, line in enumerate(page.read_text(encoding="utf-8").splitlines(), 1):
        in_code ^= line.startswith("```")
        is_row = line.startswith("|") and not in_code
        bars = len(re.findall(r"(?<!\\)\|", line)) if is_row else 0
        if is_row and (not line.rstrip().endswith("|") or cells not in (0, bars)):
            found.append(number)
        cells = cells or bars if is_row else 0
    return found


def check(root):
    """@return sentences"""
    found, targets = [], {}
    for page in pages(root):
        targets[page] = set()
        found += [f"{page.relative_to(root)}: line {number} is no whole row of its table" for number in broken_rows(page)]
        for link in links(page):
            if OUTSIDE.match(link):
                continue
            path, _, anchor = link.partition("#")
            target = (page.parent / path).resolve() if path else page
            targets[page].add(target)
            if not target.exists():
                found.append(f"{page.relative_to(root)}: there is no '{link}'")
            elif anchor and target.suffix == ".md" and anchor not in anchors(target):
                found.append(f"{page.relative_to(root)}: '{link}': there is no such heading")
    for folder in ("source", "include", "tests", "prm", "scripts", "cmake"):
        for file in sorted((root / folder).rglob("*")):
            if file.suffix not in (".cc", ".h", ".py", ".sh", ".prm", ".cmake", ".txt") or "__pycache__" in file.parts:
                continue
            if file.name == "broken_links.py":  # its pages are made up
                continue
            for name in NAMED.findall(file.read_text(encoding="utf-8", errors="replace")):
                if "NAME" not in name and not (root / name).exists():
                    found.append(f"{file.relative_to(root)}: there is no '{name}'")
    start = root / "doc" / "README.md"
    reached, waiting = {start}, [start]
    while waiting:
        for target in targets.get(waiting.pop(), ()):
            if target not in reached:
                reached.add(target)
                waiting.append(target)
    linked = set().union(*targets.values())
    for page in pages(root):
        if page.is_relative_to(root / "doc") and page not in reached and page.parent.name != "changes":
            found.append(f"{page.relative_to(root)}: no way leads here from doc/README.md")
    for recipe in sorted((root / "doc" / "recipes").glob("*.md")):
        if root / "doc" / "develop.md" not in targets[recipe]:
            found.append(f"{recipe.relative_to(root)}: a recipe links develop.md")
    for table in sorted((root / "doc" / "measured").glob("*")):
        if table not in linked:
            found.append(f"{table.relative_to(root)}: no page links this table")
        script = re.match(r"# .*\n# (\S+), deltaform \S+\n", table.read_text(encoding="utf-8"))
        if not script or not (root / script.group(1)).exists():
            found.append(f"{table.relative_to(root)}: its second line names no script that exists")
    return found


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent.parent).resolve()
    findings = check(root)
    print("\n".join(findings) or f"{len(pages(root))} pages: every link leads somewhere")
    sys.exit(1 if findings else 0)


if __name__ == "__main__":
    main()
