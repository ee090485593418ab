#!/usr/bin/env python3
"""Tables of sweeps are plotted: a grid, samples, values that are words, runs that failed.

    tests/app/plot_sweep.py PROGRAM SCENE SCRIPT WORK_FOLDER
"""
import os
import shutil
import subprocess
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402


def sweep(program, scene, folder, *words):
    """The exit status of a short sweep."""
    short = ("--set", "Steps/form/End time=.1", "--set", "Output/Pictures=0")
    return subprocess.run([program, "sweep", scene, *short, *words, "--quiet", "--output", folder], check=False).returncode


def main():
    program, scene, script, work = (os.path.abspath(word) for word in sys.argv[1:])
    shutil.rmtree(work, ignore_errors=True)
    os.makedirs(work)
    sys.path.insert(0, os.path.dirname(script))
    import plot_sweep

    # A grid: lines, one for each value of the other entry.
    grid = os.path.join(work, "grid")
    assert sweep(program, scene, grid, "--vary", "Tools/punch/Friction coefficient=0,.2,.4", "--vary", "Contact/Penalty rule=adaptive,paper") == 0
    table = plot_sweep.Sweep(grid)
    assert table.varied == ["Tools/punch/Friction coefficient", "Contact/Penalty rule"]
    figure = plot_sweep.draw(table, ["force_z", "newton_iterations"])
    axis = figure.axes[0]
    assert [len(line.get_xdata()) for line in axis.get_lines()] == [3, 3]
    rows = [row for row, rule in enumerate(table.table.words("Contact/Penalty rule")) if rule == "adaptive"]
    assert list(axis.get_lines()[0].get_ydata()) == [table.table["force_z"][row] for row in rows]
    assert axis.get_ylabel() == "force of the main tool [tonf]", axis.get_ylabel()
    assert [label.get_text() for label in figure.axes[1].get_xticklabels()] == ["adaptive", "paper"]
    plt.close(figure)

    # Samples: points. One run cannot end well, as nobody lets it: a cross.
    samples = os.path.join(work, "samples")
    assert sweep(program, scene, samples, "--vary", "Tools/punch/Friction coefficient=0:.4", "--vary", "Tools/die/Profile radius=.2:.4", "--samples", "6",
                 "--seconds", "60") == 0
    path = os.path.join(samples, "sweep.csv")
    with open(path, encoding="utf-8") as file:
        text = file.read()
    assert text.count(",0,done,") == 6, text
    with open(path, "w", encoding="utf-8") as file:
        file.write(text.replace(",0,done,", ",2,the sheet tears,", 1))
    table = plot_sweep.Sweep(samples)
    figure = plot_sweep.draw(table, plot_sweep.usual_columns(table))
    assert len(figure.axes[0].collections[0].get_offsets()) == 5 and len(figure.axes[0].get_lines()) == 1
    assert "1 of which not to the end" in figure._suptitle.get_text()
    plt.close(figure)

    # As a user calls it.
    said = subprocess.run([script, samples], capture_output=True, text=True, check=True).stdout.strip()
    picture = plt.imread(said)
    assert said == os.path.join(samples, "sweep.png") and picture[..., :3].std() > .02, said
    for words in ([work], [samples, "--columns", "outcome"], [samples, "--columns", "nothing"]):
        failed = subprocess.run([script, *words], capture_output=True, text=True, check=False)
        assert failed.returncode == 1 and failed.stderr.startswith("plot_sweep.py: "), failed
    print("two tables plotted")


if __name__ == "__main__":
    main()
