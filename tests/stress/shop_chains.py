"""Parts that a press shop makes in several operations, drawn at random: each a list of scenes, of which every one begins with the blank
that the one before has left."""
import math

from draw import log_uniform
from shop_parts import Scene, bulk, measure, mirror, of_metal, points, sheet


def next_of(scene, *stages):
    """The next operation on the blank of a scene."""
    result = Scene(scene.chance, scene.blank, scene.plane)
    result.material, result.friction, result.output, result.stages = scene.material, scene.friction, list(scene.output), list(stages)
    return result


def cut(scene, begin, end):
    """A blank that loses so much of its length at its begin and its end."""
    (a, z), (b, _) = (tuple(map(float, point.split())) for point in scene.blank["Points"].split(";"))
    scene.blank.update(Elements=max(4, math.ceil(scene.blank["Elements"] * (b - a - begin - end) / (b - a))), Points=points((a + begin, z), (b - end, z)))


def cup(chance, overhang=None):
    """A cup with a flange, released, and its sizes; the flange ends so many thicknesses beyond the radius of the die."""
    t = round(chance.uniform(.5, 3), 3)
    radius, edge, profile = chance.uniform(15, 40) * t, chance.uniform(4, 7) * t, chance.uniform(4, 7) * t
    throat, stroke = radius + chance.uniform(1.2, 1.6) * t, chance.uniform(.25, .5) * radius
    rim = throat + profile + chance.uniform(10, 16) * t if overhang is None else math.sqrt((throat + profile + overhang * t) ** 2 + 1.4 * throat * stroke)
    scene = sheet(chance, (rim, min(edge, profile)), False, t)
    of_metal(scene)
    scene.stages = [("form", stroke, {})]
    scene.release(stroke)
    scene.tool("punch", "top", Shape="flat punch", Radius=radius, Edge_radius=edge, Position_z=.5 * t, Motion="t")
    scene.tool("die", "bottom", Shape="die", Throat_radius=throat, Profile_radius=profile, Position_z=-.5 * t)
    scene.tool("holder", "top", Shape="plate", Inner_radius=throat + profile, Position_z=.5 * t,
               Force=chance.uniform(.6, 2) * math.pi * (rim ** 2 - throat ** 2))
    return scene, t, radius, edge, profile, throat, stroke


def redrawing(chance):
    first, t, radius, edge, _, _, stroke = cup(chance)
    small, travel = min(chance.uniform(.7, .8) * radius, radius - edge - 8 * t), chance.uniform(.1, .25) * radius
    second = next_of(first, ("redraw", travel, {}))
    second.release(travel)
    second.tool("die", "bottom", Shape="die", Throat_radius=small + 1.4 * t, Profile_radius=chance.uniform(4, 8) * t, Position_z=-stroke - .8 * t)
    second.tool("punch", "top", Shape="flat punch", Radius=small, Edge_radius=min(chance.uniform(4, 8) * t, .45 * small), Motion="t",
                Position_z=-stroke + .8 * t)
    second.tool("sleeve", "top", Shape="plate", Inner_radius=small + 2 * t, Outer_radius=radius - edge, Edge_radius=t, Position_z=-stroke + .8 * t,
                Force=chance.uniform(.5, 1.5) * math.pi * (radius ** 2 - small ** 2))
    return [first, second]


def trimmed_flange(chance):
    """The flange of a cup is trimmed, springs back, and is turned down around the outside of a block."""
    overhang, bend = chance.uniform(18, 24), chance.uniform(3, 5)
    first, t, _, _, profile, throat, stroke = cup(chance, overhang)
    trimmed = next_of(first, ("relax", 1, {}))
    cut(trimmed, 0, chance.uniform(3, 5) * t)
    trimmed.hold("floor", "start", "z", Hold="true")
    radius, block = bend * t, throat + profile + (bend + chance.uniform(3, 5)) * t
    gap, travel = block + chance.uniform(1.1, 1.3) * t, chance.uniform(4, 8) * t
    turned = next_of(trimmed, ("turn", travel, {}))
    turned.release(travel)
    turned.tool("block", "bottom", Shape="profile", Position_z=-1.5 * t, Fillet_radii=f"0, {profile:.12g}, {radius:.12g}, 0",
                Points=points((throat, -9 * stroke), (throat, 0), (block, 0), (block, -9 * stroke)))
    turned.tool("pad", "top", Shape="plate", Inner_radius=throat + profile, Outer_radius=block - radius, Edge_radius=.5 * t, Position_z=.8 * t,
                Force=1000 * t * throat)
    turned.tool("ring", "top", Shape="profile", Points=points((9 * gap, 0), (gap, 0), (gap, 9 * gap)), Fillet_radii=f"0, {3 * t:.12g}, 0",
                Position_z=.8 * t, Motion="t")
    return [first, trimmed, turned]


def pierced_bottom(chance):
    """A hole in the bottom of a cup is widened by a ball."""
    first, t, radius, edge, _, _, stroke = cup(chance)
    # What the bottom leaves for the ball, the radius of the die and a pad.
    ball, profile = min(chance.uniform(.3, .5) * radius, radius - edge - 8 * t), 3 * t
    hole, throat = ball / chance.uniform(1.3, 1.6), ball + 1.4 * t
    second = next_of(first, ("flange", chance.uniform(.6, 1.) * ball, {}))
    cut(second, hole, 0)
    second.blank["Elements"] = math.ceil(1.3 * second.blank["Elements"])
    second.tool("die", "bottom", Shape="die", Throat_radius=throat, Profile_radius=profile, Position_z=-stroke - .6 * t)
    second.tool("punch", "top", Shape="hemispherical punch", Radius=ball, Motion="t",
                Position_z=-stroke + .6 * t + .8 * t - ball + math.sqrt(ball ** 2 - hole ** 2))
    second.tool("pad", "top", Shape="plate", Inner_radius=throat, Outer_radius=radius - edge, Edge_radius=t, Position_z=-stroke + .6 * t,
                Force=200 * t * radius)
    return [first, second]


def bent_twice(chance):
    """Bent in air, released, and bent on by a sharper punch in a die that stands lower."""
    t = round(chance.uniform(.5, 3), 3)
    nose, throat, profile = chance.uniform(2, 4) * t, chance.uniform(6, 12) * t, chance.uniform(2, 4) * t
    little, much = chance.uniform(.2, .4) * throat, chance.uniform(.5, .7) * throat
    first = sheet(chance, (throat + profile + 6 * t + .4 * much, min(.8 * nose, profile)), True, t, layers=(9, 11, 15))
    of_metal(first)
    first.stages = [("bend", little, {})]
    measure(first, "angle", First_leg=f"0 {3 * t:.6g}", Second_leg=f"{.5 * throat:.6g} {.9 * throat:.6g}")
    second = next_of(first, ("again", much, {}))
    for scene, travel, radius, lower, from_here in ((first, little, nose, 0., 0.), (second, much, .8 * nose, .3 * little, little)):
        scene.release(travel)
        scene.tool("punch", "top", Shape="circle", Radius=radius, Position_z=radius + .5 * t - from_here, Motion="t")
        scene.tool("die", "bottom", Shape="die", Throat_radius=throat, Profile_radius=profile, Position_z=-.5 * t - lower)
        mirror(scene)
    return [first, second]


def flattened_flare(chance):
    t = round(chance.uniform(.5, 2), 3)
    radius, angle = chance.uniform(12, 30) * t, math.radians(chance.uniform(15, 25))
    length, slope, sag = 2.2 * radius, math.tan(angle), chance.uniform(.15, .3) * radius
    first = sheet(chance, (length, 10 * t), False, t)
    of_metal(first)
    first.blank.update(Points=points((radius, 0), (radius, length)), Elements=math.ceil(length / (.2 * math.sqrt(radius * t))))
    first.stages = [("form", chance.uniform(.4, .6) * radius, {})]
    first.tool("punch", "top", Shape="profile", Fillet_radii=f"0, {2 * t:.12g}, 0", Direction="0 -1", Motion="t",
               Points=points((1.6 * radius, .6 * radius / slope), (.8 * radius, -.2 * radius / slope), (.4 * radius, -.2 * radius / slope)),
               Position_z=length + .6 * t / math.sin(angle) + .5)
    first.clamp("start", "z", "rotation")
    second = next_of(first, ("flatten", sag + t, {}))
    second.tool("plate", "top", Shape="plate", Position_z=length + t, Motion="t")
    second.clamp("start", "z", "rotation")
    return [first, second]


def upset_and_indented(chance):
    """A billet is pressed flat and released; a ball is pressed into it, on a finer mesh."""
    width = log_uniform(chance, 6, 14)
    height = log_uniform(chance, .6, 1.2) * width
    first = bulk(chance, width, height, chance.uniform(10, 13), False)
    pressed, ball = chance.uniform(.15, .35) * height, chance.uniform(.4, .7) * width
    first.stages = [("press", 1, {}), ("release", 2, {})]
    first.hold("middle", "bottom", "z")
    first.tool("punch", "top", Shape="plate", Position_z=height + 1e-6, Motion=f"{pressed:.12g}*t")
    second = next_of(first, ("indent", 1, {}))
    for name in ("Elements", "Elements_through_thickness"):
        second.blank[name] = math.ceil(1.3 * second.blank[name])
    second.hold("middle", "bottom", "z")
    second.tool("punch", "top", Shape="circle", Radius=ball, Position_z=1.02 * height - pressed + ball,
                Motion=f"{.02 * height + chance.uniform(.15, .4) * ball:.12g}*t")
    return [first, second]


CHAINS = (redrawing, trimmed_flange, pierced_bottom, bent_twice, flattened_flare, upset_and_indented)
