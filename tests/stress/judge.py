#!/usr/bin/env python3
"""The judge of the stress test against results made up to be wrong: judge.py FOLDER."""
import json
import pathlib
import shutil
import sys

import stress

folder = pathlib.Path(sys.argv[1])
HEAD = "# units\nincrement,stage,time,max_penetration,max_penetration_over_delta\n"
STOPPED = "warning: stage 'form' stopped at time 0.5, in increment 3: Newton did not converge"
failures = 0


def expect(kind, status, said="", history=HEAD + "1,form,1,1e-3,0.99\n", summary=None):
    global failures
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    (folder / "history.csv").write_text(history)
    (folder / "summary.json").write_text(json.dumps(summary or {"exit_status": status, "time": 1}))
    got = stress.judge({"size": 100.}, folder, status, said, 1., 60.)
    if got[0] != kind:
        failures += 1
        print(f"expected '{kind}', the judge said {got}")


expect("done", 0)
expect("done", 0, history=HEAD + "1,form,1,1e-3,1.0000005\n")
expect("promise broken silently", 0, history=HEAD + "1,form,1,1e-3,1.00001\n")
expect("done", 0, history=HEAD + "1,form,1,1e-9,1.00001\n")  # 1e-14 in coordinates of size 100: the last digit
expect("NaN in a result", 0, history=HEAD + "1,form,1,nan,0\n")
expect("NaN in a result", 0, history=HEAD + "1,form,1,-inf,0\n")
expect("crash", -11)
expect("crash", 1, "deltaform: an error of the program, please report it:")
expect("crash", 134)
expect("hang", None)
expect("stopped", 2, STOPPED)
expect("stopped", 3, STOPPED)
expect("necks", 2, STOPPED + " The node 3 at R0 = 1 necks: ...")
expect("status and message disagree", 2)
expect("status and message disagree", 0, STOPPED)
expect("status and message disagree", 0, summary={"exit_status": 0, "time": .5})
expect("status and message disagree", 1, "nothing")
expect("refused", 1, "deltaform: scene.prm:3: Blank/Thickness = 0: must be positive")
sys.exit(1 if failures else 0)
