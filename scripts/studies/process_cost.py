#!/usr/bin/env python3
"""What a process costs: increments, cut-backs and Newton iterations of the shipped scenes with their own settings.

    scripts/studies/process_cost.py [--program PROGRAM] [--output output/process_cost] [--write]

Iterations count failed attempts as well; 'rejected' is their share. --write writes doc/measured/process_cost.csv. Three minutes.
"""
import json
import os
import subprocess

from measured import ROOT, MeasuredTable, arguments_of

TIGHT = "Contact/Allowed penetration=1e-7*thickness"
PROCESSES = (("cup", "cup", ()), ("cup, delta 1e-7 t", "cup", (TIGHT,)), ("stretching", "osu_stretching", ()),
             ("U-bend, 2.45 kN", "u_bend", ()), ("U-bend, 19.6 kN", "shop/u_bend_19600", ()),
             ("cup, solid", "cup_solid", ()), ("U-bend, solid, 2.45 kN", "u_bend_solid", ()),
             ("cup, drawn through", "shop/cup_drawn_through", ()), ("cup that tears", "shop/cup_tears", ()),
             ("first draw", "shop/redraw_1", ()), ("redrawing", "shop/redraw_2", ()), ("hydraulic bulge", "shop/hydraulic_bulge", ()),
             ("tube bulge", "shop/tube_bulge", ()), ("air bending", "shop/air_bending", ()), ("bottoming", "shop/v_bottoming", ()),
             ("wipe bending", "shop/wipe_bending", ()), ("hole flanging", "shop/hole_flanging", ()), ("flaring", "shop/flaring", ()),
             ("nosing", "shop/nosing", ()), ("upsetting, friction", "shop/upsetting_friction", ()),
             ("ring compression", "shop/ring_compression", ()), ("forward extrusion", "shop/forward_extrusion", ()),
             ("ironing", "shop/ironing", ()), ("coining", "shop/coining", ()), ("draw bead", "shop/draw_bead", ()),
             ("closed-die forging", "forging_flash", ()))


def run(options, scene, settings, suffix=""):
    """Of a process, with settings; redrawing goes on from the first draw that ran with the same @p suffix of its folder.

    @return exit status, folder, summary
    """
    folder = os.path.join(options.output, os.path.basename(scene) + ("_tight" if TIGHT in settings else "") + suffix)
    if scene == "shop/redraw_2":
        settings = (*settings, "Start from=" + os.path.join(options.output, "redraw_1" + suffix))
    command = [options.program, os.path.join(ROOT, "prm", scene + ".prm"), "--quiet", "--force", "--output", folder]
    command += [word for setting in settings for word in ("--set", setting)]
    status = subprocess.run(command, check=False).returncode  # 2 of a cup that tears is what is wanted
    with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
        return status, folder, json.load(file)


def main():
    options = arguments_of(__doc__, "process_cost").parse_args()
    table = MeasuredTable(["process", "scene", "exit status", "increments", "cut-backs", "iterations", "rejected [%]", "energy error"])
    for name, scene, settings in PROCESSES:
        status, _, summary = run(options, scene, settings)
        table.add(name, scene + ".prm", status, summary["increments"], summary["cutbacks"], summary["newton_iterations"],
                  f"{100 * summary['rejected_iterations'] / summary['newton_iterations']:.0f}", f"{summary['energy_error']:.1e}")
    print(table)
    if options.write:
        table.write("process_cost", "What a process costs: Newton iterations, with those of failed attempts")


if __name__ == "__main__":
    main()
