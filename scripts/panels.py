"""The panels of plot.py: each draws one question about some runs on given axes."""
import matplotlib.patheffects as effects
import numpy as np
from matplotlib import cm
from matplotlib.collections import PolyCollection
from matplotlib.colors import Normalize
from matplotlib.lines import Line2D

from results import labelled
from sections import section_of

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


def _colours(n):
    """A colour for each of some states, from light to dark."""
    shades = np.linspace(0.82, 0.0, n) if n > 1 else [0.3]
    return [cm.viridis(shade) for shade in shades]


def _parts(axis, runs):
    """The axes of forces: over travel where the main tool moves, over time where it rests; side by side where it does both.

    Each with the name of what it is drawn over and a function that gives a run's abscissa and rows.
    """
    moving = [run.moving() for run in runs]
    some_move = any(rows.any() for rows in moving)
    some_rest = any(not rows.all() for rows in moving)
    tool = next((run.main_tool for run in runs if run.main_tool), None)

    def over_travel(run):
        return (run.history[run.main_tool + "_travel"], run.moving()) if run.main_tool else (run.history["time"], run.moving())

    def over_time(run):
        rows = ~run.moving()
        # From the last row before, so that what falls at once is seen to fall.
        rows[:-1] |= rows[1:] & run.moving()[:-1]
        return run.history["time"], rows

    travel = (labelled(f"{tool} travel", runs[0].history.unit(f"{tool}_travel")) if tool else "", over_travel)
    time = (labelled("time", runs[0].time_unit), over_time)
    if not (some_move and some_rest):
        return [(axis, *(travel if some_move else time))]
    axis.set_axis_off()
    left, right = axis.inset_axes([0, 0, 0.58, 1]), axis.inset_axes([0.64, 0, 0.36, 1])
    right.sharey(left)
    right.tick_params(labelleft=False)
    return [(left, *travel), (right, *time)]


def _mark_stages(axis, run, rows):
    """Where stages end, over time."""
    stages, time = run.history.words("stage"), run.history["time"]
    seen = [i for i in np.flatnonzero(rows)]
    for i in seen:
        if i + 1 < len(stages) and stages[i] != stages[i + 1] and i + 1 in seen:
            axis.axvline(time[i], color="#999999", linewidth=0.8, linestyle=(0, (4, 3)), zorder=1)
            axis.annotate(stages[i + 1], (time[i], 1), (4, -4), xycoords=("data", "axes fraction"), textcoords="offset points",
                          va="top", fontsize=8, color="#666666")


def _components(run, tool):
    """Directions in which the force of a tool is shown: z, and r where that is all there is, or in plane strain."""
    if not run.axisymmetric:
        return ["z", "r"]
    z, r = (np.abs(run.history[f"{tool}_force_{component}"]).max() for component in "zr")
    return ["r"] if z < 1e-6 * r else ["z"]


def force(axis, runs, options):
    """Force of every tool over the travel of the main one, and over time where that rests; energies where there is no tool."""
    if not any(run.tools for run in runs):
        return energies(axis, runs, options)
    handles, many = {}, len(runs) > 1
    parts = _parts(axis, runs)
    for part, label, abscissa in parts:
        for number, run in enumerate(runs):
            x, rows = abscissa(run)
            if not rows.any():
                continue
            for index, tool in enumerate(run.tools):
                colour = TOOL_COLOURS[index % len(TOOL_COLOURS)]
                for component in _components(run, tool):
                    values = run.history[f"{tool}_force_{component}"]
                    style = STYLES[number % len(STYLES)] if many else ("-" if component == "z" else "--")
                    name = tool if run.axisymmetric and component == "z" else f"{tool}, {run.axes[component == 'z']}"
                    line, = part.plot(x[rows], values[rows], style, color=colour, label=name, marker=_marker(values[rows]),
                                      alpha=0.5 if many and component == "r" else 1)
                    if number == 0:
                        handles.setdefault(name, line)
            if not many and label.startswith("time"):
                _mark_stages(part, run, rows)
        part.axhline(0, color="#777777", linewidth=0.8, zorder=1)
        part.set_xlabel(label)
        part.margins(x=0.01)
    handles = list(handles.values())
    if many:
        handles += [Line2D([], [], color="#555555", linestyle=STYLES[i % len(STYLES)], label=run.name)
                    for i, run in enumerate(runs)]
    run, first = runs[0], parts[0][0]
    first.set_ylabel(labelled("force of the blank on the tool" + (f", {run.axes[_components(run, run.tools[0]) == ['z']]}" if run.axisymmetric else ""),
                              run.force_unit(run.tools[0] + "_force_z")))
    first.set_title("Tool forces" + (", full circumference" if run.axisymmetric else ", per unit width"))
    _legend(parts[-1][0], handles)


def energies(axis, runs, _options):
    """Works and energies over travel, or over time where the main tool rests in a stage."""
    columns = ["tool_work", "load_work", "elastic_energy", "plastic_energy", "friction_energy"]
    handles = []
    over_travel = all(run.moving().all() for run in runs)
    for number, run in enumerate(runs):
        abscissa = run.history[run.main_tool + "_travel"] if over_travel else run.history["time"]
        asked = [name for name in columns if name in run.history and np.any(run.history[name] != 0)]
        for index, column in enumerate(asked):
            line, = axis.plot(abscissa, run.history[column], STYLES[number % len(STYLES)],
                              color=TOOL_COLOURS[index % len(TOOL_COLOURS)], label=_spell(column),
                              marker=_marker(abscissa))
            if number == 0:
                handles.append(line)
        if not over_travel and len(runs) == 1:
            _mark_stages(axis, run, np.ones(len(abscissa), dtype=bool))
    run = runs[0]
    if not handles:
        return _nothing(axis, "no energies (Output/Energies = false)")
    axis.set_xlabel(labelled(f"{run.main_tool} travel", run.length_unit) if over_travel else labelled("time", run.time_unit))
    axis.set_ylabel(labelled("energy", run.force_unit("load_work")))
    axis.set_title("Work and energy" + (", full circumference" if run.axisymmetric else ", per unit width"))
    axis.margins(x=0.01)
    _legend(axis, handles)


def _place(runs):
    """The column that tells the blank's nodes apart, and its label: R0, or S0 where a part of the blank is steep (tubes, walls)."""
    for run in runs:
        for state in run.states:
            if "S0" in state.profile and np.any(np.abs(np.diff(state.profile["R0"])) < 0.1 * np.diff(state.profile["S0"])):
                return "S0", "initial arc length along the blank $S_0$"
    return "R0", "initial position along the blank $R_0$"


def profile(axis, runs, options):
    """A quantity along the blank: of one run in every state, of several in the last state of each stage."""
    if not any(run.states for run in runs):
        return _nothing(axis, "no profile_*.csv")
    column = options.quantity
    place, place_label = _place(runs)
    for number, run in enumerate(runs):
        states = run.states if len(runs) == 1 else run.last_states(options.travel)
        for k, state in enumerate(states):
            colour = _colours(len(states))[k] if len(runs) == 1 else RUN_COLOURS[number % len(RUN_COLOURS)]
            table, label = state.profile, run.label(state)
            axis.plot(table[place], table[column], "-" if len(runs) == 1 else STYLES[(len(states) - 1 - k) % len(STYLES)],
                      color=colour, label=label if len(runs) == 1 else f"{run.name}, {label}")
    axis.axhline(0, color="#777777", linewidth=0.8, zorder=1)
    axis.set_xlabel(labelled(place_label, table.unit(place)))
    axis.set_ylabel(labelled(_spell(column), table.unit(column)))
    axis.set_title(_spell(column).capitalize() + " along the blank")
    axis.margins(x=0.01)
    if table.unit(column) == "":
        low, high = axis.get_ylim()
        if high - low < 1e-6:  # round-off is no result
            axis.set_ylim(-1e-3, 1e-3)
    title = "time" if runs[0].states[0].by_time else labelled("travel", run.length_unit)
    title += ", stage" if any(run.several_stages() for run in runs) else ""
    _legend(axis, title=title if len(runs) == 1 else "run, " + title)


def _touching(run, travel):
    """The last state with a touching node, or the one that is asked for; None if nothing touches."""
    states = run.last_states(travel) if travel is not None else run.states
    return next((state for state in reversed(states) if state.contact is not None and len(state.contact)), None)


def penetration(axis, runs, options):
    """Penetration over the allowed one at each touching node."""
    found = [(run, _touching(run, options.travel)) for run in runs]
    found = [(run, state) for run, state in found if state is not None]
    if not found:
        return _nothing(axis, "no contact")
    handles, largest = {}, []
    place, place_label = _place([run for run, _ in found])
    for number, (run, state) in enumerate(found):
        highest, table, names = 0., state.contact, np.array(state.contact.words("tool"))
        for tool in dict.fromkeys(names):
            column = tool.replace(" ", "_")
            index = run.tools.index(column) if column in run.tools else len(run.tools)
            colours = TOOL_COLOURS if len(found) == 1 else RUN_COLOURS
            colour = colours[(index if len(found) == 1 else number) % len(colours)]
            chosen = names == tool
            ratio = table["penetration"][chosen] / table["delta"][chosen]
            highest = max(highest, ratio.max())
            axis.plot(table[place][chosen], ratio, MARKERS[index % len(MARKERS)], markersize=4.5, color=colour,
                      markeredgecolor="white", markeredgewidth=0.5)
            name = tool if len(found) == 1 else f"{run.name}, {run.label(state)}: {tool}"
            handles[name] = Line2D([], [], linestyle="", marker=MARKERS[index % len(MARKERS)], color=colour,
                                   markeredgecolor="white", markeredgewidth=0.5, markersize=6.5, label=name)
        largest.append(max(highest, 1e-12))
    axis.axhline(1, color="#b00020", linewidth=1.2, linestyle=(0, (5, 3)), zorder=1)
    handles["allowed"] = Line2D([], [], color="#b00020", linewidth=1.2, linestyle=(0, (5, 3)), label="allowed")
    low, high = min(largest), max(1., *largest)
    if max(largest) > 1e-9 and (high > 5 or low < 0.05 * high):
        axis.set_yscale("log")
        axis.set_ylim(0.03 * low, 2 * high)
    else:
        axis.set_ylim(-0.02 * high, 1.08 * high)
    nodes = np.concatenate([state.profile[place] for run, _ in found for state in run.states])
    low, high, margin = nodes.min(), nodes.max(), 0.01 * np.ptp(nodes)
    touching = np.concatenate([state.contact[place] for _, state in found])
    if np.ptp(touching) < 0.15 * (high - low):  # a small patch fills the axes
        around = max(np.ptp(touching), 0.02 * (high - low))
        low, high = max(low, touching.min() - around), min(high, touching.max() + around)
    axis.set_xlim(low - margin, high + margin)
    axis.set_xlabel(labelled(place_label, found[0][1].contact.unit(place)))
    axis.set_ylabel(r"penetration / allowed penetration $\delta$")
    run, state = found[0]
    at = f" at {_moment(run, state)}" if len(found) == 1 else ""
    axis.set_title("Penetration of the touching points" + at)
    _legend(axis, list(handles.values()))


def _moment(run, state):
    """ "travel 15 mm, stage form"."""
    text = f"time {state.time:g}" if state.by_time else f"travel {state.travel:g} {run.length_unit}"
    return f"{text}, stage {state.stage}" if run.several_stages() else text


def _outlines(table):
    """The tools' polylines: name and points. A tool that touches both faces of the blank is listed twice."""
    points, names = np.column_stack([table["r"], table["z"]]), table.words("tool")

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


def _colour_cells(axis, section):
    """The cells in the colours of their values, with the scale beside the axes."""
    collection = PolyCollection(section.cells, cmap="plasma", norm=Normalize(0, section.values.max()), zorder=3)
    collection.set_array(section.values)
    collection.set_edgecolor("face")
    collection.set_linewidth(0.6)
    axis.add_collection(collection)
    bar = axis.figure.colorbar(collection, cax=axis.inset_axes([1.03, 0, 0.025, 1]))
    bar.set_label(section.label)
    bar.outline.set_visible(False)


def _plain_cells(axis, section, colour, alpha, zorder):
    """The cells in one colour."""
    axis.add_collection(PolyCollection(section.cells, facecolor=colour, edgecolor=colour, linewidth=0.4, alpha=alpha, zorder=zorder))


def section(axis, runs, options):
    """The deformed blank at the end of every stage, the last one coloured by plastic strain, and the tools."""
    found = [(number, run, state, section_of(run, state)) for number, run in enumerate(runs)
             for state in run.last_states(options.travel)]
    found = [item for item in found if item[-1] is not None]
    if not found:
        return _nothing(axis, "no profile_*.csv, or a solid without pictures")
    handles, earlier = [], ["#6fa8dc", "#93c47d", "#c9a0dc"]
    for k, (number, run, state, shape) in enumerate(found):
        last = k + 1 == len(found)
        if len(runs) == 1 and last and shape.values is not None and shape.values.max() > 1e-9:
            _colour_cells(axis, shape)
            continue
        own = [item for item in found if item[0] == number]
        is_end = own[-1][2] is state
        colour = RUN_COLOURS[number % len(RUN_COLOURS)] if is_end or len(runs) > 1 else earlier[k % len(earlier)]
        _plain_cells(axis, shape, colour, 0.75 if is_end or len(runs) == 1 else 0.4, 3 + number if is_end else 2.5)
        if len(found) > 1:
            name = f"{run.name}, {run.label(state)}" if len(runs) > 1 else f"end of stage {state.stage}"
            handles.append(Line2D([], [], color=colour, linewidth=3, alpha=0.75 if is_end or len(runs) == 1 else 0.4, label=name))

    _, run, state, shape = found[-1]
    corners = np.concatenate([item[-1].points for item in found])
    _frame(axis, corners, run.axisymmetric)
    _draw_tools(axis, runs[0], [item[2] for item in found if item[1] is runs[0]], corners)
    if run.axisymmetric and axis.get_xlim()[0] <= 0:
        axis.axvline(0, color="#999999", linewidth=0.9, linestyle=(0, (12, 3, 2, 3)), zorder=1, clip_on=False)
    axis.set_xlabel(labelled(f"${run.axes[0]}$", state.profile.unit("r")))
    axis.set_ylabel(labelled(f"${run.axes[1]}$", state.profile.unit("z")))
    at = _moment(run, state) if len(runs) == 1 else "the end"
    axis.set_title(f"Section at {at}" if shape.time is None or len(runs) > 1 else f"Section, picture at time {shape.time:g}")
    if handles:
        # Beneath the scale of colours there is no room beside the axes.
        axis.legend(handles=handles, loc="lower right", frameon=True, framealpha=0.85, edgecolor="none")


def _draw_tools(axis, run, states, corners):
    """Outlines of the tools in the last state that has any; in the state of an earlier stage they are lighter."""
    with_tools = [state for state in states if state.outlines is not None and len(state.outlines)]
    if not with_tools:
        return
    state = with_tools[-1]
    outlines = list(_outlines(state.outlines))
    for _, points in outlines:
        axis.plot(points[:, 0], points[:, 1], color="#2b2b2b" if state is states[-1] else "#7a7a7a", linewidth=2, zorder=2,
                  solid_joinstyle="round")
    _name_tools(axis, outlines, corners)


def _frame(axis, points, axisymmetric):
    """Limits around the blank that leave room for the tools."""
    low, high = points.min(axis=0), points.max(axis=0)
    axisymmetric = axisymmetric and low[0] < 4 * max(high - low)  # else the blank would be a dot far from the axis
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
