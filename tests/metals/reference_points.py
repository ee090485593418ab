#!/usr/bin/env python3
"""Draws metals and loads, and computes what their points answer by programs that share nothing with deltaform.

    reference_points.py            writes points.csv beside this file (needs numpy and scipy; seconds)

A row is a case: how the blank is held (`tube` pulled along its axis, hoop free; `strip` in plane strain; `disc` in equibiaxial
tension), its length, the logarithmic strains at the ends of the stages, the entries of the material, and stresses, plastic
strains, thicknesses and rises of the temperature at the ends of the stages. points.py runs them. The references are closed forms, or ordinary
differential equations in time, strain or plastic strain that are integrated to 1e-9 at least.
"""
import csv
import math
import pathlib
import random

import numpy as np
from scipy.integrate import solve_ivp
from scipy.interpolate import PchipInterpolator
from scipy.optimize import brentq

HERE = pathlib.Path(__file__).resolve().parent
SYSTEMS = [("mm, N, MPa, s", 1., 10.), ("m, N, Pa, s", 1e6, .02), ("in, lbf, psi, s", 145.0377, .5)]
ALONG, HOOP, PLASTIC = "stress_meridional_mid", "stress_hoop_mid", "equivalent_plastic_strain"
RISE = "temperature_rise"
draw = random.Random(20261123)
U = draw.uniform


class Base:
    """Units, elasticity and a yield stress."""

    def __init__(self, system=None):
        self.units, self.factor, self.length = system or draw.choice(SYSTEMS)
        self.young, self.poisson, self.stress = U(60e3, 215e3) * self.factor, U(.25, .36), U(80, 500) * self.factor


class Curve:
    """A flow curve: entries, stress s(e), slope."""

    def __init__(self, law, S):
        self.law = law
        if law == "swift":
            K, e0, n = S * U(2, 4), U(.0005, .01), U(.08, .4)
            self.entries = {"Strength coefficient": K, "Prestrain": e0, "Hardening exponent": n}
            self.s, self.slope = lambda e: K * (e0 + max(e, 0))**n, lambda e: K * n * (e0 + max(e, 0))**(n - 1)
        elif law == "voce":
            s0, ss, b, H = S * U(.5, .9), S * U(1.2, 2), U(3, 30), S * U(0, .5)
            self.entries = {"Initial flow stress": s0, "Saturation stress": ss, "Saturation rate": b, "Linear modulus": H}
            self.s = lambda e: s0 + (ss - s0) * (1 - math.exp(-b * e)) + H * e
            self.slope = lambda e: (ss - s0) * b * math.exp(-b * e) + H
        elif law == "linear":
            H = S * U(.2, 3)
            self.entries = {"Initial flow stress": S, "Hardening modulus": H}
            self.s, self.slope = lambda e: S + H * e, lambda e: H
        elif law == "ludwik":
            K, n = S * U(1, 3), U(.3, .9)
            self.entries = {"Initial flow stress": S, "Strength coefficient": K, "Hardening exponent": n}
            self.s = lambda e: S + K * e**n
        elif law == "hockett-sherby":
            s0, ss, m, n = S * .7, S * U(1.3, 2), U(2, 9), U(.5, .95)
            self.entries = {"Initial flow stress": s0, "Saturation stress": ss, "Saturation rate": m, "Hardening exponent": n}
            self.s = lambda e: ss - (ss - s0) * math.exp(-m * e**n)
        elif law == "table":
            strains = [0, .02, .06, .15, .3, .6, 1.2]
            stresses = [S]
            for _ in strains[1:]:
                stresses.append(stresses[-1] + S * U(.02, .3))
            self.entries = {"Flow curve": "; ".join(f"{e:g} {s:.15g}" for e, s in zip(strains, stresses))}
            between = PchipInterpolator(strains, stresses)  # compared off the first and last part: ends are free to choose
            self.s = lambda e: float(between(e))
        else:
            self.entries = {"Flow stress": S}
            self.s, self.slope = lambda e: S, lambda e: 0.

    def section(self):
        return [("Hardening/Law", self.law)] + [("Hardening/" + name, value) for name, value in self.entries.items()]


class Surface:
    """An equivalent stress of the stresses along the meridian and the hoop: entries, q(x, y), its gradient."""

    def __init__(self, law):
        self.a, self.r, self.entries = 2, 1., [("Yield surface/Law", law)]
        if law != "mises":
            self.r = U(.5, 2.3)
            self.entries += [("Yield surface/r-bar", self.r)]
        if law == "hosford":
            self.a = draw.choice([4, 6, 8])
            self.entries += [("Yield surface/Exponent", self.a)]

    def q(self, x, y):
        a, r, m = self.a, self.r, max(abs(x), abs(y))
        return m * ((abs(x / m)**a + abs(y / m)**a + r * abs((x - y) / m)**a) / (1 + r))**(1 / a)

    def n(self, x, y):
        q = self.q(x, y)
        f = lambda v: abs(v / q)**(self.a - 1) * math.copysign(1, v)
        return np.array([(f(x) + self.r * f(x - y)) / (1 + self.r), (f(y) - self.r * f(x - y)) / (1 + self.r)])


class Rolled:
    """Hill 1948 with r0 and r90 and the rolling direction along or across the strip."""

    def __init__(self, direction):
        r0, r90 = U(.5, 2.2), U(.5, 2.2)
        G, self.H, F = 1 / (1 + r0), r0 / (1 + r0), r0 / (r90 * (1 + r0))
        self.along, self.hoop = (F, G) if direction == "across" else (G, F)
        self.entries = [("Yield surface/Law", "hill"), ("Yield surface/r0", r0), ("Yield surface/r90", r90),
                        ("Yield surface/Rolling direction", direction)]

    def q(self, x, y):
        return math.sqrt(self.along * x * x + self.hoop * y * y + self.H * (x - y)**2)

    def n(self, x, y):
        return np.array([self.along * x + self.H * (x - y), self.hoop * y - self.H * (x - y)]) / self.q(x, y)


class Cases:
    def __init__(self):
        self.rows = []

    def add(self, name, fast, kind, base, strains, entries, expected):
        """@p strains [(time, logarithmic strain)]; @p expected [(stage, column, value)]"""
        text = lambda value: value if isinstance(value, str) else f"{value:.15g}"
        entries = [("Young's modulus", base.young), ("Poisson's ratio", base.poisson)] + entries
        self.rows.append([name, "yes" if fast else "no", kind, base.units, f"{base.length:g}",
                          "; ".join(f"{t:.15g} {e:.15g}" for t, e in strains),
                          " | ".join(f"{entry}={text(value)}" for entry, value in entries),
                          "; ".join(f"{stage} {column} {value:.10g}" for stage, column, value in expected)])

    def write(self):
        with open(HERE / "points.csv", "w", newline="") as file:
            file.write("# points of drawn metals, by programs that share nothing with deltaform\n# reference_points.py\n")
            out = csv.writer(file, lineterminator="\n")
            out.writerow(["case", "fast", "held as", "units", "length", "time and strain", "material", "stage, column, value"])
            out.writerows(self.rows)


def plastic_strain(young, flow_stress, strain):
    """Of a bar."""
    return brentq(lambda e: flow_stress(e) / young + e - strain, 0, strain, xtol=1e-16)


def monotonic(cases):
    for law in ("mises", "hill", "hill", "hosford", "hosford"):
        base, surface = Base(), Surface(law)
        curve, strain = Curve(draw.choice(["swift", "voce", "linear", "ludwik", "hockett-sherby"]), base.stress), U(.1, .7)
        b = surface.q(1, 1)
        e = brentq(lambda e: (1 - base.poisson) * curve.s(e) / b / base.young + b * e / 2 - strain, 0, 10, xtol=1e-16)
        thickness = .05 * base.length * math.exp(-2 * base.poisson * curve.s(e) / b / base.young - b * e)
        cases.add(f"equibiaxial {law} {curve.law}", law == "mises", "disc", base, [(1, strain)], curve.section() + surface.entries,
                  [(1, ALONG, curve.s(e) / b), (1, PLASTIC, e), (1, "thickness", thickness)])
    for law, kind in (("hill", "linear"), ("hosford", "swift"), ("hill", "hockett-sherby"), ("hosford", "ludwik"), ("mises", "table"),
                      ("hill", "table")):
        base, surface = Base(), Surface(law)
        curve, strain = Curve(kind, base.stress), U(.1, .5)
        e = plastic_strain(base.young, curve.s, strain)
        thickness = 1e-4 * base.length * math.exp(-base.poisson * curve.s(e) / base.young - e / (1 + surface.r))
        cases.add(f"bar {law} {kind}", kind == "table", "tube", base, [(1, strain)], curve.section() + surface.entries,
                  [(1, ALONG, curve.s(e)), (1, PLASTIC, e), (1, "thickness", thickness)])
    base = Base()
    first, second, w = Curve("swift", base.stress), Curve("voce", base.stress), U(.2, .8)
    s = lambda e: w * first.s(e) + (1 - w) * second.s(e)
    e = plastic_strain(base.young, s, .31)
    entries = [("Hardening/Law", "sum"), ("Hardening/Weight", w)]
    for place, curve in (("First", first), ("Second", second)):
        entries += [(f"Hardening/{place}/Law", curve.law)]
        entries += [(f"Hardening/{place}/{name}", value) for name, value in curve.entries.items()]
    cases.add("bar mises sum of swift and voce", True, "tube", base, [(1, .31)], entries, [(1, ALONG, s(e)), (1, PLASTIC, e)])


def plane_strain(base, surface, curve, strain, terms=()):
    """Stress and plastic strain: rates in the strain, from the stress where flow begins (elastic until there)."""
    C = base.young / (1 - base.poisson**2) * np.array([[1, base.poisson], [base.poisson, 1]])
    elastic, k = C @ np.array([1., 0.]), len(terms)
    begin = curve.s(0) / surface.q(*elastic)

    def rates(_, z):
        stress, e, alpha = z[:2], z[2], z[3:].reshape(k, 2)
        xi = stress - alpha.sum(0)
        N = surface.n(*xi)
        of_alpha = [c / curve.s(e) * xi - g * a for (c, g), a in zip(terms, alpha)]
        hardening = curve.slope(e) + sum(N @ a for a in of_alpha)
        flow = (N @ elastic) / (N @ C @ N + hardening)
        return np.concatenate([C @ (np.array([1., 0.]) - flow * N), [flow], *[flow * a for a in of_alpha]])

    start = np.concatenate([elastic * begin, [1e-14], np.zeros(2 * k)])
    return solve_ivp(rates, (begin, strain), start, method="Radau", rtol=1e-10, atol=1e-12 * curve.s(0)).y[:3, -1]


def chaboche(terms):
    return [("Backstress/Law", "chaboche"), ("Backstress/Terms", "; ".join(f"{c:.15g} {g:.15g}" for c, g in terms))]


def in_plane_strain(cases):
    for law, kind, n_terms in (("mises", "swift", 0), ("hill", "voce", 0), ("hosford", "voce", 0), ("hosford", "swift", 0),
                               ("hill", "perfectly plastic", 2), ("mises", "perfectly plastic", 1),
                               ("hosford", "perfectly plastic", 2), ("along", "swift", 0), ("across", "swift", 0)):
        base = Base()
        surface = Rolled(law) if law in ("along", "across") else Surface(law)
        curve, strain = Curve(kind, base.stress), U(.05, .5)
        terms = [(base.stress * U(5, 60), U(5, 120)) for _ in range(n_terms)]
        z = plane_strain(base, surface, curve, strain, terms)
        cases.add(f"plane strain {law} {kind} {n_terms} terms", law in ("mises", "across"), "strip", base, [(1, strain)],
                  curve.section() + surface.entries + (chaboche(terms) if terms else []),
                  [(1, ALONG, z[0]), (1, HOOP, z[1]), (1, PLASTIC, z[2])])


def reversed_bar(young, s, terms, targets):
    """Armstrong and Frederick's terms are exact over the plastic strain of a leg."""
    plastic = e = strain = 0.
    alpha, result = [0.] * len(terms), []
    for target in targets:
        d = 1 if target > strain else -1

        def after(x):
            return [d * c / g + (a - d * c / g) * math.exp(-g * x) if g else a + d * c * x for (c, g), a in zip(terms, alpha)]

        stress = lambda x: sum(after(x)) + d * s(e + x)
        x = brentq(lambda x: (stress(x) / young + plastic + d * x - target) * d, 0, abs(target - strain), xtol=1e-16)
        result.append((stress(x), e + x))
        alpha, plastic, e, strain = after(x), plastic + d * x, e + x, target
    return result


def pulled_and_pressed(cases, name, fast, base, targets, result, entries):
    cases.add(name, fast, "tube", base, [(i + 1, t) for i, t in enumerate(targets)], entries,
              [(i + 1, ALONG, stress) for i, (stress, _) in enumerate(result)] + [(len(result), PLASTIC, result[-1][1])])


def backstresses(cases):
    for law, n_terms, kind in (("mises", 1, "voce"), ("hill", 2, "linear"), ("hosford", 2, "perfectly plastic"),
                               ("mises", 3, "perfectly plastic"), ("hill", 1, "linear")):
        base, surface = Base(), Surface(law)
        curve, targets = Curve(kind, base.stress), [U(.02, .06), -U(.01, .04), U(.02, .06)]
        terms = [(base.stress * U(5, 80), draw.choice([0, U(3, 150)]) if i else U(20, 200)) for i in range(n_terms)]
        pulled_and_pressed(cases, f"reversed {law} {kind} {n_terms} terms", n_terms == 3, base, targets,
                           reversed_bar(base.young, curve.s, terms, targets),
                           curve.section() + surface.entries + chaboche(terms))
    for law in ("mises", "hill", "hosford", "mises", "mises", "hill"):
        base, surface = Base(), Surface(law)
        Y = base.stress
        law_of = [Y, Y * U(1.2, 2), U(150, 600), U(5, 40), Y * U(.1, .6), U(.2, .9), Y * U(.2, .7)]
        targets = [U(.02, .08), -U(0., .04), U(.02, .06)]
        names = ["Yield stress", "Bounding stress", "Yield surface rate", "Bounding surface rate", "Bounding backstress",
                 "Stagnation", "Saturation stress"]
        entries = [("Backstress/Law", "yoshida-uemori")] + [("Backstress/" + name, value) for name, value in zip(names, law_of)]
        pulled_and_pressed(cases, f"reversed {law} yoshida-uemori", len(cases.rows) % 3 == 0, base, targets,
                           TwoSurfaces(base.young, *law_of).reach(targets),
                           Curve("perfectly plastic", Y).section() + surface.entries + entries)


class TwoSurfaces:
    """A bar of Yoshida and Uemori's metal: Runge and Kutta's method of fourth order over the plastic strain, cut where the
    surface of stagnation begins to move and where the strain is reached."""

    steps = 3000

    def __init__(self, young, Y, B, C, m, b, h, Rsat):
        self.young, self.Y, self.B, self.C, self.m, self.b, self.h, self.Rsat = young, Y, B, C, m, b, h, Rsat
        self.z = np.zeros(3)  # theta, beta, R
        self.centre = self.radius = self.plastic = self.e = self.strain = 0.

    def rates(self, z, d, moves):
        theta, beta, R = z
        a = self.B + R - self.Y
        return np.array([self.C * (a * d - math.sqrt(a * abs(theta)) * np.sign(theta)), self.m * (self.b * d - beta),
                         self.m * (self.Rsat - R) if moves else 0.])

    def step(self, x, d, moves):
        f = lambda z: self.rates(z, d, moves)
        k1 = f(self.z)
        k2 = f(self.z + .5 * x * k1)
        k3 = f(self.z + .5 * x * k2)
        return self.z + x / 6 * (k1 + 2 * k2 + 2 * k3 + f(self.z + x * k3))

    def leg(self, target):
        d = 1. if target > self.strain else -1.
        most = abs(target - self.strain) / self.steps
        missing = lambda z, plastic: (self.young * (target - plastic) - z[0] - z[1]) * d - self.Y
        while missing(self.z, self.plastic) > 1e-9 * self.Y:
            outwards = self.z[1] - self.centre
            moves = abs(outwards) >= self.radius - 1e-12 * self.Y and outwards * d >= 0
            x, z = most, self.step(most, d, moves)
            if not moves and (z[1] - self.centre) * d > self.radius:
                x = brentq(lambda x: (self.step(x, d, moves)[1] - self.centre) * d - self.radius, 0, x, xtol=1e-18)
            if missing(self.step(x, d, moves), self.plastic + d * x) < 0:
                x = brentq(lambda x: missing(self.step(x, d, moves), self.plastic + d * x), 0, x, xtol=1e-18)
            self.z = self.step(x, d, moves)
            self.plastic, self.e = self.plastic + d * x, self.e + x
            beyond = abs(self.z[1] - self.centre) - self.radius
            if beyond > 0:
                self.radius += self.h * beyond
                self.centre += (1 - self.h) * beyond * d
        self.strain = target
        return self.young * (target - self.plastic), self.e

    def reach(self, targets):
        return [self.leg(target) for target in targets]


def bar_in_time(base, strain_rate, plastic_rate, time, heating=None):
    """Stress, plastic strain and rise of temperature of a bar: rates in time. @p plastic_rate(stress, e, rise)"""
    S = base.stress

    def rates(t, z):
        stress, e, rise = z[0] * S, z[1], z[2]
        flow = plastic_rate(stress, e, rise)
        return [base.young / S * (strain_rate(t) - flow), flow, heating * stress * flow if heating else 0.]

    path = solve_ivp(rates, (0., time), [0., 0., 0.], method="Radau", rtol=1e-9, atol=1e-11, max_step=time / 200)
    assert path.success, path.message
    z = path.y[:, -1]
    return z[0] * S, z[1], z[2]


def rates(cases):
    for law, kind in (("cowper-symonds", "swift"), ("cowper-symonds", "linear"), ("johnson-cook", "voce"), ("johnson-cook", "swift"),
                      ("power", "voce")):
        base = Base()
        curve, strain, rate = Curve(kind, base.stress), U(.05, .3), 10**U(-2, 2.5)
        if law == "cowper-symonds":
            D, p = 10**U(1, 3.5), U(2, 6)
            flow = lambda t, e, _: D * max(t / curve.s(e) - 1, 0)**p
            entries = [("Reference rate", D), ("Rate exponent", p)]
        elif law == "johnson-cook":
            C, r0 = U(.005, .06), 10**U(-5, -3)
            flow = lambda t, e, _: r0 * math.exp(min((t / curve.s(e) - 1) / C, 60.))  # what flows under r0 does not count
            entries = [("Rate coefficient", C), ("Reference rate", r0)]
        else:
            K, n = base.stress * U(.1, .5), U(3, 8)
            flow = lambda t, e, _: (max(t - curve.s(e), 0) / K)**n
            entries = [("Overstress", K), ("Rate exponent", n)]
        stress, e, _ = bar_in_time(base, lambda t: rate, flow, strain / rate)
        cases.add(f"rate {law} {kind}", law == "power", "tube", base, [(strain / rate, strain)],
                  curve.section() + [("Rate factor/Law", law)] + [("Rate factor/" + k, v) for k, v in entries],
                  [(1, ALONG, stress), (1, PLASTIC, e)])


def relaxation(cases):
    """Pulled at a constant velocity, held."""
    for i in range(4):
        base = Base(SYSTEMS[0])
        base.young = 200e3
        K, n, s0, pull, strain, hold = U(60, 200), U(3, 7), U(20, 80), U(1, 20), U(.002, .01), 10**U(-1, 1)
        velocity = math.expm1(strain) / pull
        flow = lambda t: (max(t - s0, 0) / K)**n
        run = lambda rate, time, start: solve_ivp(lambda t, z: [base.young * (rate(t) - flow(z[0]))], (0, time), [start],
                                                  method="Radau", rtol=1e-11, atol=1e-9).y[0, -1]
        pulled = run(lambda t: velocity / (1 + velocity * t), pull, 0.)
        left = run(lambda t: 0., hold, pulled)
        cases.add(f"relaxation by {100 * (1 - left / pulled):.0f} %", i in (1, 2), "tube", base, [(pull, strain), (pull + hold, strain)],
                  [("Hardening/Law", "perfectly plastic"), ("Hardening/Flow stress", s0), ("Rate factor/Law", "power"),
                   ("Rate factor/Overstress", K), ("Rate factor/Rate exponent", n)], [(1, ALONG, pulled), (2, ALONG, left)])


def heat(cases):
    for soft, kind in (("johnson-cook", "swift"), ("linear", "voce"), ("johnson-cook", "linear"), ("linear", "ludwik"), ("none", "voce")):
        base = Base()
        curve, strain, capacity, share, T0 = Curve(kind, base.stress), U(.1, .8), U(2, 5) * base.factor, U(.7, 1), U(20., 500.)
        entries = [("Adiabatic", "true"), ("Heat capacity", capacity), ("Heated share", share), ("Softening", soft)]
        if soft == "linear":
            c = U(3e-4, 2e-3)
            f = lambda rise: 1 - c * rise
            entries += [("Softening coefficient", c)]
        elif soft == "johnson-cook":
            m, melting = U(.6, 1.4), T0 + U(600, 1500)
            f = lambda rise: 1 - (max(rise, 0) / (melting - T0))**m
            entries += [("Softening exponent", m), ("Initial temperature", T0), ("Melting temperature", melting)]
        else:
            f = lambda rise: 1.
        path = solve_ivp(lambda e, z: [share * curve.s(e) * f(z[0]) / capacity], (0, strain), [0.], method="DOP853", rtol=1e-11,
                         atol=1e-9, dense_output=True).sol
        stress = lambda e: curve.s(e) * f(path(e)[0])
        e = plastic_strain(base.young, stress, strain)
        cases.add(f"adiabatic {soft} {kind}", soft == "linear" and kind == "voce", "tube", base, [(1, strain)],
                  curve.section() + [("Heat/" + k, v) for k, v in entries],
                  [(1, ALONG, stress(e)), (1, PLASTIC, e), (1, RISE, path(e)[0])])
    for name, A, B, n, C, m, melting, capacity in (("4340", 792, 510, .26, .014, 1.03, 1793, 3.73491),
                                                   ("Armco iron", 175, 380, .32, .06, .55, 1811, 3.56628)):
        base = Base(SYSTEMS[0])
        base.stress = A
        rate, strain, T0 = 10**U(.5, 3.5), U(.2, .9), 298.
        cold = lambda e, rise: (A + B * max(e, 0.)**n) * (1 - (max(rise, 0.) / (melting - T0))**m)
        flow = lambda t, e, rise: math.exp(min((t / cold(e, rise) - 1) / C, 60.))
        stress, e, rise = bar_in_time(base, lambda t: rate, flow, strain / rate, .9 / capacity)
        cases.add(f"Johnson and Cook in full, {name}", name == "4340", "tube", base, [(strain / rate, strain)],
                  [("Hardening/Law", "ludwik"), ("Hardening/Initial flow stress", A), ("Hardening/Strength coefficient", B),
                   ("Hardening/Hardening exponent", n), ("Rate factor/Law", "johnson-cook"), ("Rate factor/Rate coefficient", C),
                   ("Rate factor/Reference rate", 1.), ("Heat/Adiabatic", "true"), ("Heat/Heat capacity", capacity),
                   ("Heat/Heated share", .9), ("Heat/Softening", "johnson-cook"), ("Heat/Softening exponent", m),
                   ("Heat/Initial temperature", T0), ("Heat/Melting temperature", melting)],
                  [(1, ALONG, stress), (1, PLASTIC, e), (1, RISE, rise)])


def flow_curves(cases):
    """A table over rate and temperature: cubics over the strain, linear in the logarithm of the rate and in temperature."""
    strains = [0, .05, .1, .2, .4, .6, 1.2]  # a straight line to .1: any rule for its end is exact; the last part is not used
    for heated in (False, True, True):
        base = Base()
        rates_of, temperatures = [10**U(-3, -2), 10**U(-1, 0), 10**U(1, 2)], [U(10, 30), U(200, 300), U(500, 700)]
        curves, rows = {}, []
        for i, r in enumerate(rates_of):
            for j, T in enumerate(temperatures):
                scale = base.stress * (1 + .15 * i) * (1 - .25 * j)
                stresses = [scale * (1 + 1.2 * min(e, .1) + .8 * max(e - .1, 0)**.7) for e in strains]
                curves[i, j] = PchipInterpolator(strains, stresses)
                rows += [f"{r:.15g} {T:.15g} {e:g} {s:.15g}" for e, s in zip(strains, stresses)]
        T0, strain, rate = U(30, 150), U(.2, .5), math.sqrt(rates_of[0] * rates_of[1]) * 10**U(-.3, .3)
        capacity, share = U(2, 5) * base.factor, .9
        thermal = lambda i, e, T: np.interp(T, temperatures, [float(curves[i, j](e)) for j in range(3)])

        def flow(t, e, rise):
            s = [thermal(i, e, T0 + rise) for i in range(3)]
            if t <= s[0]:
                return 0.
            part = 0 if t < s[1] else 1
            return rates_of[part] * (rates_of[part + 1] / rates_of[part])**min((t - s[part]) / (s[part + 1] - s[part]), 3.)

        stress, e, rise = bar_in_time(base, lambda t: rate, flow, strain / rate, share / capacity if heated else None)
        entries = [("Hardening/Law", "flow curves"), ("Hardening/Flow curves", "; ".join(rows)), ("Hardening/Initial temperature", T0)]
        if heated:
            entries += [("Heat/Adiabatic", "true"), ("Heat/Heat capacity", capacity), ("Heat/Heated share", share)]
        cases.add(f"flow curves{', adiabatic' if heated else ''}", heated, "tube", base, [(strain / rate, strain)], entries,
                  [(1, ALONG, stress), (1, PLASTIC, e)] + ([(1, RISE, rise)] if heated else []))


def steep(base):
    """Flow curves that begin steeply: entries, stress, slope."""
    law, S = draw.choice(["swift", "ludwik"]), base.stress
    curve = Curve(law, S)
    if law == "swift":
        K, e0, n = S * U(2, 4), 10**U(-4, -3), U(.1, .3)
        curve.entries = {"Strength coefficient": K, "Prestrain": e0, "Hardening exponent": n}
        curve.s = lambda e: K * (e0 + max(e, 0.))**n
        curve.slope = lambda e: K * n * (e0 + max(e, 0.))**(n - 1)
    else:
        K, n = S * U(1, 3), U(.25, .5)
        curve.entries = {"Initial flow stress": S, "Strength coefficient": K, "Hardening exponent": n}
        curve.s, curve.slope = lambda e: S + K * max(e, 0.)**n, lambda e: K * n * max(e, 1e-12)**(n - 1)
    return curve


def softening(base):
    """What heat makes of a metal: rise per work, factor, its slope, entries."""
    capacity, share, T0 = U(2, 5) * base.factor, U(.7, 1), U(20., 500.)
    entries = [("Heat/Adiabatic", "true"), ("Heat/Heat capacity", capacity), ("Heat/Heated share", share)]
    if draw.random() < .5:
        c = U(3e-4, 1.5e-3)
        return (share / capacity, lambda rise: 1 - c * rise, lambda rise: -c,
                entries + [("Heat/Softening", "linear"), ("Heat/Softening coefficient", c)])
    m, melting = U(.6, 1.4), T0 + U(600, 1500)
    part = lambda rise: max(rise, 0.) / (melting - T0)
    return (share / capacity, lambda rise: 1 - part(rise)**m, lambda rise: -m * max(part(rise), 1e-12)**(m - 1) / (melting - T0),
            entries + [("Heat/Softening", "johnson-cook"), ("Heat/Softening exponent", m), ("Heat/Initial temperature", T0),
                       ("Heat/Melting temperature", melting)])


def own_heat(cases):
    """Metals whose flow curves begin steeply and that heat themselves."""
    def over_flow(curve, factor, heating, most):
        rise = solve_ivp(lambda e, z: [heating * curve.s(e) * factor(z[0])], (0, most), [0.], method="DOP853", rtol=1e-11, atol=1e-10,
                         max_step=most / 500, dense_output=True).sol
        return (lambda e: curve.s(e) * factor(rise(e)[0])), (lambda e: rise(e)[0])

    for law in ("mises", "hill", "hosford"):
        base, surface, strain = Base(), Surface(law), U(.1, .6)
        curve, (heating, factor, _, entries) = steep(base), softening(base)
        b = surface.q(1, 1)
        stress, rise = over_flow(curve, factor, heating, 4 * strain)
        e = brentq(lambda e: (1 - base.poisson) * stress(e) / b / base.young + b * e / 2 - strain, 0, 4 * strain, xtol=1e-16)
        cases.add(f"own heat, equibiaxial {law} {curve.law}", law == "hosford", "disc", base, [(1, strain)],
                  curve.section() + surface.entries + entries, [(1, ALONG, stress(e) / b), (1, PLASTIC, e), (1, RISE, rise(e))])
    for _ in range(3):
        base, strain = Base(), U(.08, .6)
        curve, (heating, factor, _, entries) = steep(base), softening(base)
        stress, rise = over_flow(curve, factor, heating, strain)
        e = plastic_strain(base.young, stress, strain)
        cases.add(f"own heat, bar {curve.law}", False, "tube", base, [(1, strain)], curve.section() + entries,
                  [(1, ALONG, stress(e)), (1, PLASTIC, e), (1, RISE, rise(e))])
    for law in ("mises", "across"):
        base, strain = Base(), U(.08, .5)
        surface = Rolled(law) if law == "across" else Surface(law)
        curve, (heating, factor, slope, entries) = Curve("swift", base.stress), softening(base)
        x, y, e, rise = hot_plane_strain(base, surface, curve, strain, heating, factor, slope)
        cases.add(f"own heat, plane strain {law}", law == "mises", "strip", base, [(1, strain)],
                  curve.section() + surface.entries + entries, [(1, ALONG, x), (1, HOOP, y), (1, PLASTIC, e), (1, RISE, rise)])
    for law in ("cowper-symonds", "johnson-cook", "power", "cowper-symonds", "johnson-cook"):
        base, strain, rate = Base(), U(.08, .6), 10**U(-1, 3)
        curve, (heating, factor, _, heat_entries) = Curve("swift", base.stress), softening(base)
        flow, entries = rate_law(law, base, lambda e, rise: curve.s(e) * factor(rise))
        stress, e, rise = bar_in_time(base, lambda t: rate, flow, strain / rate, heating)
        cases.add(f"own heat, rate {law}", law == "power", "tube", base, [(strain / rate, strain)],
                  curve.section() + entries + heat_entries, [(1, ALONG, stress), (1, PLASTIC, e), (1, RISE, rise)])


def hot_plane_strain(base, surface, curve, strain, heating, factor, factor_slope):
    """Stress, plastic strain and rise of the temperature: as plane_strain()."""
    C = base.young / (1 - base.poisson**2) * np.array([[1, base.poisson], [base.poisson, 1]])
    elastic = C @ np.array([1., 0.])
    begin = curve.s(0) / surface.q(*elastic)

    def rates(_, z):
        stress, e, rise = z[:2], z[2], z[3]
        N, cold, hot = surface.n(*stress), curve.s(e), factor(rise)
        warming = heating * cold * hot
        flow = (N @ elastic) / (N @ C @ N + curve.slope(e) * hot + cold * factor_slope(rise) * warming)
        return np.concatenate([C @ (np.array([1., 0.]) - flow * N), [flow, flow * warming]])

    return solve_ivp(rates, (begin, strain), np.concatenate([elastic * begin, [0., 0.]]), method="Radau", rtol=1e-10,
                     atol=1e-12 * curve.s(0)).y[:, -1]


def rate_law(law, base, static):
    """Rate of the plastic strain at (stress, e, rise) over @p static(e, rise), entries. `power` adds to the cold stress."""
    if law == "cowper-symonds":
        D, p = 10**U(1, 3.5), U(2, 6)
        flow = lambda t, e, rise: D * max(t / static(e, rise) - 1, 0)**p
        entries = [("Reference rate", D), ("Rate exponent", p)]
    elif law == "johnson-cook":
        C, r0 = U(.005, .06), 10**U(-5, -3)
        flow = lambda t, e, rise: r0 * math.exp(min((t / static(e, rise) - 1) / C, 60.))
        entries = [("Rate coefficient", C), ("Reference rate", r0)]
    else:
        K, n = base.stress * U(.1, .5), U(3, 8)
        # s = f (s_cold + K rate^(1/n)): over the static flow stress f s_cold there is f K.
        flow = lambda t, e, rise: (max(t - static(e, rise), 0) / (K * static(0., rise) / static(0., 0.)))**n
        entries = [("Overstress", K), ("Rate exponent", n)]
    return flow, [("Rate factor/Law", law)] + [("Rate factor/" + k, v) for k, v in entries]


def main():
    cases = Cases()
    for group in (monotonic, in_plane_strain, backstresses, rates, relaxation, heat, flow_curves, own_heat):
        group(cases)
    cases.write()
    print(len(cases.rows), "cases")


if __name__ == "__main__":
    main()
