"""Fifteen processes of a press shop, drawn at random."""
import math

from draw import log_uniform
from shop_parts import bulk, measure, mirror, points, sets, sheet


def air_bending(chance):
    t = round(chance.uniform(.5, 3), 3)
    nose, throat, profile = chance.uniform(1, 4) * t, chance.uniform(5, 15) * t, chance.uniform(1.5, 4) * t
    stroke = chance.uniform(.2, .7) * throat
    scene = sheet(chance, (throat + profile + 6 * t + .4 * stroke, min(nose, profile)), True, t, layers=(9, 11, 15))
    scene.stages = [("bend", stroke, {})]
    scene.release(stroke)
    scene.tool("punch", "top", Shape="circle", Radius=nose, Position_z=nose + .5 * t, Motion="t")
    scene.tool("die", "bottom", Shape="die", Throat_radius=throat, Profile_radius=profile, Position_z=-.5 * t)
    mirror(scene)
    measure(scene, "angle", First_leg=f"0 {3 * t:.6g}", Second_leg=f"{.5 * throat:.6g} {.9 * throat:.6g}")
    return scene


def wipe_bending(chance):
    t = round(chance.uniform(.5, 3), 3)
    radius, gap, held = chance.uniform(1, 4) * t, chance.uniform(1.05, 1.3) * t, 15 * t
    stroke = chance.uniform(5, 12) * t + radius
    scene = sheet(chance, (held + stroke + radius + 2 * t, radius), True, t, -held, (9, 11, 15))
    scene.stages = [("bend", stroke, {})]
    scene.release(stroke)
    del scene.supports["floor"]
    scene.tool("die", "bottom", Shape="profile", Points="-100 0; 0 0; 0 -100", Fillet_radii=f"0, {radius:.12g}, 0",
               Across_the_axis="false", Position_z=-.5 * t)
    scene.tool("pad", "top", Shape="plate", Inner_radius=-100., Outer_radius=-radius, Edge_radius=.5 * t, Position_z=.5 * t,
               Force=1200 * t * t / radius)
    scene.tool("punch", "top", Shape="profile", Points=f"100 0; {gap:.12g} 0; {gap:.12g} 100",
               Fillet_radii=f"0, {chance.uniform(1.5, 4) * t:.12g}, 0", Across_the_axis="false", Position_z=.5 * t, Motion="t")
    scene.hold("end r", "start", "r", Hold="true")
    for component in ("z", "rotation"):
        scene.hold("end " + component, "start", component, Hold="true", Stages="release")
    measure(scene, "angle", First_leg=f"0 {.7 * held:.6g}", Second_leg=f"{held + 2.2 * radius + t:.6g} {held + 2.2 * radius + 3 * t:.6g}")
    return scene


def hole_flanging(chance):
    t = round(chance.uniform(.5, 3), 3)
    hole = chance.uniform(10, 30) * t
    radius, profile = hole * chance.uniform(1.15, 1.6), chance.uniform(3, 8) * t
    throat = radius + chance.uniform(1.1, 1.5) * t
    scene = sheet(chance, (throat + profile + 10 * t - hole, profile), False, t, hole)
    scene.stages = [("flange", chance.uniform(.5, 1.2) * radius, {})]
    if chance.random() < .6:
        scene.tool("punch", "top", Shape="hemispherical punch", Radius=radius, Motion="t",
                   Position_z=.8 * t + .5 * t - radius + math.sqrt(radius ** 2 - hole ** 2))
    else:
        scene.tool("punch", "top", Shape="flat punch", Radius=radius, Edge_radius=min(chance.uniform(4, 8) * t, .45 * radius),
                   Position_z=.5 * t, Motion="t")
    scene.tool("die", "bottom", Shape="die", Throat_radius=throat, Profile_radius=profile, Position_z=-.5 * t)
    scene.clamp("end", "r", "z", "rotation")
    return scene


def tube(chance, flared):
    t = round(chance.uniform(.5, 3), 3)
    radius, angle = chance.uniform(12, 40) * t, math.radians(chance.uniform(8, 25))
    length, slope = 2.2 * radius, math.tan(angle)
    scene = sheet(chance, (length, 10 * t), False, t)
    scene.blank.update(Points=points((radius, 0), (radius, length)), Elements=math.ceil(length / (.3 * math.sqrt(radius * t))))
    scene.stages = [("form", chance.uniform(.4, .8) * radius + (0 if flared else 4 * t / slope), {})]
    if flared:
        scene.tool("punch", "top", Shape="profile", Fillet_radii=f"0, {2 * t:.12g}, 0", Direction="0 -1", Motion="t",
                   Points=points((1.6 * radius, .6 * radius / slope), (.8 * radius, -.2 * radius / slope), (.4 * radius, -.2 * radius / slope)),
                   Position_z=length + .6 * t / math.sin(angle) + .5)
    else:
        scene.tool("punch", "bottom", Shape="profile", Fillet_radii=f"0, {12 * t:.12g}, 0", Direction="0 -1", Position_z=length, Motion="t",
                   Points=points((radius + 4.5 * t, -10 * t), (radius + 4.5 * t, 0), (.4 * radius, (.6 * radius + 4.5 * t) / slope)))
    scene.clamp("start", "z", "rotation")
    return scene


def flaring(chance):
    return tube(chance, True)


def nosing(chance):
    return tube(chance, False)


def bulging(chance):
    t = round(chance.uniform(.5, 3), 3)
    throat, profile = chance.uniform(20, 60) * t, chance.uniform(4, 10) * t
    scene = sheet(chance, (throat + profile + 2 * t, profile), False, t)
    scene.stages = [("bulge", 1, {})]
    scene.tool("die", "top", Shape="die", Throat_radius=throat, Profile_radius=profile, Position_z=.5 * t)
    scene.clamp("end", "r", "z", "rotation")
    height = chance.uniform(.25, .45) * throat
    volume = math.pi * height * (3 * throat ** 2 + height ** 2) / 6
    scene.loads["oil"] = sets(Kind="pressure", Face="bottom", Control="volume", Value=f"{volume:.12g}*t")
    return scene


def tube_bulging(chance):
    t = round(chance.uniform(.5, 3), 3)
    radius = chance.uniform(10, 30) * t
    length = radius * chance.uniform(1.5, 3)
    scene = sheet(chance, (length, 10 * t), False, t)
    scene.blank.update(Points=points((radius, 0), (radius, length)), Elements=math.ceil(length / (.25 * math.sqrt(radius * t))))
    scene.stages = [("blow", 1, {})]
    scene.clamp("start", "z", "rotation")
    scene.clamp("end", "r", "rotation")
    scene.hold("feed", "end", "z", Value=f"{-.1 * chance.random() * length:.12g}*t")
    scene.loads["oil"] = sets(Kind="pressure", Control="volume", Value=f"{-math.pi * radius ** 2 * length * chance.uniform(.1, .35):.12g}*t")
    return scene


def u_bending(chance):
    t = round(chance.uniform(.5, 3), 3)
    edge, radius, stroke = chance.uniform(4, 9) * t, chance.uniform(15, 40) * t, chance.uniform(20, 60) * t
    throat = radius + chance.uniform(1.1, 1.6) * t
    scene = sheet(chance, (throat + edge + stroke + 15 * t, edge), True, t, layers=(9, 11, 15))
    scene.stages = [("form", stroke, {})]
    scene.release(stroke)
    scene.tool("punch", "top", Shape="flat punch", Radius=radius, Edge_radius=edge, Position_z=.5 * t, Motion="t")
    scene.tool("die", "bottom", Shape="die", Throat_radius=throat, Profile_radius=edge, Position_z=-.5 * t)
    scene.tool("holder", "top", Shape="plate", Inner_radius=throat + edge, Edge_radius=t, Position_z=.5 * t, Force=log_uniform(chance, 3, 600) * t)
    mirror(scene)
    measure(scene, "u-bend", Margin=edge + 5 * t, Leg=6 * t)
    return scene


def cup_drawing(chance):
    t = round(chance.uniform(.5, 3), 3)
    radius, edge, profile = chance.uniform(15, 50) * t, chance.uniform(4, 9) * t, chance.uniform(4, 9) * t
    throat = radius + chance.uniform(1.2, 1.6) * t
    rim = max(chance.uniform(1.4, 1.85) * radius, throat + profile + 6 * t)
    through = chance.random() < .5
    stroke = 1.3 * (rim - throat) + profile + 3 * t if through else chance.uniform(.4, .7) * (rim - throat)
    scene = sheet(chance, (rim, min(edge, profile)), False, t)
    scene.stages = [("form", stroke, {"Ends_when": "die_touching < 1"} if through else {})]
    scene.release(stroke)
    scene.tool("punch", "top", Shape="flat punch", Radius=radius, Edge_radius=edge, Position_z=.5 * t, Motion="t")
    scene.tool("die", "bottom", Shape="die", Throat_radius=throat, Profile_radius=profile, Position_z=-.5 * t)
    scene.tool("holder", "top", Shape="plate", Inner_radius=throat + profile * chance.choice((0, 1)), Position_z=.5 * t,
               Force=chance.uniform(.6, 3) * math.pi * (rim ** 2 - throat ** 2))
    return scene


def stand(scene):
    """On its middle plane, or on a base."""
    if scene.chance.random() < .6:
        scene.hold("middle", "bottom", "z")
    else:
        scene.tool("base", "bottom", Shape="plate", Position_z=-1e-6)


def between_plates(scene, height):
    scene.stages = [("press", 1, {})]
    stand(scene)
    scene.tool("punch", "top", Shape="plate", Position_z=height + 1e-6, Motion=f"{scene.chance.uniform(.2, .6) * height:.12g}*t")
    return scene


def upsetting(chance):
    width = log_uniform(chance, 4, 20)
    height = log_uniform(chance, .4, 1.5) * width
    scene = bulk(chance, width, height, chance.uniform(10, 20))
    return between_plates(scene, height)


def ring_compression(chance):
    width = chance.uniform(4, 10)
    height = log_uniform(chance, .4, 1.5) * width
    scene = bulk(chance, width, height, chance.uniform(10, 20), False, chance.uniform(4, 10), "start, top, end")
    return between_plates(scene, height)


def forging(chance):
    radius = chance.uniform(8, 14)
    height, boss = chance.uniform(.8, 1.4) * radius, chance.uniform(.3, .6) * radius
    depth = chance.uniform(.2, .6) * boss
    fillet = chance.uniform(.2, .35) * depth
    scene = bulk(chance, radius, height, max(12, 1.5 * radius / fillet))
    scene.blank["Degree"] = 1
    scene.stages = [("press", 1, {})]
    scene.hold("middle", "bottom", "z")
    scene.tool("punch", "top", Shape="profile", Fillet_radii=f"0, {fillet:.12g}, {fillet:.12g}, 0", Position_z=height + 1e-6,
               Points=points((3 * radius, 0), (boss + .2 * depth, 0), (boss, depth), (0, depth)),
               Motion=f"{chance.uniform(.2, .4) * height + .5 * depth:.12g}*t")
    return scene


def extrusion(chance):
    height, reduction, angle = chance.uniform(15, 30), chance.uniform(.1, .5), math.radians(chance.uniform(10, 35))
    scene = bulk(chance, 9.99, height, chance.uniform(10, 15), bottom="bottom, end")
    scene.friction = min(scene.friction, .08)
    scene.stages = [("press", 1, {"First_increment": .002, "Largest_increment": .02})]
    throat = 10 * (1 - reduction if scene.plane else math.sqrt(1 - reduction))
    length = (10 - throat) / math.tan(angle)
    fillet = min(chance.uniform(2, 5), .4 * length / math.cos(angle) / math.tan(.5 * angle))
    # A long land would grip the bar.
    scene.tool("container", "bottom", Shape="profile", Fillet_radii=f"0, 0.5, 0.5, {fillet:.12g}, {fillet:.12g}, 0",
               Points=points((throat + .4, -80), (throat + .4, -length - 3), (throat, -length - 2), (throat, -length), (10, 0), (10, 100)),
               Position_z=-fillet * math.tan(.5 * angle) - .05)
    scene.hold("ram", "top", "z", Value=f"-{chance.uniform(.3, .6) * height:.12g}*t")
    return scene


def indentation(chance):
    radius = chance.uniform(3, 10)
    scene = bulk(chance, 20, 10, chance.uniform(24, 40))
    scene.blank.update(Grading="t+0.2", Grading_through_thickness="1.2-t")
    scene.stages = [("press", 1, {})]
    stand(scene)
    scene.tool("punch", "top", Shape="circle", Radius=radius, Position_z=10 + radius + 1e-6, Motion=f"{chance.uniform(.1, .4) * radius:.12g}*t")
    return scene


def coining(chance):
    height = chance.uniform(1.5, 4)
    relief = chance.uniform(.1, .25) * height
    fillet = chance.uniform(.8, 1.5) * relief
    scene = bulk(chance, 10, height, 15 / fillet)
    scene.blank["Degree"] = 1
    scene.stages = [("press", 1, {})]
    scene.hold("middle", "bottom", "z")
    scene.tool("punch", "top", Shape="profile", Fillet_radii=f"0, {fillet:.12g}, {fillet:.12g}, 0", Position_z=height + 1e-6,
               Points=points((16, 0), (6, 0), (6 - relief, relief), (0, relief)), Motion=f"{chance.uniform(.1, .25) * height + relief:.12g}*t")
    return scene


SHEETS = (air_bending, wipe_bending, hole_flanging, flaring, nosing, bulging, tube_bulging, u_bending, cup_drawing)
BULK = (upsetting, ring_compression, forging, extrusion, indentation, coining)
