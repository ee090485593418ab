#!/usr/bin/env python3
"""Libraries that deal.II needs and deltaform does not are left out, and only those.

  placeholders.py small   SCRIPT FOLDER COMPILER NM READELF    the script, on libraries made for it
  placeholders.py program PROGRAM PLACEHOLDERS                 the program that was built with them
"""
import ctypes
import os
import re
import shutil
import signal
import subprocess
import sys

MESSAGE = "is needed after all"


def expect(condition, what):
    if not condition:
        sys.exit(f"failed: {what}")


def run(*command, **more):
    return subprocess.run(command, capture_output=True, text=True, timeout=120, **more)


def call(path, function):
    """What happens to a process that calls a function of a library."""
    return run(sys.executable, "-c", f"import ctypes; ctypes.CDLL({path!r}).{function}()")


def expect_message(path, function):
    outcome = call(path, function)
    expect(outcome.returncode == -signal.SIGABRT, f"{function} of {path} ended with {outcome.returncode}, not by abort")
    expect(f"{os.path.basename(path)} {MESSAGE}" in outcome.stderr, f"{function} of {path} said: {outcome.stderr}")


# file name: (its source, libraries that it asks for). The root wants `draw`, `scale` and `unit` of libunneeded, which also has a
# `solve` of its own; `solve` of libkept; `mesh` of libshared, which libkept asks for as well; `store` of libversioned, by version.
LIBRARIES = {
    "libdeep.so.1": ("int deep() { return 1; }", []),
    "libunneeded.so.1": ("int deep(); int draw() { return deep(); } double scale[3] = {1, 2, 3}; int unit = 5;"
                         "int not_wanted() { return 1; } __attribute__((weak)) int solve() { return 1; }", ["libdeep.so.1"]),
    "libshared.so.1": ("int mesh() { return 7; }", []),
    "libversioned.so.1": ("int store() { return 9; }", []),
    "libkept.so.1": ("int mesh(); int solve() { return mesh() + 35; }", ["libshared.so.1"]),
    "libroot.so.1": ("int draw(), solve(), mesh(), store(); extern double scale[3]; extern int unit;"
                     "int works() { return solve() + mesh() + store(); } int draws() { return draw(); }"
                     "double *scales() { return scale; } int *units() { return &unit; }",
                     ["libunneeded.so.1", "libkept.so.1", "libshared.so.1", "libversioned.so.1"]),
}


def make_small(folder, compiler):
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    version_script = os.path.join(folder, "versions")
    with open(version_script, "w", encoding="utf-8") as file:
        file.write("VERSION_1 { global: store; };\n")
    for name, (source, needs) in LIBRARIES.items():
        path = os.path.join(folder, name)
        with open(path + ".cc", "w", encoding="utf-8") as file:
            file.write(f'extern "C" {{ {source} }}\n')
        more = ["-Wl,--version-script=" + version_script] if "versioned" in name else []
        subprocess.run([compiler, "-w", "-fPIC", "-shared", path + ".cc", "-o", path, "-Wl,--no-as-needed", "-Wl,-soname," + name,
                        "-Wl,-rpath," + folder] + more + [os.path.join(folder, need) for need in needs], check=True)


def small(script, folder, compiler, nm, readelf):
    make_small(folder, compiler)
    root, made = os.path.join(folder, "libroot.so.1"), os.path.join(folder, "placeholders")
    arguments = ["--root", root, "--names", "lib(unneeded|shared|versioned|deep|absent)[.]so.*", "--folder", made,
                 "--compiler", compiler, "--nm", nm, "--readelf", readelf]
    outcome = run(sys.executable, script, *arguments)
    expect(outcome.returncode == 0, outcome.stderr)
    with open(os.path.join(made, "names.txt"), encoding="utf-8") as file:
        names = file.read().split()
    # libshared is needed by libkept, libversioned by version, libdeep only by what is left out.
    expect(names == ["libunneeded.so.1"], f"left out: {names}")

    placeholder = os.path.join(made, "libunneeded.so.1")
    defined = run(nm, "-D", "--defined-only", placeholder).stdout
    expect(sorted(re.findall(r" \w (\w+)", defined)) == ["draw", "scale", "unit"], f"the placeholder defines:\n{defined}")

    ctypes.CDLL(placeholder, mode=ctypes.RTLD_GLOBAL)
    library = ctypes.CDLL(root, mode=os.RTLD_NOW)
    library.scales.restype = ctypes.POINTER(ctypes.c_double)
    library.units.restype = ctypes.POINTER(ctypes.c_int)
    expect(library.works() == 42 + 7 + 9, "what is kept does not work")
    expect([library.scales()[i] for i in range(3)] == [0, 0, 0] and library.units()[0] == 0, "data are not zeros")
    with open("/proc/self/maps", encoding="utf-8") as maps:
        expect("libdeep" not in maps.read(), "libdeep is loaded")
    expect_message(placeholder, "draw")

    outcome = run(sys.executable, script, *[root + "_none" if value == root else value for value in arguments])
    expect(outcome.returncode == 1 and "_none" in outcome.stderr, "a library that does not exist is no error")


def program(path, placeholders):
    # With every address resolved at once, one that is missing shows here and not in the middle of a run.
    outcome = run(path, "--version", env={**os.environ, "LD_BIND_NOW": "1"})
    expect(outcome.returncode == 0, f"with LD_BIND_NOW: {outcome.stderr}")

    with open(os.path.join(placeholders, "names.txt"), encoding="utf-8") as file:
        names = file.read().split()
    expect(names, "no placeholders")
    loaded = dict(re.findall(r"(\S+) => (/\S+)", run("ldd", path).stdout))
    for name in names:
        expect(loaded.get(name) == os.path.join(placeholders, name), f"{name} is loaded from {loaded.get(name)}")
        functions = re.findall(r" T (\w+)", run("nm", "-D", "--defined-only", loaded[name]).stdout)
        if functions:
            expect_message(loaded[name], functions[0])


if __name__ == "__main__":
    {"small": small, "program": program}[sys.argv[1]](*sys.argv[2:])
