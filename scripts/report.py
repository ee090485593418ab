#!/usr/bin/env python3
"""Write a report of one or more runs: one HTML file that opens in a browser, without network.

    scripts/report.sh output/cup                                     output/cup/report.html; installs plotly if it is missing
    scripts/report.sh output/cup output/slippery --file compared.html
    scripts/report.py output/cup --plotly plotly.js                  the same with a plotly.js of your own

The section as a film, forces over travel, values along the sheet, contact, energies, cost and causes of cut increments,
and the scene with what differs between the runs. Standard library only; the page is scripts/report_page/page.html and page.js.
"""
import argparse
import base64
import gzip
import json
import os
import sys

from report_page import data

HERE = os.path.dirname(os.path.abspath(__file__))
PLOTLY = "/usr/share/python3-plotly/plotly.js"  # Debian's python3-plotly
MOST_BYTES = 7_500_000  # of the page


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", metavar="FOLDER", help="of the results of a run; several to compare")
    parser.add_argument("--file", help="default: report.html in the first folder")
    parser.add_argument("--plotly", default=PLOTLY, help="the library that draws (%(default)s)")
    return parser.parse_args()


def packed(text):
    """Compressed, as letters; the browser unpacks it."""
    return base64.b64encode(gzip.compress(text.encode(), 9, mtime=0)).decode()


def page(runs, library):
    """The page as a text."""
    parts = {}
    for name in ("page.html", "page.js", "page.css"):
        with open(os.path.join(HERE, "report_page", name), encoding="utf-8") as file:
            parts[name] = file.read()
    # JSON knows no numbers that are none.
    return (parts["page.html"].replace("@STYLE@", parts["page.css"])
            .replace("@DATA@", packed(json.dumps(runs, allow_nan=False, separators=(",", ":"))))
            .replace("@LIBRARY@", packed(library)).replace("@SCRIPT@", parts["page.js"]))


def main():
    options = arguments()
    try:
        with open(options.plotly, encoding="utf-8") as file:
            library = file.read()
        runs = [data.run(folder) for folder in options.folders]
        data.tell_apart(runs)
        text = page(runs, library)
        # Fewer pictures of the film until the page is small enough to be sent.
        while len(text) > MOST_BYTES and data.thin_films(runs):
            text = page(runs, library)
        path = options.file or os.path.join(options.folders[0], "report.html")
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
    except (data.NoRun, OSError) as error:
        sys.exit(f"report.py: {error}")
    print(f"{path} ({len(text) / 1e6:.1f} MB)")


if __name__ == "__main__":
    main()
