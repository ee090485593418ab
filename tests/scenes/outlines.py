"""The distance of the deformed nodes to the outlines of the tools: p <= delta, from geometry alone.

Nothing is read of the penetrations that the program has measured. A node's penetration is half the thickness of the sheet (or
nothing, for a node of a solid's face) less its signed distance to the polyline of the tool in tools_*.csv. What this cannot know:

  - the polyline has chords of .02 rad: the arc behind a chord is known by its neighbours, to 1e-3 of its rise;
  - ten digits are printed: 1e-9 of the largest coordinate is allowed for;
  - a shell's contact sees the thickness of the increment before, the profile shows the new one: half of what the node's thickness
    can have changed since is allowed for (thickness_change() below): on a cup some ten delta;
  - on the axis a node of a solid of degree 2 has no share of the area, hence no contact: it is not judged;
  - a node past the free end of an outline touches nothing, and walls that go on for ever are cut off there;
  - the faces of a curved strip of solid, and its ends, are not in the profile: such a scene is skipped.
"""
import math

CHORD = .05  # radians; larger turns of a polyline are corners of the tool


class Outline:
    """A tool's polyline with the blank on its left, and the signed distance of points to the line or arc behind each chord."""

    def __init__(self, points, blank_on_left):
        kept = [points[0]] + [b for a, b in zip(points, points[1:]) if math.dist(a, b) > 0]
        self.points = kept if blank_on_left else kept[::-1]
        pairs = list(zip(self.points, self.points[1:]))
        self.lengths = [math.dist(a, b) for a, b in pairs]
        self.tangents = [((b[0] - a[0]) / c, (b[1] - a[1]) / c) for (a, b), c in zip(pairs, self.lengths)]
        self.closed = len(self.points) > 3 and math.dist(self.points[0], self.points[-1]) < 1e-9 * max(self.lengths)
        self.arcs = [self._arc(i) for i in range(len(pairs))]

    def _neighbour(self, i, step):
        """Number of the segment before or behind, or None at a free end."""
        k = i + step
        return k % len(self.tangents) if self.closed or 0 <= k < len(self.tangents) else None

    def _arc(self, i):
        """Angle of the arc behind a chord, positive if it is hollow, and how far it may be missed.

        The chords of an arc are equally long and turn by its share of the angle. A chord that has no such neighbour is a
        line, or an arc of one chord: then its rise is not known, and at most c theta/4 with half the angle at the joint.
        """
        angle, rise = 0., 0.
        for k in (self._neighbour(i, -1), self._neighbour(i, 1)):
            if k is None:
                continue
            (a, b), (c, d) = (self.tangents[j] for j in ((i, k) if k == i + 1 or k < i - 1 else (k, i)))
            turn = math.atan2(a * d - b * c, a * c + b * d)
            if abs(turn) > CHORD:
                continue
            if abs(self.lengths[i] - self.lengths[k]) < 1e-6 * self.lengths[i]:
                angle = turn
            rise = max(rise, min(self.lengths[i], self.lengths[k]) * abs(turn) / 4)
        return angle, 1e-3 * rise if angle else rise

    def distance(self, x):
        """Signed distance, positive on the blank's side, and by how much it may be wrong; (inf, 0) past a free end."""
        nearest, i, along = math.inf, 0, 0.
        for k, (a, t, c) in enumerate(zip(self.points, self.tangents, self.lengths)):
            s = (x[0] - a[0]) * t[0] + (x[1] - a[1]) * t[1]
            at = min(max(s, 0.), c)
            d = math.hypot(x[0] - a[0] - at * t[0], x[1] - a[1] - at * t[1])
            if d < nearest:
                nearest, i, along = d, k, s
        a, t, c = self.points[i], self.tangents[i], self.lengths[i]
        normal, at = (-t[1], t[0]), min(max(along, 0.), c)
        if along != at:  # the closest point is a joint
            k = self._neighbour(i, -1 if along < 0 else 1)
            end = self.points[i if along < 0 else i + 1]
            if k is None and abs(end[0]) > 1e-9 * max(self.lengths):
                return math.inf, 0.
            if k is not None:
                normal = (normal[0] - self.tangents[k][1], normal[1] + self.tangents[k][0])
        inside = (x[0] - a[0] - at * t[0]) * normal[0] + (x[1] - a[1] - at * t[1]) * normal[1] < 0
        angle, doubt = self.arcs[i]
        return (-nearest if inside else nearest) + angle * at * (c - at) / (2 * c), doubt


def of_table(run, table):
    """Outlines of a table tools_*.csv by the tool's name."""
    points, result = {}, {}
    for name, r, z in zip(table.column("tool"), table.column("r"), table.column("z")):
        points.setdefault(str(name), []).append((r, z))
    for tool in run.tools:
        if len(points.get(tool.name, ())) > 1:
            mirrored = tool.entries.get("Side") == "top" and tool.entries.get("Shape") != "profile"
            result[tool.name] = Outline(points[tool.name], not mirrored)
    return result


def _straight(profile):
    """Direction of the undeformed middle line, or None if it is not straight."""
    line = list(zip(profile.column("R0"), profile.column("Z0")))
    length = math.dist(line[0], line[-1])
    if not length > 0:
        return None
    t = ((line[-1][0] - line[0][0]) / length, (line[-1][1] - line[0][1]) / length)
    off = max(abs((x[1] - line[0][1]) * t[0] - (x[0] - line[0][0]) * t[1]) for x in line)
    return t if off < 1e-9 * length else None


def solid_nodes(run, profile):
    """Nodes of a solid's faces as (S0, current place, side or None); None if the profile does not hold them."""
    columns = [profile.column(name) for name in ("u_r_bottom", "u_z_bottom", "u_r_top", "u_z_top")]
    blank = run.scene["Blank"]
    if blank.get("Mesh") != "strip":
        return [(S, x, None) for S, x in zip(profile.column("S0"), zip(profile.column("r"), profile.column("z")))]
    t = _straight(profile)
    if t is None or blank.get("Contact bottom") != "bottom" or blank.get("Contact top") != "top":
        return None
    # Without area, see above.
    skip = {0.} if blank.get("Symmetry") == "axisymmetric" and blank.get("Degree") == "2" else set()
    result = []
    for k, (S, R, Z) in enumerate(zip(profile.column("S0"), profile.column("R0"), profile.column("Z0"))):
        if R in skip:
            continue
        half = .5 * profile.column("thickness")[k] / math.exp(profile.column("eps_thickness")[k])
        for side, sign, ur, uz in (("bottom", -1, columns[0][k], columns[1][k]), ("top", 1, columns[2][k], columns[3][k])):
            result.append((S, (R - sign * half * t[1] + ur, Z + sign * half * t[0] + uz), side))
    return result


def penetrations(run, label, profile, outlines, contact):
    """Of every node and tool: (tool, S0, penetration by geometry, tolerance)."""
    size = max(abs(x) for name in ("r", "z") for x in profile.column(name))
    solid = run.scene["Blank"].get("Kind") == "solid"
    if solid:
        nodes = [(S, x, 0., side) for S, x, side in solid_nodes(run, profile)]
    else:
        nodes = [(S, x, h, None) for S, x, h in zip(profile.column("S0"), zip(profile.column("r"), profile.column("z")),
                                                    profile.column("thickness"))]
    pressed = {(str(tool), S): p for tool, S, p in zip(contact.column("tool"), contact.column("S0"), contact.column("pressure"))}
    modulus = float(run.scene["Material"]["Young's modulus"])
    change = 0. if solid else thickness_change(run, profile)
    for tool in run.tools:
        if tool.name not in outlines:
            continue
        kind = tool.entries.get("Contact thickness", "current")
        given_way = kind == "initial" or run.scene["Blank"].get("Transverse normal stress") == "false"
        for S, x, h, side in nodes:
            if side not in (None, tool.entries.get("Side")):
                continue
            if kind == "initial" and not solid:
                h = float(run.scene["Blank"]["Thickness"])
            half = 0. if kind == "none" else .5 * h
            compressed = 0.
            if tool.entries.get("Thickness compliance") == "on" and given_way and not solid:
                compressed = .5 * h * pressed.get((tool.name, S), 0.) / modulus
            distance, doubt = outlines[tool.name].distance(x)
            # The table's pressure is over the new area.
            doubt += 1e-9 * size + (half if kind == "current" else compressed) * change
            yield tool.name, S, half - compressed - distance, doubt


def thickness_change(run, profile):
    """By how much a node's logarithmic thickness may have changed in the last increment before a table.

    Ten times what the thinnest point has lost in that increment, or what the most strained node loses on average: nodes of the shipped
    scenes change by at most twice that, on meshes that are far too coarse by up to six times.
    """
    row = run.row_of(profile)
    if row is None or row == 0:
        return .1
    thickness, time = run.history.column("min_thickness"), run.history.column("time")
    strain = max(map(abs, profile.column("eps_thickness")), default=0.)
    mean = strain * (time[row] - time[row - 1]) / time[row]
    return 10 * max(abs(math.log(thickness[row] / thickness[row - 1])), mean) + 1e-4


def check(run, report, promises):
    """Penetration by geometry: at most delta where the scene promises that, and what contact_*.csv says of the touching pairs."""
    profiles, contacts = run.tables("profile"), run.tables("contact")
    for label, table in run.tables("tools").items():
        profile, contact = profiles.get(label), contacts.get(label)
        if profile is None or contact is None:
            report.skipped.append(f"outlines: there is no profile_{label}.csv or contact_{label}.csv to tools_{label}.csv")
            continue
        if run.scene["Blank"].get("Kind") == "solid" and solid_nodes(run, profile) is None:
            report.skipped.append(f"outlines, {label}: the profile does not hold the faces of this strip (curved, or contact at its ends)")
            continue
        if run.scene["Blank"].get("Contact point") == "outer fibre":
            report.skipped.append(f"outlines, {label}: contact acts on the outer fibre, whose director the profile does not show")
            continue
        rows = zip(*(contact.column(name) for name in ("tool", "S0", "penetration", "delta")))
        said = {(str(tool), S): (p, delta) for tool, S, p, delta in rows}
        largest_delta = max(contact.column("delta"), default=0.)
        # Contact points inside the elements keep delta; between them, as at a node, the face may be half as deep again.
        inside = not set(contact.column("S0")) <= set(profile.column("S0"))
        face = 1.5 if inside and run.scene["Blank"].get("Kind") != "solid" else 1.
        judged = deepest = 0.
        for tool, S, own, tolerance in penetrations(run, label, profile, of_table(run, table), contact):
            p, delta = said.get((tool, S), (None, largest_delta))
            where = f"outlines, {label}: the node at S0 = {S:g} is {own:.6g} inside '{tool}' by the outline, "
            if promises and own > face * delta + tolerance:
                report.wrong.append(where + f"allowed are {face * delta:.6g} and {tolerance:.2g} of doubt")
            elif p is not None and abs(own - p) > tolerance:
                report.wrong.append(where + f"contact_{label}.csv says {p:.6g}, with {tolerance:.2g} of doubt")
            if own > -math.inf:
                judged, deepest = judged + 1, max(deepest, own)
        report.found.append(f"outlines, {label}: {judged:g} nodes against their tools, deepest {deepest:.3g}")
