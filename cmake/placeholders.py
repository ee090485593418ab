#!/usr/bin/env python3
"""Placeholders for shared libraries that deal.II needs and deltaform does not: empty libraries of the same name, so that
the loader does not load and relocate the real ones.

  placeholders.py --root LIBDEAL_II --names REGEX --folder FOLDER --compiler C++ --nm NM --readelf READELF

Of the libraries that LIBDEAL_II asks for, those whose file name matches REGEX and that no other library asks for get a
placeholder in FOLDER. It defines the symbols that LIBDEAL_II takes from the real one and that nothing else defines: a
function says what it stands for and aborts, data are zeros. FOLDER/names.txt lists the placeholders.
"""
import argparse
import os
import re
import subprocess
import sys

SOURCE = """#include <cstdlib>
#include <unistd.h>

extern "C"
{{
  static void
  left_out()
  {{
    const char text[] = "deltaform: {library} is needed after all, but this build leaves it out; "
                        "cmake -DDELTAFORM_PLACEHOLDERS=OFF takes it in\\n";
    if (write(2, text, sizeof(text) - 1) >= 0)
      abort();
    abort();
  }}

{symbols}
}}
"""
FUNCTION = '  void {name}() __attribute__((alias("left_out")));'
DATA = "  alignas(32) char {name}[{size}] = {{}};"


def output_of(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


class Libraries:
    """Who asks for whom, and who defines what: all that the loader would look at."""

    def __init__(self, root, nm, readelf):
        self.nm, self.readelf, self.root = nm, readelf, root
        self.path = dict(re.findall(r"(\S+) => (/\S+)", output_of("ldd", root)))
        self.asks_for = {}
        asking = None
        # readelf names a file only where it is given several.
        for line in output_of(readelf, "-dW", root, *self.path.values()).splitlines():
            if line.startswith("File: "):
                asking = self.asks_for.setdefault(line[len("File: "):].strip(), [])
            elif "(NEEDED)" in line:
                asking.append(line[line.index("[") + 1:line.index("]")])

    def reached_without(self, left_out):
        """File names of the libraries that are still asked for when nobody asks for those left out, or only the root does."""
        reached, waiting = set(), [name for name in self.asks_for[self.root] if name not in left_out]
        while waiting:
            name = waiting.pop()
            if name in reached or name not in self.path:
                continue
            reached.add(name)
            waiting += self.asks_for[self.path[name]]
        return reached

    def to_leave_out(self, names):
        """(left out, kept): of the root's own libraries those that match. One that another library needs as well stays, and
        one of which the root wants symbols by version: the loader looks closer there."""
        versioned = set(re.findall(r"File: (\S+)", output_of(self.readelf, "-VW", self.root)))
        matching = [name for name in self.asks_for[self.root]
                    if names.fullmatch(name) and name in self.path and name not in versioned]
        while True:
            needed = self.reached_without(matching)
            if not needed.intersection(matching):
                return matching, needed
            matching = [name for name in matching if name not in needed]

    def symbols(self, path, *which):
        """name: (type, size in bytes) of the dynamic symbols; versions are cut off."""
        found = {}
        for line in output_of(self.nm, "-D", "-S", *which, path).splitlines():
            *numbers, kind, name = line.split()
            found[name.split("@")[0]] = (kind, int(numbers[1], 16) if len(numbers) > 1 else 0)
        return found


def source_of(library, wanted):
    lines = []
    for name, (kind, size) in sorted(wanted.items()):
        lines.append((FUNCTION if kind in "TtWi" else DATA).format(name=name, size=max(size, 1)))
    return SOURCE.format(library=library, symbols="\n".join(lines))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for option in ("root", "names", "folder", "compiler", "nm", "readelf"):
        parser.add_argument("--" + option, required=True)
    wish = parser.parse_args()

    libraries = Libraries(wish.root, wish.nm, wish.readelf)
    left_out, kept = libraries.to_leave_out(re.compile(wish.names))
    missing = {name for name, (kind, _) in libraries.symbols(wish.root, "--undefined-only").items() if kind == "U"}
    for name in kept:
        missing -= libraries.symbols(libraries.path[name], "--defined-only").keys()

    os.makedirs(wish.folder, exist_ok=True)
    for name in left_out:
        defined = libraries.symbols(libraries.path[name], "--defined-only")
        wanted = {symbol: defined[symbol] for symbol in missing & defined.keys()}
        missing -= wanted.keys()
        source = os.path.join(wish.folder, name + ".cc")
        with open(source, "w", encoding="utf-8") as file:
            file.write(source_of(name, wanted))
        # The names are those of other libraries' classes, of which this source knows nothing: no warnings, no built-ins.
        subprocess.run([wish.compiler, "-w", "-O1", "-fPIC", "-shared", "-fno-builtin", source, "-o",
                        os.path.join(wish.folder, name), "-Wl,-soname," + name], check=True)
    with open(os.path.join(wish.folder, "names.txt"), "w", encoding="utf-8") as file:
        file.writelines(name + "\n" for name in left_out)


if __name__ == "__main__":
    try:
        main()
    except (OSError, KeyError, subprocess.CalledProcessError) as error:
        print(error, getattr(error, "stderr", None) or "", file=sys.stderr)
        sys.exit(1)
