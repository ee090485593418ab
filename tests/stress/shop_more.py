"""Thirteen more processes of a press shop, drawn at random."""
import math

from shop_first import air_bending
from shop_parts import Scene, bulk, measure, mirror, of_metal, points, sheet


def bottoming(chance):
    """A V that is closed until the sheet fills the gap of its thickness: a solid, as a shell would be squeezed."""
    t = round(chance.uniform(.5, 3), 3)
    half = math.radians(chance.uniform(40, 60))  # of the included angle
    nose, leg, edge = chance.uniform(1.5, 5) * t, chance.uniform(12, 25) * t, 3 * t
    depth, width = leg * math.cos(half), leg * math.sin(half)
    length = 1.05 * (leg + 6 * t)
    scene = Scene(chance, dict(Kind="solid", Degree=2, Points=points((0, 0), (length, 0)), Thickness=t, Elements=math.ceil(2 * length / t),
                               Elements_through_thickness=2), True)
    travel = depth + t - t / math.sin(half)
    scene.stages = [("bend", 1.2 * travel, {"Ends_when": f"punch_to_die_gap < {1.02 * t:.6g}", "Largest_increment": .01 * travel})]
    scene.release(1.2 * travel)
    scene.tool("punch", "top", Shape="profile", Fillet_radii=f"0, {nose:.12g}, 0", Position_z=.5 * t - nose * (1 / math.sin(half) - 1),
               Points=points((3 * width, 3 * depth), (0, 0), (-3 * width, 3 * depth)), Across_the_axis="false", Motion="t")
    scene.tool("die", "bottom", Shape="profile", Fillet_radii=f"0, {edge:.12g}, {nose + t:.12g}, {edge:.12g}, 0", Across_the_axis="false",
               Points=points((-3 * width, 0), (-width, 0), (0, -depth), (width, 0), (3 * width, 0)), Position_z=-.5 * t)
    scene.clamp("start", "r")
    of_metal(scene)
    measure(scene, "angle", Second_leg=f"{.4 * leg:.6g} {.8 * leg:.6g}")
    return scene


def draw_bead(chance):
    t = round(chance.uniform(.5, 2), 3)
    radius = chance.uniform(4, 9) * t
    pitch = (2 * radius + t) * chance.uniform(1.02, 1.4)
    close, pull = chance.uniform(.5, 1.2) * radius, chance.uniform(20, 40) * t
    back = pitch + pull + 12 * t
    scene = sheet(chance, (back + pitch + 10 * t, radius), True, t, -back, (9, 11, 15))
    scene.blank["Elements"] = math.ceil(2 * (back + pitch + 10 * t) / t)  # as the page has it: half a thickness
    scene.stages = [("form", 2, {})]
    for name, place in (("entry", -pitch), ("exit", pitch)):
        scene.tool(name, "bottom", Shape="circle", Radius=radius, Position_r=place, Position_z=-.5 * t - radius)
    scene.tool("bead", "top", Shape="circle", Radius=radius, Position_r=0., Position_z=.5 * t + radius, Motion=f"0: 0, 1: {close:.12g}, 2: {close:.12g}")
    scene.hold("pull", "end", "r", Value=f"0: 0, 1: 0, 2: {pull:.12g}")
    scene.hold("level", "end", "z")
    scene.hold("guide", "start", "z")
    return scene


def clamped(chance, deep):
    """A clamped sheet under a ball, and its size."""
    t = round(chance.uniform(.5, 3), 3)
    radius, profile = chance.uniform(20, 60) * t, chance.uniform(4, 10) * t
    throat, depth = radius * chance.uniform(1.05, 1.2) + 2 * t, chance.uniform(*deep) * radius
    scene = sheet(chance, (throat + profile + 2 * t, profile), chance.random() < .3, t)
    scene.tool("punch", "top", Shape="hemispherical punch", Radius=radius, Position_z=.5 * t, Motion=f"0: 0, {depth:.12g}: {depth:.12g}, {2 * depth:.12g}: 0")
    scene.tool("die", "bottom", Shape="die", Throat_radius=throat, Profile_radius=profile, Position_z=-.5 * t)
    scene.clamp("end", "r", "z", "rotation")
    if scene.plane:
        mirror(scene)
    scene.stages = [("form", depth, {})]
    return scene, t, radius, throat, profile, depth


def stretching(chance):
    return clamped(chance, (.25, .45))[0]


def reverse_stretching(chance):
    """Stretched by a ball, and pressed back flat by a second one from below."""
    scene, t, radius, throat, profile, depth = clamped(chance, (.15, .3))
    back = .75 * depth
    scene.tool("second", "bottom", Shape="hemispherical punch", Radius=.8 * radius, Direction="0 1", Position_z=-.5 * t - depth,
               Motion=f"{depth:.12g}: 0, {2 * depth:.12g}: {back:.12g}")
    scene.tool("cover", "top", Shape="die", Throat_radius=throat, Profile_radius=profile, Position_z=.5 * t)
    scene.stages.append(("back", 2 * depth, {}))
    return scene


def cup_under_gap(chance):
    t = round(chance.uniform(.5, 3), 3)
    radius, edge, profile = chance.uniform(15, 50) * t, chance.uniform(4, 9) * t, chance.uniform(4, 9) * t
    throat = radius + chance.uniform(1.2, 1.6) * t
    rim = max(chance.uniform(1.4, 1.8) * radius, throat + profile + 6 * t)
    stroke = chance.uniform(.3, .7) * (rim - throat)
    scene = sheet(chance, (rim, min(edge, profile)), False, t)
    scene.stages = [("form", stroke, {})]
    scene.release(stroke)
    scene.tool("punch", "top", Shape="flat punch", Radius=radius, Edge_radius=edge, Position_z=.5 * t, Motion="t")
    scene.tool("die", "bottom", Shape="die", Throat_radius=throat, Profile_radius=profile, Position_z=-.5 * t)
    scene.tool("holder", "top", Shape="plate", Inner_radius=throat + profile * chance.choice((0, 1)),
               Position_z=(chance.uniform(1.01, 1.2) - .5) * t)
    return scene


def joggling(chance):
    """A step pressed into a strip by two dies that fit."""
    t = round(chance.uniform(.5, 3), 3)
    radius, step, slope = chance.uniform(2, 5) * t, chance.uniform(1, 4) * t, math.radians(chance.uniform(30, 60))
    run, flat = step / math.tan(slope), chance.uniform(8, 14) * t
    reach = (radius + t) * math.tan(.5 * slope)
    run = max(run, 2.2 * reach * math.cos(slope))
    gap = chance.uniform(1.05, 1.3) * t
    scene = sheet(chance, (2 * flat + run, radius), True, t, -flat, (9, 11, 15))
    scene.stages = [("press", step, {})]
    scene.release(step)
    scene.tool("lower", "bottom", Shape="profile", Fillet_radii=f"0, {radius:.12g}, {radius:.12g}, 0", Position_z=-.5 * t, Across_the_axis="false",
               Points=points((-3 * flat, 0), (0, 0), (run, -step), (run + 3 * flat, -step)))
    shift = gap * math.tan(.5 * slope)  # the gap is the same along the slope
    scene.tool("upper", "top", Shape="profile", Fillet_radii=f"0, {radius:.12g}, {radius:.12g}, 0", Position_z=.5 * t + step, Motion="t",
               Across_the_axis="false", Points=points((run + 3 * flat, gap - t - step), (run + shift, gap - t - step), (shift, gap - t), (-3 * flat, gap - t)))
    scene.hold("end r", "start", "r", Hold="true")
    scene.hold("end rotation", "start", "rotation", Hold="true", Stages="release")
    return scene


def curling(chance):
    """The edge of a sheet runs into a groove and rolls up."""
    t = round(chance.uniform(.5, 2), 3)
    radius, free = chance.uniform(5, 10) * t, chance.uniform(4, 8) * t
    stroke = chance.uniform(1, 2.6) * radius
    scene = sheet(chance, (stroke + free, radius), True, t, layers=(9, 11, 15))
    scene.blank.update(Points=points((0, 0), (0, stroke + free)), Contact_point="outer fibre")  # a square edge
    scene.friction = min(scene.friction, .1)
    scene.stages = [("curl", stroke, {})]
    scene.tool("groove", "bottom", Shape="profile", Fillet_radii=f"0, {.999 * radius:.12g}, {.999 * radius:.12g}, 0", Across_the_axis="false", Position_z=0.,
               Points=points((.5 * t - 2 * radius, .3 * radius), (.5 * t - 2 * radius, -radius), (.5 * t, -radius), (.5 * t, 9 * radius)))
    scene.hold("ram", "end", "z", Value="-t")
    scene.clamp("end", "r", "rotation")
    return scene


def tube_flanging(chance):
    """The end of a tube is turned outwards by a shoulder."""
    t = round(chance.uniform(.5, 3), 3)
    inner, radius = chance.uniform(12, 40) * t, chance.uniform(4, 9) * t
    stroke, length = chance.uniform(.8, 1.8) * radius + 2 * t, 1.5 * inner
    scene = sheet(chance, (length, radius), False, t)
    middle = inner + chance.uniform(.51, .6) * t
    scene.blank.update(Points=points((middle, 0), (middle, length)), Grading="1.5-1.2*t")
    scene.stages = [("flange", stroke, {})]
    scene.tool("shoulder", "top", Shape="profile", Fillet_radii=f"0, {radius:.12g}, 0", Direction="0 -1", Motion="t", Position_z=length + radius,
               Points=points((5 * inner, 0), (inner, 0), (inner, -3 * inner)))
    scene.clamp("start", "z", "rotation")
    return scene


def tube_sinking(chance):
    """A pointed tube is drawn through a cone."""
    t = round(chance.uniform(.5, 3), 3)
    outer, angle = chance.uniform(12, 35) * t, math.radians(chance.uniform(8, 20))
    small, fillet = outer * chance.uniform(.75, .92), 10 * t
    cone = (outer - small) / math.tan(angle)
    body, nose = 1.2 * outer, .8 * outer
    scene = sheet(chance, (body + cone + nose, 10 * t), False, t)
    middle = outer - .5 * t
    scene.blank.update(Points=points((middle, 0), (middle, body), (small - .6 * t, body + cone), (small - .6 * t, body + cone + nose)),
                       Fillet_radii=f"0, {fillet:.12g}, {fillet:.12g}, 0", Elements=math.ceil((body + cone + nose) / (.25 * math.sqrt(outer * t))))
    scene.stages = [("draw", 1, {})]
    scene.tool("die", "bottom", Shape="profile", Fillet_radii=f"0, {fillet:.12g}, {fillet:.12g}, 0", Position_z=body + .4 * t,
               Points=points((outer, -2 * body), (outer, 0), (small, cone), (small, cone + 9 * nose)))
    scene.hold("pull", "end", "z", Value=f"{chance.uniform(.3, .6) * body:.12g}*t")
    scene.clamp("end", "rotation")
    return scene


def washer_flattening(chance):
    t = round(chance.uniform(.5, 3), 3)
    outer = chance.uniform(15, 50) * t
    inner, rise = outer * chance.uniform(.4, .7), chance.uniform(1, 4) * t
    scene = sheet(chance, (outer - inner, 6 * t), False, t)
    scene.blank.update(Points=points((inner, rise), (outer, 0)), Contact_point="outer fibre")  # square edges
    scene.stages = [("press", rise, {})]
    for name, side, place in (("plate", "top", rise + .5 * t), ("base", "bottom", -.5 * t)):
        scene.tool(name, side, Shape="plate", Position_z=place, **({"Motion": f"{chance.uniform(.5, .95):.12g}*t"} if side == "top" else {}))
    return scene


def ironing(chance):
    t = round(chance.uniform(.5, 3), 3)
    radius, reduction, angle = chance.uniform(10, 40) * t, chance.uniform(.08, .3), math.radians(chance.uniform(6, 18))
    length, inner = chance.uniform(8, 14) * t, radius + (1 - reduction) * t
    scene = Scene(chance, dict(Kind="solid", Degree=2, Points=points((radius + .51 * t, 0), (radius + .51 * t, length)), Thickness=t,
                               Elements=math.ceil(10 * length / t), Elements_through_thickness=3), False)
    scene.friction = min(scene.friction, .08)
    scene.stages = [("iron", .7 * length, {"Largest_increment": .2 * t})]
    scene.tool("punch", "top", Shape="profile", Points=points((radius, 60 * t), (radius, -60 * t)), Position_z=0., Motion="t")
    scene.tool("ring", "bottom", Shape="profile", Fillet_radii=f"0, {t:.12g}, {t:.12g}, 0", Position_z=-(reduction + .05) * t / math.tan(angle),
               Points=points((inner + .8 * t, -5.4 * t), (inner, -.4 * t), (inner, 0), (inner + 1.4 * t, 1.4 * t / math.tan(angle))))
    scene.hold("bottom", "start", "z", Value="-t")
    of_metal(scene)
    return scene


def solid_bending(chance):
    scene = air_bending(chance)
    scene.blank.update(Kind="solid", Degree=2, Elements_through_thickness=2)
    del scene.blank["Layers"], scene.supports["start rotation"]
    of_metal(scene)
    return scene


def bar_bending(chance):
    """A thick bar on two rolls, bent by a third."""
    height, span = 10, chance.uniform(25, 60)
    roll, nose = chance.uniform(4, 10), chance.uniform(4, 10)
    scene = bulk(chance, span + 20, height, 4 * (span + 20) / height, plane=True)
    scene.blank["Elements_through_thickness"] = 4 if scene.blank["Degree"] == 2 else 8
    scene.blank["Elements"] *= 1 if scene.blank["Degree"] == 2 else 2
    scene.stages = [("bend", chance.uniform(.15, .4) * span, {})]
    scene.tool("punch", "top", Shape="circle", Radius=nose, Position_z=height + nose + 1e-6, Motion="t")
    scene.tool("roll", "bottom", Shape="circle", Radius=roll, Position_r=span, Position_z=-roll)
    return scene


SHEETS = (draw_bead, stretching, reverse_stretching, cup_under_gap, joggling, curling, tube_flanging, tube_sinking, washer_flattening)
BULK = (bottoming, ironing, solid_bending, bar_bending)
