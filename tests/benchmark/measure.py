"""Processor and wall time of a process."""
import os
import resource
import subprocess
import time


class Measured:
    def __init__(self, good, processor, wall, note=""):
        self.good, self.processor, self.wall, self.note = good, processor, wall, note


def measure(command, folder, limit):
    """Run in a folder with one thread; given up after @p limit seconds of processor time."""
    environment = dict(os.environ, OMP_NUM_THREADS="1", CCX_NPROC_EQUATION_SOLVER="1", CCX_NPROC_STIFFNESS="1",
                       CCX_NPROC_RESULTS="1")
    seconds = int(limit) + 1
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    with open(os.path.join(folder, "screen.txt"), "w") as screen:
        run = subprocess.run(command, cwd=folder, stdout=screen, stderr=subprocess.STDOUT, env=environment, check=False,
                             preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds)))
    wall, after = time.perf_counter() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
    processor = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return Measured(run.returncode == 0, processor, wall, "given up" if run.returncode < 0 else "")
