"""A program under mpirun: what the scripts of this folder share."""
import argparse
import os
import subprocess


def parser_of(description):
    """PROGRAM SCENE FOLDER --launcher MPIRUN"""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("program")
    parser.add_argument("scene")
    parser.add_argument("folder")
    parser.add_argument("--launcher", required=True)
    return parser


def launch(arguments, processes, options, sets=(), **how):
    """The scene on so many processes, with options and entries ("Section/Entry=value"); how: of subprocess.run()."""
    command = [arguments.launcher, "-np", str(processes), "--oversubscribe", arguments.program, arguments.scene, *options]
    for entry in sets:
        command += ["--set", entry]
    environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    return subprocess.run(command, env=environment, text=True, **how)
