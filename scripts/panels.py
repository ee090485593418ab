"""The panels of plot.py: each draws one question about some runs on given axes."""
import matplotlib.patheffects as effects
import numpy as np
from matplotlib import cm
from matplotlib.collections import PolyCollection
from matplotlib.colors import Normalize
from matplotlib.lines import Line2D

from results import labelled, nearest

# Okabe and Ito's colours, which the colour-blind tell apart.
TOOL_COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"]
RUN_COLOURS = ["#1b6ca8", "#d1495b", "#3a7d44", "#7b4fa3", "#c77f1e", "#444444"]
MARKERS = ["o", "s", "^", "D", "v", "P"]
STYLES = ["-", "--", ":", "-."]
NAMES = {
    "eps_thickness": "thickness strain",
    "eps_meridional": "meridional strain",
    "eps_hoop": "hoop strain",
    "equivalent_plastic_strain": "equivalent plastic strain",
}


def _spell(column):
    return NAMES.get(column, column.replace("_", " "))


def _legend(axis, handles=None, title=None):
    """Beside the axes, where it hides no curve."""
    handles = axis.get_legend_handles_labels()[0] if handles is None else handles
    if not handles:
        return
    legend = axis.legend(handles=handles, loc="upper left", bbox_to_anchor=(1.02, 1.0), title=title, alignment="left")
    legend.get_title().set_fontsize(8.5)


def _marker(values):
    """Few increments are points rather than a line."""
    return "o" if len(values) < 3 else None


def _nothing(axis, text):
    axis.set_axis_off()
    axis.text(0.5, 0.5, text, ha="center", va="center", color="#888888", transform=axis.transAxes)


def _colours(travels):
    """A colour for each travel, from light to dark."""
    shades = np.linspace(0.82, 0.0, len(travels)) if len(travels) > 1 else [0.3]
    return [cm.viridis(shade) for shade in shades]


def force(axis, runs, options):
    """Force of every tool over the travel of the main one; works and energies where there is no tool."""
    if not any(run.tools for run in runs):
        return energies(axis, runs, options)
    handles = []
    for number, run in enumerate(runs):
        abscissa, label = run.progress()
        for index, tool in enumerate(run.tools):
            colour = TOOL_COLOURS[index % len(TOOL_COLOURS)]
            for component in ["z"] if run.axisymmetric else ["z", "r"]:
                values = run.history[f"{tool}_force_{component}"]
                many = len(runs) > 1
                style = STYLES[number % len(STYLES)] if many else ("-" if component == "z" else "--")
                name = tool if run.axisymmetric else f"{tool}, {run.axes[component == 'z']}"
                line, = axis.plot(abscissa, values, style, color=colour, label=name, marker=_marker(values),
                                  alpha=0.5 if many and component == "r" else 1)
                if number == 0:
                    handles.append(line)
    if len(runs) > 1:
        handles += [Line2D([], [], color="#555555", linestyle=STYLES[i % len(STYLES)], label=run.name)
                    for i, run in enumerate(runs)]
    run = runs[0]
    axis.axhline(0, color="#777777", linewidth=0.8, zorder=1)
    axis.set_xlabel(label)
    axis.set_ylabel(labelled("force of the blank on the tool" + (f", {run.axes[1]}" if run.axisymmetric else ""),
                             run.history.unit(run.tools[0] + "_force_z")))
    axis.set_title("Tool forces" + (", full circumference" if run.axisymmetric else ", per unit width"))
    axis.margins(x=0.01)
    _legend(axis, handles)


def energies(axis, runs, _options):
    """Works and energies over time."""
    columns = ["tool_work", "load_work", "elastic_energy", "plastic_energy", "friction_energy"]
    handles = []
    for number, run in enumerate(runs):
        abscissa, label = run.progress()
        asked = [name for name in columns if name in run.history and np.any(run.history[name] != 0)]
        for index, column in enumerate(asked):
            line, = axis.plot(abscissa, run.history[column], STYLES[number % len(STYLES)],
                              color=TOOL_COLOURS[index % len(TOOL_COLOURS)], label=_spell(column),
                              marker=_marker(abscissa))
            if number == 0:
                handles.append(line)
    axis.set_xlabel(label)
    axis.set_ylabel(labelled("energy", runs[0].history.unit("load_work")))
    axis.set_title("Work and energy" + (", full circumference" if runs[0].axisymmetric else ", per unit width"))
    axis.margins(x=0.01)
    _legend(axis, handles)


def profile(axis, runs, options):
    """A quantity along the blank: at every travel for one run, at one travel for several."""
    if not any(run.profiles for run in runs):
        return _nothing(axis, "no profile_*.csv")
    column = options.quantity
    for number, run in enumerate(runs):
        if not run.profiles:
            continue
        if len(runs) == 1:
            for (travel, table), colour in zip(run.profiles.items(), _colours(run.profiles)):
                axis.plot(table["R0"], table[column], color=colour, label=f"{travel:g}")
        else:
            travel, table = nearest(run.profiles, options.travel)
            axis.plot(table["R0"], table[column], color=RUN_COLOURS[number % len(RUN_COLOURS)],
                      label=f"{run.name}, {travel:g}")
    axis.axhline(0, color="#777777", linewidth=0.8, zorder=1)
    axis.set_xlabel(labelled("initial position along the blank $R_0$", table.unit("R0")))
    axis.set_ylabel(labelled(_spell(column), table.unit(column)))
    axis.set_title(_spell(column).capitalize() + " along the blank")
    axis.margins(x=0.01)
    title = labelled("travel", run.length_unit) if runs[0].main_tool else "time"
    _legend(axis, title=title if len(runs) == 1 else "run, " + title)


def penetration(axis, runs, options):
    """Penetration over the allowed one at each touching node."""
    found = [(run, *nearest(run.contacts, options.travel)) for run in runs]
    found = [(run, travel, table) for run, travel, table in found if table is not None and len(table)]
    if not found:
        return _nothing(axis, "no contact")
    handles, largest = {}, []
    for number, (run, travel, table) in enumerate(found):
        highest = 0.
        for tool in dict.fromkeys(table["tool"]):
            index = run.tools.index(tool) if tool in run.tools else len(run.tools)
            colours = TOOL_COLOURS if len(found) == 1 else RUN_COLOURS
            colour = colours[(index if len(found) == 1 else number) % len(colours)]
            chosen = table["tool"] == tool
            ratio = table["penetration"][chosen] / table["delta"][chosen]
            highest = max(highest, ratio.max())
            axis.plot(table["R0"][chosen], ratio, MARKERS[index % len(MARKERS)], markersize=4.5, color=colour,
                      markeredgecolor="white", markeredgewidth=0.5)
            name = tool if len(found) == 1 else f"{run.name}, {travel:g}: {tool}"
            handles[name] = Line2D([], [], linestyle="", marker=MARKERS[index % len(MARKERS)], color=colour,
                                   markeredgecolor="white", markeredgewidth=0.5, markersize=6.5, label=name)
        largest.append(max(highest, 1e-12))
    axis.axhline(1, color="#b00020", linewidth=1.2, linestyle=(0, (5, 3)), zorder=1)
    handles["allowed"] = Line2D([], [], color="#b00020", linewidth=1.2, linestyle=(0, (5, 3)), label="allowed")
    low, high = min(largest), max(1., *largest)
    if high > 5 or low < 0.05 * high:
        axis.set_yscale("log")
        axis.set_ylim(0.03 * low, 2 * high)
    else:
        axis.set_ylim(-0.02 * high, 1.08 * high)
    end = max((table["R0"].max() for run in runs for table in run.profiles.values()), default=axis.get_xlim()[1])
    start = min((table["R0"].min() for run in runs for table in run.profiles.values()), default=0)
    axis.set_xlim(start - 0.01 * (end - start), end + 0.01 * (end - start))
    axis.set_xlabel(labelled("initial position along the blank $R_0$", found[0][2].unit("R0")))
    axis.set_ylabel(r"penetration / allowed penetration $\delta$")
    at = f" at travel {found[0][1]:g} {found[0][0].length_unit}" if len(found) == 1 and found[0][0].main_tool else ""
    axis.set_title("Penetration of the touching nodes" + at)
    _legend(axis, list(handles.values()))


def _faces(table):
    """Points of the two faces of the blank: its mid-line, plus and minus half the thickness along the normal."""
    points = np.column_stack([table["r"], table["z"]])
    tangent = np.gradient(points, axis=0)
    tangent /= np.linalg.norm(tangent, axis=1)[:, None]
    offset = 0.5 * table["thickness"][:, None] * np.column_stack([-tangent[:, 1], tangent[:, 0]])
    return points - offset, points + offset


def _outlines(table):
    """The tools' polylines: name and points. A tool that touches both faces of the blank is listed twice."""
    points, names = np.column_stack([table["r"], table["z"]]), table["tool"]

    def same(i, j):
        return j < len(table) and names[i] == names[j] and np.array_equal(points[i], points[j])

    start = 0
    for i in range(1, len(table) + 1):
        ends = i == len(table) or names[i] != names[start] or (same(start, i) and same(start + 1, i + 1))
        closes = not ends and i > start + 1 and same(start, i)
        if ends or closes:
            if i + closes - start > 1:
                yield names[start], points[start:i + closes]
            start = i + (closes and i + 1 < len(table))


def _colour_strips(axis, strips, values, label):
    """The elements in the colours of a value at the nodes, with the scale beside the axes."""
    collection = PolyCollection(strips, cmap="plasma", norm=Normalize(0, values.max()), zorder=3)
    collection.set_array(0.5 * (values[:-1] + values[1:]))
    collection.set_edgecolor("face")
    collection.set_linewidth(0.6)
    axis.add_collection(collection)
    bar = axis.figure.colorbar(collection, cax=axis.inset_axes([1.03, 0, 0.025, 1]))
    bar.set_label(label)
    bar.outline.set_visible(False)


def section(axis, runs, options):
    """The deformed blank with its thickness, coloured by plastic strain, and the tools."""
    found = [(run, *nearest(run.profiles, options.travel)) for run in runs if run.profiles]
    if not found:
        return _nothing(axis, "no profile_*.csv")
    handles, corners = [], []
    for number, (run, travel, table) in enumerate(found):
        bottom, top = _faces(table)
        corners += [bottom, top]
        colour = RUN_COLOURS[number % len(RUN_COLOURS)]
        strips = np.stack([bottom[:-1], bottom[1:], top[1:], top[:-1]], axis=1)
        if len(found) == 1 and table["equivalent_plastic_strain"].max() > 1e-9:
            _colour_strips(axis, strips, table["equivalent_plastic_strain"], "equivalent plastic strain")
        else:
            axis.add_collection(PolyCollection(strips, facecolor=colour, edgecolor=colour, linewidth=0.4, alpha=0.75,
                                               zorder=3 + number))
            if len(found) > 1:
                handles.append(Line2D([], [], color=colour, linewidth=3, label=f"{run.name}, {travel:g}"))

    corners = np.concatenate(corners)
    run, travel, table = found[0]
    _frame(axis, corners, run.axisymmetric)
    if travel in run.outlines:
        outlines = list(_outlines(run.outlines[travel]))
        for _, points in outlines:
            axis.plot(points[:, 0], points[:, 1], color="#2b2b2b", linewidth=2, zorder=2, solid_joinstyle="round")
        _name_tools(axis, outlines, corners)
    if run.axisymmetric:
        axis.axvline(0, color="#999999", linewidth=0.9, linestyle=(0, (12, 3, 2, 3)), zorder=1, clip_on=False)
    axis.set_xlabel(labelled(f"${run.axes[0]}$", table.unit("r")))
    axis.set_ylabel(labelled(f"${run.axes[1]}$", table.unit("z")))
    unit = f" {run.length_unit}" if run.main_tool else ""
    axis.set_title(f"Section at {'travel' if run.main_tool else 'time'} {travel:g}{unit}")
    _legend(axis, handles)


def _frame(axis, points, axisymmetric):
    """Limits around the blank that leave room for the tools."""
    low, high = points.min(axis=0), points.max(axis=0)
    if axisymmetric:
        low[0] = 0.
    margin = 0.12 * max(high - low)
    left = 0.2 * margin if axisymmetric else margin
    width = high[0] - low[0] + left + margin
    height = max(high[1] - low[1] + 2 * margin, 0.6 * width)
    middle = 0.5 * (low[1] + high[1])
    axis.set_aspect("equal")
    axis.set_xlim(low[0] - left, high[0] + margin)
    axis.set_ylim(middle - 0.5 * height, middle + 0.5 * height)


def _name_tools(axis, outlines, blank):
    """Each tool's name once, beside its line, where it is farthest from everything else."""
    low, high = np.transpose([axis.get_xlim(), axis.get_ylim()])
    lines = {name: _visible(points, low, high) for name, points in outlines}
    stretch = np.array([0.4, 1.])  # names are wider than high
    distance = 0.055 * (high - low)[1]
    taken = [blank, *lines.values()]
    for name, points in lines.items():
        if len(points) < 2:
            continue
        tangent = np.gradient(points, axis=0)
        tangent /= np.maximum(np.linalg.norm(tangent, axis=1), 1e-300)[:, None]
        normal = np.column_stack([-tangent[:, 1], tangent[:, 0]]) * distance / stretch
        places = np.concatenate([points + normal, points - normal])
        room = np.minimum((places - low).min(axis=1), (high - places).min(axis=1))
        others = np.concatenate(taken)
        near = np.array([np.linalg.norm((others - place) * stretch, axis=1).min() for place in places])
        # A name needs its distance and no more; the middle of what is seen is the natural place.
        score = np.minimum(near, 0.95 * distance) + np.minimum(room, 1.6 * distance)
        from_middle = np.abs(np.tile(np.linspace(-1, 1, len(points)), 2))
        x, y = places[np.argmax(score - 0.1 * distance * from_middle)]
        axis.text(x, y, name, ha="center", va="center", fontsize=8.5, color="#2b2b2b", zorder=5,
                  path_effects=[effects.withStroke(linewidth=3, foreground="white")])
        taken.append(np.array([[x, y]]))


def _visible(points, low, high):
    """Many points of a polyline within the frame."""
    if len(points) < 2:
        return points
    length = np.concatenate([[0.], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    at = np.linspace(0, length[-1], 600)
    fine = np.column_stack([np.interp(at, length, points[:, k]) for k in range(2)])
    return fine[np.all((fine > low) & (fine < high), axis=1)]


PANELS = {"force": force, "profile": profile, "penetration": penetration, "section": section, "energy": energies}
