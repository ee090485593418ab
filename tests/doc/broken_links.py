#!/usr/bin/env python3
"""links.py finds what it is to find, and nothing else: broken_links.py FOLDER. Standard library only."""
import pathlib
import shutil
import sys

import links

PAGES = {
    "README.md": "# Top\n[index](doc/README.md) [web](https://nowhere.example/x.md) `[code](no.md)`\n",
    "doc/README.md": "# Index\n[a](a.md#a-heading-p--delta) [again](a.md#twice-1) [gone](b.md) [no heading](a.md#b) ![picture](c.png)\n[itself](#index) [own](a.md#here)\n",
    "doc/a.md": "# A heading: p & delta\n## Twice\n## Twice\n<a id=\"here\"></a>\n```\n# no heading\n[code](no.md)\n```\n[table](measured/t.csv) [up](../README.md#code)\n",
    "doc/lost.md": "# Lost\n\n| a | b |\n|---|---|\n| whole \\| row | 1 |\n| in two\nlines | 2 |\n\n| a |\n|---|\n| two | cells |\n",
    "doc/recipes/add_a_law.md": "# Add a law\n",
    "doc/measured/t.csv": "# what\n# source/law.cc, deltaform 1\na\n1\n",
    "doc/measured/unread.csv": "# what\n# scripts/gone.py, deltaform 1\na\n1\n",
    "source/law.cc": "// Derivation: doc/a.md, and doc/theory/none.md.\n",
}
EXPECTED = {
    "doc/README.md: there is no 'b.md'",
    "doc/README.md: there is no 'c.png'",
    "doc/README.md: 'a.md#b': there is no such heading",
    "doc/a.md: '../README.md#code': there is no such heading",
    "doc/lost.md: no way leads here from doc/README.md",
    "doc/lost.md: line 6 is no whole row of its table",
    "doc/lost.md: line 11 is no whole row of its table",
    "doc/recipes/add_a_law.md: a recipe links develop.md",
    "doc/recipes/add_a_law.md: no way leads here from doc/README.md",
    "doc/measured/unread.csv: no page links this table",
    "doc/measured/unread.csv: its second line names no script that exists",
    "source/law.cc: there is no 'doc/theory/none.md'",
}


def main():
    root = pathlib.Path(sys.argv[1]).resolve() / "broken_links"
    shutil.rmtree(root, ignore_errors=True)
    for name, text in PAGES.items():
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_text(text, encoding="utf-8")
    found = set(links.check(root))
    wrong = [f"not found: {finding}" for finding in sorted(EXPECTED - found)] + [f"false alarm: {finding}" for finding in sorted(found - EXPECTED)]
    print("\n".join(wrong) or f"{len(found)} broken links are found")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
