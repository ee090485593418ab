#!/usr/bin/env python3
"""Prints the reference numbers of the shell scenes that are no row of a table: from closed forms, and from ordinary
differential equations that know nothing of deltaform. Standard library only.

    python3 tests/scenes/reference_values.py
"""
import cmath
import math

TWO_BRANCH = lambda e: 5.4 + min(27.8 * e**0.504, 24.4 * e**0.375)
SWIFT = lambda e: 589. * (1e-4 + e)**0.216
SWIFT_SLOPE = lambda e: 589. * .216 * (1e-4 + e)**(.216 - 1)

# Springback of the strip t = 1, E = 210e3, nu = .3, s = 200 bent to R = 50, as printed by main(): the second takes minutes.
SPRINGBACK_GARDINER, SPRINGBACK_FIBRES = 58.7965493, 58.79363


def bisect(function, low, high):
    """The root of a rising function."""
    for _ in range(200):
        middle = .5 * (low + high)
        if function(middle) < 0:
            low = middle
        else:
            high = middle
    return .5 * (low + high)


def rk4(rate, y, start, end, steps):
    """Runge-Kutta of order four."""
    h, t = (end - start) / steps, start
    for _ in range(steps):
        k1 = rate(t, y)
        k2 = rate(t + h / 2, [a + h / 2 * b for a, b in zip(y, k1)])
        k3 = rate(t + h / 2, [a + h / 2 * b for a, b in zip(y, k2)])
        k4 = rate(t + h, [a + h * b for a, b in zip(y, k3)])
        y = [a + h / 6 * (b + 2 * c + 2 * d + e) for a, b, c, d, e in zip(y, k1, k2, k3, k4)]
        t += h
    return y


def equibiaxial_stretch(law, young, poisson, strain):
    """Equal logarithmic strains in the plane: tau = s(e), strain = (1-nu) tau / E + e / 2. Stress, strain, thickness."""
    e = bisect(lambda x: (1 - poisson) * law(x) / young + x / 2 - strain, 0., 4 * strain)
    return law(e), e, math.exp(-2 * poisson * law(e) / young - e)


def uniaxial_stretch(law, young, poisson, strain):
    """Free to contract: tau = s(e), strain = tau / E + e. Stress, e, thickness over the initial one."""
    e = bisect(lambda x: law(x) / young + x - strain, 0., 2 * strain)
    return law(e), e, math.exp(-poisson * law(e) / young - e / 2)


def plane_strain_stretch(law, slope, young, poisson, strain, steps=4000):
    """J2 flow in plane stress with no strain across: the rate equations over the plastic strain, from first yield on.
    Stress along, e, thickness over the initial one, stress across."""
    first = law(0.) / math.sqrt(1 - poisson + poisson**2)

    def rate(e, y):
        """Of the stresses and of the logarithmic strain along."""
        s1, s2, _ = y
        s = law(e)
        n1, n2 = (2 * s1 - s2) / (2 * s), (2 * s2 - s1) / (2 * s)
        # 0 = (ds2 - nu ds1) / E + n2 de and n1 ds1 + n2 ds2 = slope de
        ds1 = (slope(e) + young * n2 * n2) / (n1 + poisson * n2)
        ds2 = poisson * ds1 - young * n2
        return [ds1, ds2, (ds1 - poisson * ds2) / young + n1]

    def state(end):
        # e = end x^4 puts most steps where the stress ratio turns.
        return rk4(lambda x, y: [4 * end * x**3 * v for v in rate(end * x**4, y)],
                   [first, poisson * first, first * (1 - poisson**2) / young], 0., 1., steps)

    low, high = .8 * strain, 1.2 * strain
    while high - low > 1e-12:
        middle = .5 * (low + high)
        if state(middle)[2] < strain:
            low = middle
        else:
            high = middle
    s1, s2, _ = state(low)
    return s1, low, math.exp((1 - 2 * poisson) * (s1 + s2) / young - strain), s2


def plane_strain_swift():
    return plane_strain_stretch(SWIFT, SWIFT_SLOPE, 69004., .3, .8)


def cylinder_edge(radius, thickness, young, poisson, moment, shear, place=0., factor=5. / 6.):
    """A half-infinite cylinder with a moment and a radial force per length on its edge: radial displacement at the edge
    of a thin shell (Kirchhoff); at a place, of the shell with shear deformation whose hoop strain is w / (R + zeta)."""
    stiffness = young * thickness**3 / (12 * (1 - poisson**2))
    b = (3 * (1 - poisson**2))**.25 / math.sqrt(radius * thickness)
    thin = moment / (2 * b * b * stiffness) + shear / (2 * b**3 * stiffness)
    # Energy per unit of length and angle, exact over the thickness, zeta outwards, u eliminated by N_x = 0:
    #   strain along u' + zeta psi', across w / (R + zeta), volume element R + zeta, shear angle w' + psi
    plane = young / (1 - poisson**2)
    a11 = plane * radius * thickness          # u' u'
    a12 = plane * thickness**3 / 12           # u' psi'
    a22 = plane * radius * thickness**3 / 12  # psi' psi'
    c1 = plane * poisson * thickness          # u' w
    hoop = plane * math.log((radius + thickness / 2) / (radius - thickness / 2))  # w w
    k = factor * young / (2 * (1 + poisson)) * thickness * radius
    # u' = -(a12 psi' + c1 w) / a11; what is left: A psi'^2 + 2 B psi' w + C w^2 + k (w' + psi)^2
    A, B, C = a22 - a12**2 / a11, -a12 * c1 / a11, hoop - c1**2 / a11
    # w: B psi' + C w - k (w'' + psi') = 0; psi: k (w' + psi) - A psi'' - B w' = 0. With exp(-m x):
    #   (C - k m^2) w + (k - B) m psi = 0,  (B - k) m w + (k - A m^2) psi = 0
    # A k m^4 - (A C + k^2 - (k - B)^2) m^2 + C k = 0
    p = A * C + k * k - (k - B)**2
    root = complex(p * p - 4 * A * k * C * k)**.5
    roots = []
    for square in ((p + root) / (2 * A * k), (p - root) / (2 * A * k)):
        m = square**.5
        roots.append(m if m.real > 0 else -m)
    ratio = [(C - k * m * m) / ((B - k) * m) for m in roots]  # psi / w
    # At x = 0, outward normal -x, a moment doing work on psi: -(A psi' + B w) = R moment, -k (w' + psi) = R shear
    rows = [[(A * m * r - B) for m, r in zip(roots, ratio)], [k * (m - r) for m, r in zip(roots, ratio)]]
    det = rows[0][0] * rows[1][1] - rows[0][1] * rows[1][0]
    def edge(m_edge, q_edge):
        right = (radius * m_edge, radius * q_edge)
        w0 = (right[0] * rows[1][1] - right[1] * rows[0][1]) / det
        w1 = (rows[0][0] * right[1] - rows[1][0] * right[0]) / det
        return (w0 * cmath.exp(-roots[0] * place) + w1 * cmath.exp(-roots[1] * place)).real
    return b, thin, edge(moment, shear)


def springback(thickness, young, poisson, flow_stress, radius, fibres=400, steps=400):
    """Wide strip, perfectly plastic, bent to a radius (mid-surface) and released. Gardiner's closed form with a bilinear
    fibre; and fibre by fibre with J2 flow in plane stress, logarithmic strains, the neutral fibre where the force vanishes,
    closed-form return on the yield ellipse per small step. Released radii."""
    plane = young / (1 - poisson**2)
    x = 2 / math.sqrt(3) * flow_stress * radius / (plane * thickness)
    gardiner = radius / (1 - 3 * x + 4 * x**3)

    def update(state, increment):
        """One fibre: stresses after a strain increment along, none across; backward Euler."""
        s1, s2 = state[0] + plane * increment, state[1] + poisson * plane * increment
        if s1 * s1 - s1 * s2 + s2 * s2 <= flow_stress**2:
            return s1, s2
        # In sum and difference: a = E/(1-nu) and b = E/(1+nu) halve-wise decoupled; find the multiplier.
        total, diff = s1 + s2, s1 - s2
        a, b = young / (3 * (1 - poisson)), young / (1 + poisson)
        excess = lambda g: -((total / (1 + a * g))**2 + 3 * (diff / (1 + b * g))**2) / 4 + flow_stress**2
        g = bisect(excess, 0., 1.) if excess(1.) > 0 else bisect(excess, 0., 1e6)
        total, diff = total / (1 + a * g), diff / (1 + b * g)
        return (total + diff) / 2, (total - diff) / 2

    # Mid-points of equal fibres; bending about the mid-surface, shifted so that the force vanishes.
    places = [((i + .5) / fibres - .5) * thickness for i in range(fibres)]
    states = [(0., 0.)] * fibres

    def bend(states, old, new):
        """States at the curvature and stretch new, with the stretch for which the force vanishes."""
        def at(stretch):
            result, force, moment = [], 0., 0.
            for z, state in zip(places, states):
                before, after = old[1] + z * old[0], stretch + z * new
                state = update(state, math.log(after / before))
                result.append(state)
                force += state[0] / after
                moment += state[0] * z / after
            return result, force, moment * thickness / fibres
        low, high = old[1] - 3e-5, old[1] + 3e-5
        for _ in range(30):
            middle = .5 * (low + high)
            if at(middle)[1] < 0:
                low = middle
            else:
                high = middle
        result, _, moment = at(.5 * (low + high))
        return result, (new, .5 * (low + high)), moment

    position = (0., 1.)
    for step in range(steps):
        states, position, moment = bend(states, position, (step + 1) / (steps * radius))
    step = position[0] / 20
    while moment > 0:
        before, moment_before, states_before = position, moment, states
        states, position, moment = bend(states, position, position[0] - step)
        if moment <= 0 and step > position[0] * 1e-3:
            states, position, moment, step = states_before, before, moment_before, step / 5
    share = moment_before / (moment_before - moment)
    kappa = before[0] + share * (position[0] - before[0])
    return gardiner, 1 / kappa


def clamped_plate_linear(load, radius, thickness, young, poisson, factor=5. / 6.):
    """Centre deflection of a clamped circular plate: bending part, shear part (Reissner-Mindlin)."""
    stiffness = young * thickness**3 / (12 * (1 - poisson**2))
    return load * radius**4 / (64 * stiffness), load * radius**2 / (4 * factor * young / (2 * (1 + poisson)) * thickness)


def elastica(load, steps=4000):
    """Tip deflection over length of a cantilever with a dead load, load = P L^2 / (E I): theta'' = -load cos theta, with the
    slope at the root that leaves none of the curvature at the tip."""
    rate = lambda s, y: [y[1], -load * math.cos(y[0]), math.sin(y[0])]
    root = bisect(lambda k: rk4(rate, [0., k, 0.], 0., 1., 200)[1], 0., load)
    low, high = root - 1e-6 * load, root + 1e-6 * load
    for _ in range(40):
        middle = .5 * (low + high)
        if rk4(rate, [0., middle, 0.], 0., 1., steps // 10)[1] < 0:
            low = middle
        else:
            high = middle
    return rk4(rate, [0., .5 * (low + high), 0.], 0., 1., steps)[2]


def capstan(friction, angle, radius, thickness):
    """Ratio of the tensions, which act at the mid-surface of the strip while the friction acts on its face."""
    return math.exp(friction * angle / (1 + thickness / (2 * radius)))


def main():
    young, poisson, strain = 69004., .3, .8
    print("1  stretch to .8, E = 69004, nu = .3: Kirchhoff stress, equivalent plastic strain, thickness / initial one")
    curves = [("0", 200.), (".02", 262.), (".05", 301.), (".1", 339.), (".2", 379.), (".5", 438.), ("1", 489.)]
    laws = {
        "swift 589 1e-4 .216": SWIFT,
        "voce 450 715 16.93 + 129.24": lambda e: 450 + 265 * (1 - math.exp(-16.93 * e)) + 129.24 * e,
        "ludwik 194 550 .223": lambda e: 194 + 550 * e**.223,
        "linear 200 300": lambda e: 200 + 300 * e,
        "hockett-sherby 120 380 5 .75": lambda e: 380 - 260 * math.exp(-5 * e**.75),
        "perfectly plastic 200": lambda e: 200.,
    }
    for name, law in laws.items():
        print("   equibiaxial ", name, *("%.9g" % v for v in equibiaxial_stretch(law, young, poisson, strain)))
    print("   equibiaxial  two-branch power, E = 13393", *("%.9g" % v for v in equibiaxial_stretch(TWO_BRANCH, 13393., .3, strain)))
    for name, law in laws.items():
        print("   uniaxial    ", name, *("%.9g" % v for v in uniaxial_stretch(law, young, poisson, strain)))
    result = plane_strain_swift()
    print("   plane strain swift 589 1e-4 .216", *("%.9g" % v for v in result),
          "(the last: stress across); 2/sqrt(3) s(e): %.9g" % (2 / math.sqrt(3) * SWIFT(result[1])))
    print("5  clamped plate q = 1, a = 1, h = .1, E = 1: bending, shear, sum", *("%.9g" % v for v in clamped_plate_linear(1, 1, .1, 1, .3)),
          "%.9g" % sum(clamped_plate_linear(1, 1, .1, 1, .3)))
    for ratio in (100., 1000.):
        for name, moment, force in (("moment", 1., 0.), ("force", 0., 1.)):
            b, thin, thick = cylinder_edge(100., 100. / ratio, 2.1e5, .3, moment, force)
            print("6  cylinder R/h = %g, edge %s 1: b %.9g, thin shell %.9g, with shear deformation %.9g" % (ratio, name, b, thin, thick))
    for load in (1, 2, 5, 10):
        print("7  elastica P = %g: %.9f" % (load, elastica(load)))
    for friction in (.1, .2, .3):
        for degrees in (90, 180):
            print("16 capstan mu %g, %d degrees, h/R = .02: %.9g" % (friction, degrees, capstan(friction, math.radians(degrees), 50., 1.)))
    print("9  springback, some minutes ...", flush=True)
    print("   Gardiner %.9g, fibre by fibre %.7g" % springback(1., 210e3, .3, 200., 50.))


if __name__ == "__main__":
    main()
