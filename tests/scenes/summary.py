#!/usr/bin/env python3
"""summary.json can be read whatever the scene is called: quotes and line breaks are escaped, text that is not UTF-8 is replaced.

    summary.py PROGRAM SCENE FOLDER
"""
import json
import subprocess
import sys
from pathlib import Path


def main():
    program, scene, folder = sys.argv[1:]
    for title, expected in ((b'a "cup" \\ of 2 \xc2\xb5m', 'a "cup" \\ of 2 \u00b5m'), (b"T\xfcr", "T\ufffdr")):
        subprocess.run([program, scene, "--quiet", "--output", folder, "--set", "Steps/form/End time=0.02", "--set", "Output/Travels=",
                        "--set", "Output/Pictures=0", "--set", b"Title=" + title], check=True)
        content = (Path(folder) / "summary.json").read_bytes()
        summary = json.loads(content)
        if summary["title"] != expected:
            sys.exit(f"summary.py: the title {title} is read back as {summary['title']}")
        if next(iter(summary)) != "title" or list(summary["tools"]) != ["punch", "die", "holder"]:
            sys.exit(f"summary.py: members are not in their order: {list(summary)}, {list(summary['tools'])}")
        if not content.endswith(b"}\n"):
            sys.exit("summary.py: the last line has no end")


if __name__ == "__main__":
    main()
