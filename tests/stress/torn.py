"""Whether a sheet has failed where a run stopped, judged without the program: from its flow curve and the files of the run.

Considere: the force in a bar passes its maximum at the uniform strain, where sigma' = sigma. Swift (1952): in equibiaxial
tension of a power law the force passes its maximum at twice that strain in thickness, later than in any other tension.
A sheet that is thinner still, by more than bending makes it, tears. So does one whose punch is carried by a wall that can
carry no more.
"""
import math

BENDING = .1          # what bending and unbending over a radius of four thicknesses thin a sheet by, with some to spare
PLANE_STRAIN = 2 / math.sqrt(3)
NEARLY = .97          # of what the wall can carry


def flow_curve(hardening):
    """sigma(eps) of a section Hardening as a function; None of a law that is not known here."""
    number = {name: float(value) for name, value in hardening.items() if _is_number(value)}
    law = hardening.get("Law")
    if law == "perfectly plastic":
        return lambda e: number["Flow stress"]
    if law == "linear":
        return lambda e: number["Initial flow stress"] + number["Hardening modulus"] * e
    if law == "ludwik":
        return lambda e: number["Initial flow stress"] + number["Strength coefficient"] * e ** number["Hardening exponent"]
    if law == "swift":
        return lambda e: number["Strength coefficient"] * (number["Prestrain"] + e) ** number["Hardening exponent"]
    if law in ("voce", "hockett-sherby"):
        n = number["Hardening exponent"] if law == "hockett-sherby" else 1.
        return lambda e: number["Saturation stress"] - (number["Saturation stress"] - number["Initial flow stress"]) * math.exp(
            -number["Saturation rate"] * e ** n)
    if law == "two-branch power":
        return lambda e: number["Initial flow stress"] + min(number["First coefficient"] * e ** number["First exponent"],
                                                             number["Second coefficient"] * e ** number["Second exponent"])
    if law == "table":
        points = [tuple(map(float, pair.split())) for pair in hardening["Flow curve"].split(";")]
        return lambda e: _interpolated(points, e)
    return None


def _is_number(text):
    try:
        float(text)
    except ValueError:
        return False
    return True


def _interpolated(points, e):
    for (a, s), (b, t) in zip(points, points[1:]):
        if e <= b:
            return s + (t - s) * (e - a) / (b - a)
    return points[-1][1]


def tension(curve):
    """Uniform strain, and the largest force in a bar over its first section."""
    strains = [1e-3 * k for k in range(2001)]
    uniform = max(strains, key=lambda e: curve(e) * math.exp(-e))
    return uniform, curve(uniform) * math.exp(-uniform)


def why(run):
    """How the sheet of a run has failed by its last increment, in words; empty if nothing shows it.

    @param run a Run of run_files: a scene with a sheet, and a punch of a radius
    """
    hardening = run.scene["Material"].get("Hardening")
    curve = flow_curve(hardening) if hardening else None
    if curve is None or not len(run.history):
        return ""
    thickness = float(run.scene["Blank"]["Thickness"])
    uniform, strength = tension(curve)
    thinned = math.log(thickness / min(run.history.column("min_thickness")))
    if thinned > 2 * uniform + BENDING:
        return f"thinned by {thinned:.2f}, with a uniform strain of {uniform:.2f}"
    punch = run.scene["Tools"]["punch"]
    section = thickness * (1. if run.scene["Blank"]["Symmetry"] == "plane strain" else 2 * math.pi * float(punch["Radius"]))
    force, most = max(map(abs, run.history.column("punch_force_z"))), PLANE_STRAIN * strength * section
    if force > NEARLY * most:
        return f"the punch presses with {force:.4g}, a wall carries at most {most:.4g}"
    return ""
