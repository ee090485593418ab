"""Instructions and calls of functions, counted by valgrind's callgrind."""
import glob
import os
import re
import subprocess
import sys
import tempfile


class Counts:
    """What a file of callgrind says; of several processes, the first."""

    NAME = re.compile(r"(c?fn)=\((\d+)\)(?: (.*))?")

    def __init__(self, path):
        self.total, self.calls = 0, {}
        names, callee = {}, None
        with open(path, encoding="utf-8", errors="replace") as file:
            for line in file:
                if line.startswith("calls="):
                    self.calls[callee] = self.calls.get(callee, 0) + int(line[6:].split()[0])
                elif line.startswith(("summary:", "totals:")):
                    self.total = int(line.split()[1])
                else:
                    match = self.NAME.match(line)
                    if match:
                        if match[3]:
                            names[match[2]] = match[3]
                        if match[1] == "cfn":
                            callee = match[2]
        self.calls = {names[number]: n for number, n in self.calls.items()}

    def called(self, pattern):
        """Functions of deltaform and of MPI whose names (without parameters) match, and how often they were called."""
        result = {}
        for function, n in self.calls.items():
            name = re.sub(r"\(anonymous namespace\)::|\[abi:\w*\]", "", function).split("(")[0]
            own = function.startswith("deltaform::") and "{lambda" not in function
            if (own or re.match("P?MPI_", function)) and re.search(pattern, name):
                name = name.replace("deltaform::", "")
                result[name] = result.get(name, 0) + n
        return result


def callgrind(command, launcher=(), options=()):
    """Run a command under callgrind. One thread: what a second one does meanwhile is counted as well."""
    environment = dict(os.environ, OMP_NUM_THREADS="1", DEAL_II_NUM_THREADS="1")
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "callgrind.out")
        subprocess.run([*launcher, "valgrind", "--tool=callgrind", f"--callgrind-out-file={out}.%p", *options, *command],
                       check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=environment)
        return Counts(min(glob.glob(out + ".*")))


def exit_with(main):
    """The exit status is what main returns; a command that fails is said in a line."""
    try:
        sys.exit(main())
    except subprocess.CalledProcessError as error:
        sys.exit(f"{os.path.basename(sys.argv[0])}: {error}")
