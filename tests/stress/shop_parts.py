"""Parts of processes of a press shop that are drawn at random, such that an engineer expects an answer: sheets as shells, bulk as solids.

Sheets are in mm, N, MPa with four metals and thicknesses of .5 to 3; bulk has lengths of about 10 and an initial flow stress of 1.
Elements are those that the pages recommend: at most 14 degrees on the smallest radius of a sheet, half a radius in bulk.
"""
import math
import random

from draw import log_uniform, section

METALS = (("206e3", "swift", ("Strength coefficient = 565.32", "Prestrain = 0.007117", "Hardening exponent = 0.2589")),
          ("70e3", "voce", ("Initial flow stress = 130", "Saturation stress = 330", "Saturation rate = 12")),
          ("200e3", "swift", ("Strength coefficient = 1500", "Prestrain = 0.02", "Hardening exponent = 0.5")),
          ("210e3", "swift", ("Strength coefficient = 1100", "Prestrain = 0.003", "Hardening exponent = 0.14")))


def sets(**entries):
    """Lines 'set Name = value'; numbers with twelve digits."""
    return [f"set {name.replace('_', ' ')} = {value:.12g}" if isinstance(value, float) else f"set {name.replace('_', ' ')} = {value}"
            for name, value in entries.items()]


def points(*pairs):
    return "; ".join(f"{a:.12g} {b:.12g}" for a, b in pairs)


class Scene:
    """The parts of a scene, and its text."""

    def __init__(self, chance, blank, plane):
        self.chance, self.plane, self.blank = chance, plane, dict(blank)
        self.friction = chance.choice((.02, chance.uniform(0, .1), chance.uniform(.05, .2)))
        self.tools, self.supports, self.loads, self.stages, self.output, self.material = {}, {}, {}, [], [], []

    def tool(self, name, side, **entries):
        stages = {"Stages": self.stages[0][0]} if len(self.stages) > 1 else {}
        self.tools[name] = sets(Side=side, **entries, Friction_coefficient=self.friction, **stages)

    def hold(self, name, boundary, component, **entries):
        self.supports[name] = sets(Boundary=boundary, Component=component, **entries)

    def clamp(self, boundary, *components):
        for component in components:
            self.hold(f"{boundary} {component}", boundary, component)

    def release(self, begin):
        """A last stage without tools, held at the start."""
        self.hold("floor", "start", "z", Hold="true", Stages="release")
        self.stages.append(("release", begin + 1, {}))

    def text(self, title):
        symmetry = "plane strain" if self.plane else "axisymmetric"
        lines = [f"set Title = {title}"] + section("Blank", sets(Symmetry=symmetry, **self.blank)) + section("Material", self.material)
        for name, parts in (("Tools", self.tools), ("Supports", self.supports), ("Loads", self.loads)):
            if parts:
                lines += section(name, ["set Names = " + ", ".join(parts)] + [line for part in parts for line in section(part, parts[part])])
        lines += section("Steps", ["set Stages = " + ", ".join(name for name, _, _ in self.stages)] +
                         [line for name, end, more in self.stages for line in section(name, sets(End_time=float(end), **more))])
        return "\n".join(lines + section("Output", ["set Pictures = 2"] + self.output)) + "\n"


def sheet(chance, length_and_radius, plane, thickness, start=0., layers=(7, 9, 11)):
    """A flat shell of a length, with elements for its smallest radius."""
    length, radius = length_and_radius
    element = max(.25 * thickness, min(.25 * (radius + .5 * thickness), 1.5 * thickness))
    return Scene(chance, dict(Thickness=thickness, Points=points((start, 0), (start + length, 0)),
                              Elements=min(600, math.ceil(length / element)), Layers=chance.choice(layers)), plane)


def of_metal(scene):
    modulus, law, entries = scene.chance.choice(METALS)
    scene.material = sets(**{"Young's_modulus": modulus, "Poisson's_ratio": .3}) + section(
        "Hardening", [f"set Law = {law}"] + ["set " + entry for entry in entries])


def measure(scene, kind, **entries):
    scene.output += section("Measures", ["set Names = part"] + section("part", sets(Kind=kind, **entries)))


def mirror(scene):
    scene.clamp("start", "r", "rotation")


def bulk(chance, width, height, n, plane=None, inner=0., top="top, end", bottom="bottom"):
    """A block of a width and a height on z = 0; n elements across."""
    plane = chance.random() < .3 if plane is None else plane
    scene = Scene(chance, dict(Kind="solid", Degree=chance.choice((1, 1, 2)), Points_lie_on_the="bottom", Thickness=height,
                               Points=points((inner, 0), (inner + width, 0)), Elements=round(n), Contact_top=top, Contact_bottom=bottom,
                               Elements_through_thickness=max(6, round(n * height / width))), plane)
    law = chance.choice(("perfectly plastic", "linear", "ludwik", "voce"))
    hardening = chance.uniform(.05, .4)
    scene.material = sets(**{"Young's_modulus": log_uniform(chance, 150, 1500), "Poisson's_ratio": .3}) + section("Hardening", [
        f"set Law = {law}"] + {"perfectly plastic": ["set Flow stress = 1"],
                              "linear": sets(Initial_flow_stress=1, Hardening_modulus=3 * hardening),
                              "ludwik": sets(Initial_flow_stress=1, Strength_coefficient=2, Hardening_exponent=hardening + .1),
                              "voce": sets(Initial_flow_stress=1, Saturation_stress=1 + 3 * hardening, Saturation_rate=8)}[law])
    if plane and not inner:
        scene.clamp("start", "r")
    return scene
