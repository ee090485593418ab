"""Draws forming scenes from a seed, and says of each before it runs whether it is physically sensible.

Lengths are in thicknesses, stresses in initial flow stresses, so that the ranges are those of the parameters that matter:
friction 0 to .6, t/R 1e-3 to .1, tool radii 2 t to 100 t, delta 1e-1 to 1e-9 t, 5 to 800 elements, E/sigma_y 50 to 1e4.
"""
import math
import random

from end_shape import end_shape

RULE = """A scene is called sensible if
  - no tool has a sharp corner, and an element turns by at most half a radian around the smallest tool radius
    (h <= (r + t/2)/2): a coarser mesh cannot follow the tool; and no element is shorter than a quarter of the thickness:
    a shell knows no such detail, and its contact forces alternate from node to node (Limits in the README);
  - delta lies between 1e-7 t (and 2e-10 of the blank's size) and 1e-2 t: below is round-off, which the program refuses, above
    the sheet is no longer where the tool is;
  - friction is at most .3, Poisson's ratio at most .49, E/sigma_y at least 100;
  - the smallest increment is at most 1e-4 of the stage;
  - the metal can take the shape: the strain it is asked for stays below the uniform strain, at which the force in the sheet
    passes its maximum (Considere: sigma' = sigma in tension; Swift 1952 allows more, so that this is on the safe side):
      stretching: ln of the length of the dome's arc over its chord, twice it in thickness; friction concentrates it by 1 + 2 mu;
      drawing: ratio of blank to punch radius at most 1 + .8 n/(n + .1) for the uniform strain n, less friction; tool radii >= 4 t;
               a holder by force presses with at most 2 % of the flow stress, by gap leaves at least 1.1 t;
      the rim, by constant area, stays on the flat of the die, and under a holder by force, which has nothing else to press on;
      on a strip with friction below .01 the wall stays below 80 degrees: a vertical one carries no punch, the strip falls through;
      a holder by force lets the flange slide: its friction on both faces and that around the die, 2 mu F exp(mu pi/2), is at
               most the initial flow stress times the thickness; else it tears the wall;
      and it holds the flange of a strip down: its moment about the die, force times half the flange, is at least that of
               the fully plastic sheet, sigma t^2/4, twice for hardening; else the flange lifts it and slips away under it;
      bending: t/(2 r) below the uniform strain, or any r >= 2 t without stretching (a free strip);
  - a linear elastic sheet is strained by less than .05, or its flow stress would be far exceeded in reality."""


# Clauses that were added when a failure had shown what the rule had forgotten; the page says how it looks without them.
AFTERWARDS = {"holder too weak to hold the flange down", "the rim leaves a holder by force", "the rim leaves the flat of the die",
              "a vertical wall without friction", "the holder tears the wall"}


def log_uniform(chance, a, b):
    return math.exp(chance.uniform(math.log(a), math.log(b)))


LAWS = ("linear elastic", "perfectly plastic", "linear", "ludwik", "swift", "voce", "hockett-sherby", "two-branch power", "table")


def draw_material(chance, tame):
    """Returns the section's text and what is known of it; the initial flow stress is 1."""
    law = chance.choice(LAWS)
    modulus = log_uniform(chance, 100 if tame else 50, 1e4)
    poisson = chance.choice((.3, .3, chance.uniform(0, .45), .49, .49 if tame else .4999))
    n = chance.uniform(.05, .5)
    lines = [f"set Young's modulus = {modulus:.6g}", f"set Poisson's ratio = {poisson:.6g}"]
    if law == "linear elastic":
        return ["set Model = linear elastic"] + lines, dict(law=law, modulus=modulus, poisson=poisson, uniform=.05)
    entries = {
        "perfectly plastic": ["Flow stress = 1"],
        "linear": ["Initial flow stress = 1", f"Hardening modulus = {3 * n:.6g}"],
        "ludwik": ["Initial flow stress = 1", "Strength coefficient = 2.5", f"Hardening exponent = {n:.6g}"],
        "swift": [f"Strength coefficient = {2e-3 ** -n:.8g}", "Prestrain = 2e-3", f"Hardening exponent = {n:.6g}"],
        "voce": ["Initial flow stress = 1", f"Saturation stress = {1 + 3 * n:.6g}", "Saturation rate = 10"],
        "hockett-sherby": ["Initial flow stress = 1", f"Saturation stress = {1 + 4 * n:.6g}", "Saturation rate = 5",
                           "Hardening exponent = 0.75"],
        "two-branch power": ["Initial flow stress = 1", "First coefficient = 5.15", "First exponent = 0.504",
                             "Second coefficient = 4.52", "Second exponent = 0.375"],
        "table": ["Flow curve = 0 1; 0.02 1.31; 0.05 1.5; 0.1 1.7; 0.2 1.9; 0.5 2.2; 1 2.45"],
    }[law]
    # Uniform strain: where the slope falls to the stress (plus the elastic strain, which is small).
    curves = {
        "perfectly plastic": lambda e: 1.,
        "linear": lambda e: 1 + 3 * n * e,
        "ludwik": lambda e: 1 + 2.5 * e ** n,
        "swift": lambda e: ((2e-3 + e) / 2e-3) ** n,
        "voce": lambda e: 1 + 3 * n * (1 - math.exp(-10 * e)),
        "hockett-sherby": lambda e: 1 + 4 * n * (1 - math.exp(-5 * e ** .75)),
        "two-branch power": lambda e: 1 + min(5.15 * e ** .504, 4.52 * e ** .375),
        "table": lambda e: 1 + 1.45 * e ** .33,
    }
    flow, uniform = curves[law], 0.
    for k in range(1, 100):
        e = .005 * k
        if (flow(e + 1e-4) - flow(e)) / 1e-4 < flow(e):
            break
        uniform = e
    return (["set Model = elastoplastic"] + lines + ["subsection Hardening", f"  set Law = {law}"] +
            ["  set " + entry for entry in entries] + ["end"]), dict(law=law, modulus=modulus, poisson=poisson, uniform=uniform)


def section(name, lines):
    return [f"subsection {name}"] + ["  " + line for line in lines] + ["end"]


def draw(seed):
    """Returns the text of scene number @p seed and its tags: kind, features, sensible, why not."""
    chance = random.Random(seed)
    kind = ("drawing", "stretching", "bending")[seed % 3]
    features, against = [], []
    slenderness = log_uniform(chance, 1e-3, .1)
    radius = 1 / slenderness  # of the punch, in thicknesses
    # Half of the scenes are drawn from what a forming shop does, so that enough are sensible; the rest from everything.
    tame = chance.random() < .55
    friction = chance.choice((0., chance.uniform(0, .2), chance.uniform(0, .3 if tame else .6)))
    delta = log_uniform(chance, 1e-7, 1e-2) if tame else log_uniform(chance, 1e-9, 1e-1)
    elements = round(log_uniform(chance, 5, 800))
    material, known = draw_material(chance, tame)
    sharp = not tame and chance.random() < .2
    edge = 0. if sharp else min(log_uniform(chance, 2, 100), .45 * radius)
    profile = 0. if sharp and chance.random() < .5 else min(log_uniform(chance, 2, 100), .45 * radius)
    hemisphere = kind != "bending" and chance.random() < .5
    if sharp:
        features.append("corner")
        against.append("a sharp corner")
    clearance = chance.uniform(1.1, 2.5)
    throat = radius + clearance
    plane = kind == "bending" or chance.random() < .15

    if tame:
        edge, profile = max(edge, 4.), max(profile, 4.)
    ratio = chance.uniform(1.2, 1.6 if tame else 2.2) if kind == "drawing" else 0.
    if kind == "drawing":
        blank = max(ratio * radius, throat + profile + 5)
        ratio = blank / radius
        stroke = chance.uniform(.1, .9) * radius
    elif kind == "stretching":
        blank = throat + profile + 2
        stroke = chance.uniform(.05, .25 if tame else .6) * radius
    else:
        blank = throat + profile + chance.uniform(1, 3) * radius
        stroke = chance.uniform(.2, .8) * min(blank - throat, 2 * radius)
    if kind == "drawing" and chance.random() < .15:
        features.append("rim leaves holder")
        stroke = 1.3 * (blank - throat) + profile
    if not hemisphere and edge > 0 and chance.random() < .2:
        # A node of a uniform mesh lies exactly under the joint of the punch's face and its rounded edge.
        features.append("node on joint")
        flat = radius - edge
        k = max(1, round(elements * flat / blank))
        elements = max(5, math.ceil(blank * k / flat))
        blank = flat * elements / k
    graded = chance.random() < .3 and "node on joint" not in features
    if tame:
        longest = .5 * (min(profile, radius if hemisphere else edge) + .5)
        needed = math.ceil(blank / longest * (2.5 if graded else 1))
        if elements < needed <= 800 and "node on joint" not in features:
            elements = needed
    elements = min(elements, 800)
    if graded:
        features.append("graded")

    holder = chance.choice(("none", "force", "gap")) if kind != "stretching" else "none"
    inner = throat if chance.random() < .5 else throat + profile
    if holder == "gap":
        gap = chance.uniform(1.02, 1.3)
    width = 1. if plane else 2 * math.pi * .5 * (inner + blank)
    pressure = log_uniform(chance, 1e-4, .03)
    reversal = chance.random() < .15
    whole = chance.random() < .15
    smallest = chance.choice((1e-7, 1e-7, 1e-5, 1e-5 if tame else 1e-3))

    # The rule, see RULE.
    h = blank / elements * (2.5 if graded else 1.)
    smallest_radius = min(profile, radius if hemisphere else edge)
    if h > .5 * (smallest_radius + .5):
        against.append("elements too long for the smallest tool radius")
    if blank / elements * (.4 if graded else 1.) < .25:
        against.append("elements shorter than t/4")
    if not max(1e-7, 2e-10 * blank) <= delta <= 1e-2:
        against.append("delta out of range")
    if friction > .3:
        against.append("friction above .3")
    if known["poisson"] > .49:
        against.append("nearly incompressible")
    if known["modulus"] < 100:
        against.append("E/sigma_y below 100")
    if smallest > 1e-4:
        against.append("smallest increment above 1e-4")
    elastic = known["law"] == "linear elastic"
    bent = .5 / (smallest_radius + .5)
    angle, rim = end_shape(plane, blank, radius, edge, profile, throat, stroke, hemisphere)
    force = pressure * width * max(blank - inner, 1)
    if kind != "stretching":
        if rim < throat + profile:
            against.append("the rim leaves the flat of the die")
        if holder == "force" and rim < inner:
            against.append("the rim leaves a holder by force")
        if plane and friction < .01 and angle > math.radians(80):
            against.append("a vertical wall without friction")
        pull = 2 * friction * force / (1. if plane else 2 * math.pi * throat) * math.exp(friction * math.pi / 2)
        if holder == "force" and pull > 1:
            against.append("the holder tears the wall")
    if kind == "stretching":
        half = math.atan2(stroke, throat)
        strain = 2 * math.log(2 * half / math.sin(2 * half)) * (1 + 2 * friction)
        if strain + (bent if elastic else 0) > known["uniform"]:
            against.append("stretched beyond the uniform strain")
    elif kind == "drawing":
        n = known["uniform"]
        if elastic:
            against.append("elastic sheet strained by more than .05")
        elif ratio > 1 + .8 * n / (n + .1) - friction:
            against.append("drawing ratio too large")
        if smallest_radius < 4:
            against.append("tool radius below 4 t")
        if holder == "force" and pressure > .02:
            against.append("holder presses too hard")
        if holder == "gap" and gap < 1.1:
            against.append("holder leaves less than 1.1 t")
    elif holder == "force" and pressure * (blank - inner) ** 2 / 2 < .5:
        against.append("holder too weak to hold the flange down")
    elif elastic and bent > .05:
        against.append("elastic sheet strained by more than .05")
    elif holder != "none" and bent > known["uniform"]:
        against.append("bent beyond the uniform strain")

    for name, condition in (("reversal", reversal), ("whole stroke at once", whole), ("holder by " + holder, holder != "none"),
                            ("plane strain", plane), ("perfectly plastic", known["law"] == "perfectly plastic"),
                            ("nearly incompressible", known["poisson"] > .485)):
        if condition:
            features.append(name)

    motion = f"{stroke:.8g}*t"
    if reversal:
        motion = f"0: 0, 0.5: {.6 * stroke:.8g}, 0.6: {.3 * stroke:.8g}, 1: {stroke:.8g}"
    punch = (["set Shape = hemispherical punch", f"set Radius = {radius:.8g}"] if hemisphere else
             ["set Shape = flat punch", f"set Radius = {radius:.8g}", f"set Edge radius = {edge:.8g}"])
    rub = f"set Friction coefficient = {friction:.6g}"
    tools = [section("punch", punch + ["set Side = top", "set Position z = thickness/2", f"set Motion = {motion}", rub]),
             section("die", ["set Shape = die", f"set Throat radius = {throat:.8g}", f"set Profile radius = {profile:.8g}",
                             "set Side = bottom", "set Position z = -thickness/2", rub])]
    names = "punch, die"
    if holder != "none":
        names += ", holder"
        plate = ["set Shape = plate", f"set Inner radius = {inner:.8g}", "set Side = top", rub]
        if holder == "gap":
            plate += [f"set Position z = -thickness/2 + {gap:.6g}*thickness", "set Contact thickness = initial"]
        else:
            plate += ["set Position z = thickness/2", f"set Force = {force:.6g}"]
        tools.append(section("holder", plate))
    supports = []
    if plane:
        supports += [section("symmetry r", ["set Boundary = start", "set Component = r"]),
                     section("symmetry rotation", ["set Boundary = start", "set Component = rotation"])]
    if kind == "stretching":
        supports += [section("rim " + c, ["set Boundary = end", "set Component = " + c]) for c in ("r", "z", "rotation")]
    text = [f"# stress scene {seed}: {kind}; {', '.join(features) or 'plain'}; " +
            ("sensible" if not against else "not sensible: " + "; ".join(against)),
            f"set Title = stress scene {seed}, {kind}"]
    text += section("Blank", ["set Symmetry = " + ("plane strain" if plane else "axisymmetric"), "set Thickness = 1",
                              f"set Points = 0 0; {blank:.12g} 0", f"set Elements = {elements}",
                              f"set Degree = {1 if chance.random() < .8 else 2}"] +
                    (["set Grading = 0: 1, 0.5: 0.4, 1: 1"] if graded else []))
    text += section("Material", material)
    text += section("Tools", ["set Names = " + names] + [line for tool in tools for line in tool])
    if supports:
        text += section("Supports", ["set Names = " + ", ".join(s[0][len("subsection "):] for s in supports)] +
                        [line for s in supports for line in s])
    text += section("Contact", [f"set Allowed penetration = {delta:.6g}*thickness"])
    text += section("Steps", ["set Stages = form"] +
                    section("form", ["set End time = 1", f"set Smallest increment = {smallest:g}"] +
                            (["set First increment = 1", "set Largest increment = 1"] if whole else [])))
    if set(against) - AFTERWARDS:
        # It has to end well, no more: within bounded time.
        text += section("Solver", ["set Maximal increments = 400"])
    text += section("Output", ["set Pictures = 2"])
    return "\n".join(text) + "\n", dict(seed=seed, kind=kind, features=features, law=known["law"], sensible=not against,
                                        against=against)
