#!/usr/bin/env python3
"""summary.json can be read whatever the scene is called: quotes and line breaks are escaped, text that is not UTF-8 is replaced.
Its rejected_iterations are those that the log tells of the attempts that failed.

    summary.py PROGRAM SCENE FOLDER
"""
import json
import re
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
    count_rejected(program, scene, Path(folder))


def count_rejected(program, scene, folder):
    """Increments that grow until four iterations are not enough: all that fail do so for want of iterations."""
    subprocess.run([program, scene, "--quiet", "--output", folder, "--set", "Steps/form/End time=0.3", "--set", "Output/Travels=",
                    "--set", "Output/Pictures=0", "--set", "Solver/Maximal iterations=4", "--set", "Solver/Target iterations=100", "--set",
                    "Steps/form/Largest increment=0.2"], check=True, stderr=subprocess.DEVNULL)
    cuts = [line for line in (folder / "run.log").read_text(encoding="utf-8").splitlines() if "cut back" in line]
    logged = [int(count) for line in cuts for count in re.findall(r"did not converge in (\d+) iterations", line)]
    summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    if not cuts or len(logged) != len(cuts) or len(cuts) != summary["cutbacks"]:
        sys.exit(f"summary.py: {len(cuts)} attempts failed, {len(logged)} for want of iterations; {summary['cutbacks']} cut back")
    if summary["rejected_iterations"] != sum(logged) or summary["rejected_iterations"] >= summary["newton_iterations"]:
        sys.exit(f"summary.py: {summary['rejected_iterations']} iterations rejected of {summary['newton_iterations']}, {sum(logged)} in the log")


if __name__ == "__main__":
    main()
