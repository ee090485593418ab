#!/usr/bin/env python3
"""A strip in plane strain, bent to a radius and made straight again under a tension, then released: fibre by fibre.

    python3 tests/scenes/strip_fibres.py [FIBRES STEPS]

Prints the references of side_wall_curl*.prm and bending_chaboche*.prm. It knows nothing of deltaform: fibres of equal thickness, the
midpoint rule, backward Euler, secant and bisection. Every section stays plane and carries the tension as its force. Standard library
only; ten seconds a row.

Strain, of a fibre at the distance y from the middle, at the stretch m and the curvature k over the initial length:
  linear  m - 1 - y k, the thickness constant: the reading of textbooks
  log     ln(m - mu y k), mu the ratio of the present thickness to the initial one (of the step before)
"""
import math
import sys


class Metal:
    """Mises, isotropic flow stress s(x), backstresses (C, gamma) in Ziegler's form. A = (s1 + s2)/sqrt 2, B = (s1 - s2)/sqrt 2."""

    def __init__(self, young, poisson, flow, terms=()):
        self.young, self.poisson, self.flow, self.terms = young, poisson, flow, terms
        self.of_a, self.of_b = young / (1 - poisson), young / (1 + poisson)
        self.plane = young / (1 - poisson**2)

    def virgin(self):
        return 0., 0., 0., ((0., 0.),) * len(self.terms)

    def pulled(self, fibre, strain):
        """The fibre (A, B, x, backstresses) after a further strain along, none across."""
        a, b, old, backs = fibre
        a, b = a + self.of_a * strain / math.sqrt(2), b + self.of_b * strain / math.sqrt(2)

        def relative(x):
            s = self.flow(old + x)
            drag = sum(c / (1 + g * x) for c, g in self.terms) * x / s
            back = [sum(alpha[i] / (1 + g * x) for alpha, (c, g) in zip(backs, self.terms)) for i in (0, 1)]
            return (a - back[0]) / (1 + self.of_a / 2 * x / s + drag), (b - back[1]) / (1 + self.of_b * 1.5 * x / s + drag), s

        def excess(x):
            r_a, r_b, s = relative(x)
            return math.sqrt(r_a**2 / 2 + 1.5 * r_b**2) - s

        low, f_low = 0., excess(0.)
        if f_low <= 0:
            return a, b, old, backs
        high = 2 * abs(strain) + 1e-12
        f_high = excess(high)
        while f_high > 0:
            high *= 2
            f_high = excess(high)
        for _ in range(100):  # regula falsi after Illinois
            x = (low * f_high - high * f_low) / (f_high - f_low)
            f = excess(x)
            if abs(f) < 1e-11 * self.flow(old):
                break
            if f * f_high < 0:
                low, f_low = high, f_high
            else:
                f_low /= 2
            high, f_high = x, f
        r_a, r_b, s = relative(x)
        backs = tuple(tuple((alpha[i] + c * x * r / s) / (1 + g * x) for i, r in ((0, r_a), (1, r_b)))
                      for alpha, (c, g) in zip(backs, self.terms))
        return r_a + sum(t[0] for t in backs), r_b + sum(t[1] for t in backs), old + x, backs


class Strip:
    def __init__(self, metal, thickness, fibres, finite):
        self.metal, self.finite = metal, finite
        self.weight = thickness / fibres
        self.places = [((i + .5) / fibres - .5) * thickness for i in range(fibres)]
        self.fibres, self.strains = [metal.virgin()] * fibres, [0.] * fibres
        self.stretch, self.curvature, self.ratio = 1., 0., 1.

    def tried(self, stretch, curvature):
        """Force, moment and fibres there."""
        strains = [math.log(stretch - self.ratio * y * curvature) if self.finite else stretch - 1 - y * curvature for y in self.places]
        fibres = [self.metal.pulled(f, new - old) for f, new, old in zip(self.fibres, strains, self.strains)]
        along = [self.weight * (f[0] + f[1]) / math.sqrt(2) * (math.exp(-e) if self.finite else 1.) for f, e in zip(fibres, strains)]
        return sum(along), -sum(n * y for n, y in zip(along, self.places)) * self.ratio, fibres, strains

    def accept(self, stretch, curvature, tried):
        self.stretch, self.curvature, (self.fibres, self.strains) = stretch, curvature, tried[2:]
        if self.finite:
            young, poisson = self.metal.young, self.metal.poisson
            # Elastic along and across from the stress; what is plastic keeps the volume.
            elastic = [(math.sqrt(2) * f[0] * (1 - poisson) / young, -math.sqrt(2) * poisson * f[0] / young) for f in self.fibres]
            self.ratio = sum(math.exp(e3 - (e - e12)) for e, (e12, e3) in zip(self.strains, elastic)) / len(self.strains)

    def bend(self, curvature, force):
        """To the curvature, at the force. Returns the moment."""
        ends = [self.stretch, self.stretch + 1e-7]
        values = [self.tried(m, curvature) for m in ends]
        while abs(values[1][0] - force) > 1e-8 and values[1][0] != values[0][0]:
            ends = [ends[1], ends[1] - (values[1][0] - force) * (ends[1] - ends[0]) / (values[1][0] - values[0][0])]
            values = [values[1], self.tried(ends[1], curvature)]
        self.accept(ends[1], curvature, values[1])
        return values[1][1]

    def release(self, force, moment, steps=10):
        """Both to zero, in equal steps, by Newton's method with differences."""
        for part in range(steps - 1, -1, -1):
            m, k, h = self.stretch, self.curvature, 1e-8
            for _ in range(6):
                n, b = [v - goal * part / steps for v, goal in zip(self.tried(m, k), (force, moment))]
                along, turned = self.tried(m + h, k), self.tried(m, k + h)
                f = [[(v[i] - now[i]) / h for v in (along, turned)] for now in [self.tried(m, k)] for i in (0, 1)]
                determinant = f[0][0] * f[1][1] - f[0][1] * f[1][0]
                m, k = m - (f[1][1] * n - f[0][1] * b) / determinant, k - (f[0][0] * b - f[1][0] * n) / determinant
            self.accept(m, k, self.tried(m, k))


def bent_and_straightened(metal, thickness, radius, force, finite, fibres, steps):
    """Moments of the bent and of the straight strip, its stretch and thickness ratio then, curvature and stretch after release."""
    strip = Strip(metal, thickness, fibres, finite)
    if force:
        for i in range(20):
            strip.bend(0., force * (i + 1) / 20)
    moments = []
    for start, end in ((0., 1 / radius), (1 / radius, 0.)):
        for i in range(steps):
            moment = strip.bend(start + (end - start) * (i + 1) / steps, force)
        moments.append(moment)
    straight = strip.stretch, strip.ratio
    strip.release(force, moments[1])
    return moments + list(straight) + [strip.curvature, strip.stretch]


def main():
    fibres, steps = (int(word) for word in sys.argv[1:3]) if len(sys.argv) > 2 else (200, 400)
    mild_steel = Metal(206e3, .3, lambda x: 565.32 * (.007117 + x)**.2589)
    chaboche = Metal(206e3, .3, lambda x: 200., ((20000., 200.), (2000., 10.)))
    print("metal, strain, tension: moment bent, straight; stretch, thickness ratio straight; curvature, stretch released; radius")
    for name, metal, thickness, radius, forces in (("mild steel", mild_steel, .78, 5.39, (0., 40.)), ("chaboche", chaboche, 1., 20., (0.,))):
        for finite in (False, True):
            for force in forces:
                row = bent_and_straightened(metal, thickness, radius, force, finite, fibres, steps)
                radius_then = (row[5] if finite else 1.) / abs(row[4])
                print(name, "log" if finite else "linear", force, *(f"{v:.6g}" for v in row), f"{radius_then:.2f}", flush=True)


if __name__ == "__main__":
    main()
