"""Input of CalculiX for the problems of calculix.py: the meshes, materials and tools of deltaform's scenes."""
import math


class Job:
    """Nodes, elements, sets; x is the radius, y the axis."""

    def __init__(self):
        self.nodes, self.elements, self.sets = [], [], {}

    def node(self, x, y):
        self.nodes.append((x, y))
        return len(self.nodes)

    def block(self, name, kind, xs, place):
        """Quadrilaterals between the lines xs[0] and xs[1] of parameters; place maps a pair of them to a point.

        Returns the numbers of nodes by (column, row) in half elements, and those of elements by (column, row).
        """
        quadratic = kind.startswith("CAX8")
        (us, vs), ids, cells = xs, {}, {}
        half = [[(a + b) / 2 for a, b in zip(line, line[1:])] for line in (us, vs)]
        def at(line, middles, i):
            return line[i // 2] if i % 2 == 0 else middles[i // 2]
        for i in range(0, 2 * len(us) - 1, 1 if quadratic else 2):
            for j in range(0, 2 * len(vs) - 1, 1 if quadratic else 2):
                if i % 2 and j % 2:
                    continue
                ids[i, j] = self.node(*place(at(us, half[0], i), at(vs, half[1], j)))
        for c in range(len(us) - 1):
            for r in range(len(vs) - 1):
                i, j = 2 * c, 2 * r
                corners = [ids[i, j], ids[i + 2, j], ids[i + 2, j + 2], ids[i, j + 2]]
                if quadratic:
                    corners += [ids[i + 1, j], ids[i + 2, j + 1], ids[i + 1, j + 2], ids[i, j + 1]]
                self.elements.append((name, kind, corners))
                cells[c, r] = len(self.elements)
        return ids, cells

    def tool(self, name, outline, depth):
        """A chain of elements behind an outline of points walked with the tool to the left; its face is S1."""
        inner, outer = [], []
        for k, (x, y) in enumerate(outline):
            a, b = outline[max(k - 1, 0)], outline[min(k + 1, len(outline) - 1)]
            length = math.hypot(b[0] - a[0], b[1] - a[1])
            inner.append(self.node(x, y))
            outer.append(self.node(max(0., x - depth * (b[1] - a[1]) / length), y + depth * (b[0] - a[0]) / length))
        faces = []
        for k in range(len(outline) - 1):
            self.elements.append((name, "CAX4", [inner[k], inner[k + 1], outer[k + 1], outer[k]]))
            faces.append((len(self.elements), "S1"))
        self.sets[name] = inner + outer
        return faces

    def header(self):
        lines = ["*NODE, NSET=NALL"] + ["%d, %.15g, %.15g, 0." % (i + 1, x, y) for i, (x, y) in enumerate(self.nodes)]
        for name, kind in dict.fromkeys((e[0], e[1]) for e in self.elements):
            lines.append("*ELEMENT, TYPE=%s, ELSET=E%s" % (kind, name))
            lines += ["%d, %s" % (i + 1, ", ".join(map(str, e[2]))) for i, e in enumerate(self.elements) if e[0] == name]
        for name, nodes in self.sets.items():
            lines.append("*NSET, NSET=%s" % name)
            lines += ["%d," % node for node in nodes]
        return lines


def surface(name, faces):
    return ["*SURFACE, NAME=%s, TYPE=ELEMENT" % name] + ["%d, %s" % face for face in faces]


def material(name, young, poisson, table=()):
    lines = ["*MATERIAL, NAME=%s" % name, "*ELASTIC", "%.10g, %.10g" % (young, poisson)]
    if table:
        lines += ["*PLASTIC"] + ["%.10g, %.10g" % (stress, strain) for strain, stress in table]
    return lines


def contact(name, slave, master, stiffness, friction=0., stick=0., kind="SURFACE TO SURFACE"):
    lines = ["*SURFACE INTERACTION, NAME=I%s" % name, "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR", "%.10g" % stiffness]
    if friction:
        lines += ["*FRICTION", "%g, %.10g" % (friction, stick)]
    return lines + ["*CONTACT PAIR, INTERACTION=I%s, TYPE=%s" % (name, kind), "%s, %s" % (slave, master)]


def step(lines, first, largest, total=1., nlgeom=False, prints=(), increments=10000):
    return (["*STEP, INC=%d%s" % (increments, ", NLGEOM" if nlgeom else ""), "*STATIC",
             "%g, %g, %g, %g" % (first, total, 1e-7 * total, largest)] + lines +
            [line for name in prints for line in ("*NODE PRINT, NSET=%s, TOTALS=ONLY" % name, "RF")] + ["*END STEP"])


def graded(n, length, size):
    """Places of the nodes of elements whose sizes go like size(t)."""
    sizes = [size((i + .5) / n) for i in range(n)]
    places = [0.]
    for value in sizes:
        places.append(places[-1] + value)
    return [length * place / places[-1] for place in places]


def steady_then_growing(n, length, first, steady):
    """Places of the nodes of n elements: `steady` ones of the size `first`, the others grow by a constant ratio. And that ratio."""
    low, high = 1. + 1e-9, 10.
    for _ in range(200):
        ratio = (low + high) / 2
        reached = steady * first + sum(first * ratio ** (k + 1) for k in range(n - steady))
        low, high = (ratio, high) if reached < length else (low, ratio)
    places = [0.]
    for i in range(n):
        places.append(places[-1] + (first if i < steady else first * ratio ** (i - steady + 1)))
    return [place * length / places[-1] for place in places], ratio


def one_element():
    job = Job()
    ids, _ = job.block("B", "CAX4", ([0., 1.], [0., 1.]), lambda u, v: (u, v))
    job.sets["BOTTOM"] = [ids[0, 0], ids[2, 0]]
    return "\n".join(job.header() + material("M", 1000., .3) + ["*SOLID SECTION, ELSET=EB, MATERIAL=M", "*BOUNDARY", "BOTTOM, 2, 2",
                     "%d, 1, 1" % ids[0, 0]] + step(["*CLOAD", "%d, 2, 1." % ids[2, 2]], 1., 1.)) + "\n"


def hertz(n, kind, line=None, stiffness=1e7, young=1000., nu=.3, radius=200., approach=.005, size=50.):
    """prm/hertz_sphere.prm: the outer boundary moves as in the half-space under the force of Hertz. @p line: places of nodes."""
    job = Job()
    r = depth = line or graded(n, size, lambda t: t + .02)
    # u grows outwards, v upwards; v = 0 is the base
    ids, cells = job.block("B", kind, (r, [depth[-1] - d for d in reversed(depth)]), lambda u, v: (u, v - size))
    last_i, last_j = max(i for i, _ in ids), max(j for _, j in ids)
    shear, force = young / (2 * (1 + nu)), 4. / 3. * young / (1 - nu ** 2) * math.sqrt(radius) * approach ** 1.5
    boundary = ["*BOUNDARY"]
    for (i, j), node in ids.items():
        if i == 0 and j != 0:
            boundary.append("%d, 1, 1" % node)
        if i != last_i and j != 0:
            continue
        x, z = job.nodes[node - 1]
        rho, factor = math.hypot(x, z), force / (4 * math.pi * shear)
        boundary.append("%d, 1, 1, %.12g" % (node, factor * (-x * z / rho ** 3 - (1 - 2 * nu) * x / (rho * (rho - z)))))
        boundary.append("%d, 2, 2, %.12g" % (node, -factor * (z * z / rho ** 3 + 2 * (1 - nu) / rho)))
    slaves = [(cells[c, n - 1], "S3") for c in range(n) if r[c] < 3.]
    facets = 300
    angle = 3.5 / radius
    faces = job.tool("TOOL", [(radius * math.sin(angle * k / facets), radius * (1 - math.cos(angle * k / facets)))
                              for k in range(facets + 1)], .1)
    boundary += ["TOOL, 1, 1, 0.", "TOOL, 2, 2, %.12g" % -approach]
    # p0 = 3.5: with 1e7 a penetration of 3.5e-7, 7e-5 of the approach
    return "\n".join(job.header() + material("M", young, nu) + surface("SLAVE", slaves) + surface("MASTER", faces) +
                     ["*SOLID SECTION, ELSET=EB, MATERIAL=M", "*SOLID SECTION, ELSET=ETOOL, MATERIAL=M"] +
                     contact("C", "SLAVE", "MASTER", stiffness) + step(boundary, 1., 1., prints=["TOOL"])) + "\n"


def upsetting(n, across, kind, largest=.05, travel=9., friction=0.):
    """prm/upsetting.prm. With friction the free side, which folds onto the die, touches too."""
    job = Job()
    ids, cells = job.block("B", kind, ([10. * i / n for i in range(n + 1)], [15. * j / across for j in range(across + 1)]),
                           lambda u, v: (u, v))
    boundary = ["*BOUNDARY"] + ["%d, 2, 2" % node for (i, j), node in ids.items() if j == 0]
    boundary += ["%d, 1, 1" % node for (i, j), node in ids.items() if i == 0]
    faces = job.tool("TOOL", [(3. * k, 15.) for k in range(9)], 2.)
    slaves = [(cells[c, across - 1], "S3") for c in range(n)]
    if friction:
        slaves += [(cells[n - 1, c], "S2") for c in range(across // 2, across)]
    boundary += ["TOOL, 1, 1, 0.", "TOOL, 2, 2, %g" % -travel]
    table = [(0., 700.), (3., 1600.)]  # linear; CalculiX takes five times as long with 300 points as with 2
    # p = 1e3: a penetration of 1e-4
    return "\n".join(job.header() + material("M", 200e3, .3, table) + material("T", 200e3, .3) +
                     surface("SLAVE", slaves) + surface("MASTER", faces) +
                     ["*SOLID SECTION, ELSET=EB, MATERIAL=M", "*SOLID SECTION, ELSET=ETOOL, MATERIAL=T"] +
                     contact("C", "SLAVE", "MASTER", 1e7, friction, 1e6) +
                     step(boundary, min(.01, largest), largest, nlgeom=True, prints=["TOOL"])) + "\n"


def arc(centre, radius, start, end, n):
    return [(centre[0] + radius * math.cos(start + (end - start) * k / n),
             centre[1] + radius * math.sin(start + (end - start) * k / n)) for k in range(n + 1)]


def cup(n, across, kind, travel, stiffness=1e5, pairing="SURFACE TO SURFACE", first=.002):
    """prm/cup_solid.prm: punch 1, throat 1.0625, profile radius .25, holder at a gap of 1.05 thicknesses, friction .2."""
    job, h = Job(), .035
    ids, cells = job.block("B", kind, ([2.22 * i / n for i in range(n + 1)], [h * (j / across - .5) for j in range(across + 1)]),
                           lambda u, v: (u, v))
    boundary = ["*BOUNDARY"] + ["%d, 1, 1" % node for (i, j), node in ids.items() if i == 0]
    right = math.pi / 2
    punch = job.tool("PUNCH", arc((0., 1. + h / 2), 1., -right, -.05, 300), .1)
    corner = (1.0625 + .25, -h / 2 - .25)
    die = job.tool("DIE", [(2.6, -h / 2), (1.8, -h / 2)] + arc(corner, .25, right, 2 * right, 200) +
                   [(1.0625, -h / 2 - .5), (1.0625, -h / 2 - 1.2)], .1)
    low = -h / 2 + 1.05 * h
    holder = job.tool("HOLDER", [(1.0625, low), (1.5, low), (2.0, low), (2.6, low)], .1)
    for name in ("PUNCH", "DIE", "HOLDER"):
        boundary += ["%s, 1, 1, 0." % name, "%s, 2, 2, %.6g" % (name, -travel if name == "PUNCH" else 0.)]
    top, bottom = [(cells[c, across - 1], "S3") for c in range(n)], [(cells[c, 0], "S1") for c in range(n)]
    strains = [0., 1e-4, 3e-4, 1e-3, 2e-3, 4e-3, 7e-3] + [.01 * k for k in range(1, 100)]
    table = [(e, 5.4 + min(27.8 * e ** .504, 24.4 * e ** .375)) for e in strains]
    lines = job.header() + material("M", 13393., .3, table) + material("T", 13393., .3)
    lines += surface("TOP", top) + surface("BOTTOM", bottom)
    lines += surface("SPUNCH", punch) + surface("SDIE", die) + surface("SHOLDER", holder)
    for name in ("PUNCH", "DIE", "HOLDER"):
        lines.append("*SOLID SECTION, ELSET=E%s, MATERIAL=T" % name)
    lines.append("*SOLID SECTION, ELSET=EB, MATERIAL=M")
    for name, slave in (("PUNCH", "TOP"), ("DIE", "BOTTOM"), ("HOLDER", "TOP")):
        lines += contact(name, slave, "S" + name, stiffness, .2, .1 * stiffness, pairing)
    return "\n".join(lines + step(boundary, first, .02 / travel if pairing.startswith("NODE") else .02, nlgeom=True, prints=["PUNCH"])) + "\n"
