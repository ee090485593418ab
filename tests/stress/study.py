"""What the studies of random scenes share: their options, and results that are logged as they come."""
import argparse
import concurrent.futures
import json
import pathlib


def options(description, count):
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--count", type=int, default=count)
    parser.add_argument("--seconds", type=float, default=90.)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--again", type=pathlib.Path, nargs="*")
    parser.add_argument("--write", action="store_true")
    return parser


def results_of(arguments, run, log_name):
    """Of run(program, folder, seed, seconds) for every seed, without None; or those of the files of --again."""
    arguments.folder.mkdir(parents=True, exist_ok=True)
    if arguments.again:
        return [json.loads(line) for file in arguments.again for line in file.read_text().splitlines()]
    results = []
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool, open(arguments.folder / log_name, "w", encoding="utf-8") as log:
        seeds = getattr(arguments, "seeds", None) or range(arguments.first, arguments.first + arguments.count)
        for result in pool.map(lambda seed: run(arguments.program, arguments.folder, seed, arguments.seconds), seeds):
            if result:
                results.append(result)
                log.write(json.dumps(result) + "\n")
                log.flush()
    return results
