"""Where the sheet is at the end of the stroke, by geometry alone."""
import math


def end_shape(plane, blank, radius, edge, profile, throat, stroke, hemisphere):
    """Angle of the wall, and where the rim is, of a sheet of thickness 1 that hugs punch and die and keeps its area (plane
    strain: its length). Between the roundings it is the inner tangent of two circles, the middle line's."""
    r1, r2 = (radius if hemisphere else edge) + .5, profile + .5
    x1, x2 = (0. if hemisphere else radius - edge), throat + profile
    dx, dz = x2 - x1, r1 + r2 - stroke
    distance = math.hypot(dx, dz)
    angle = math.atan2(dx, dz) - math.acos(min(1., (r1 + r2) / distance))
    wall = math.sqrt(max(0., distance ** 2 - (r1 + r2) ** 2))
    if plane:
        return angle, x2 + blank - (x1 + (r1 + r2) * angle + wall)
    # Areas over 2 pi: face, rounding of the punch, wall, rounding of the die.
    foot, head = x1 + r1 * math.sin(angle), x2 - r2 * math.sin(angle)
    area = x1 ** 2 / 2 + x1 * r1 * angle + (r1 ** 2 - r2 ** 2) * (1 - math.cos(angle)) + wall * (foot + head) / 2 + x2 * r2 * angle
    return angle, math.sqrt(max(0., x2 ** 2 + blank ** 2 - 2 * area))
