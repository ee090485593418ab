"use strict";
// The page of a report: unpacks data and library, draws. Data: scripts/report_page/data.py.

const TOOL_COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"];
const DASHES = ["solid", "dash", "dot", "dashdot", "longdash"];
const RUN_COLOURS = ["#1b6ca8", "#d1495b", "#3a7d44", "#7b4fa3", "#c77f1e", "#444444"];
// Plasma of matplotlib (CC0).
const SCALE = ["#0d0887", "#4c02a1", "#7e03a8", "#a92395", "#cc4778", "#e56b5d", "#f89540", "#fdc527", "#f0f921"];
const N_COLOURS = 32;
const CONFIG = {responsive: true, displaylogo: false, modeBarButtonsToRemove: ["select2d", "lasso2d"]};
const element = id => document.getElementById(id);
const several = () => runs.length > 1;
let runs = [];

async function unpacked(id) {
  const bytes = Uint8Array.from(atob(element(id).textContent), letter => letter.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).text();
}

function node(tag, text, name) {
  const result = document.createElement(tag);
  if (text !== undefined) result.textContent = text;
  if (name) result.className = name;
  return result;
}

function fill(select, choices, chosen) {
  select.replaceChildren(...choices.map(([value, text]) => Object.assign(node("option", text), {value})));
  if (chosen !== undefined) select.value = chosen;
}

function layout(x, y, more = {}) {
  return Object.assign({
    margin: {l: 62, r: 14, t: 26, b: 44}, font: {family: "system-ui, DejaVu Sans, sans-serif", size: 12},
    xaxis: {title: {text: x}, zeroline: false, gridcolor: "#e8ecf1"},
    yaxis: {title: {text: y}, zeroline: true, zerolinecolor: "#b9c2cc", gridcolor: "#e8ecf1"},
    legend: {orientation: "h", x: 0, y: 1.02, yanchor: "bottom"}, hovermode: "closest", plot_bgcolor: "white", paper_bgcolor: "white"
  }, more);
}

const labelled = (text, unit) => unit && unit !== "1" && unit !== "-" ? `${text} [${unit.replace("*", " ")}]` : text;
const short = value => value === null || value === undefined ? "-" : typeof value === "number" ? String(+value.toPrecision(4)) : value;
const words = name => name.replaceAll("_", " ");

// In plane strain forces are per unit width.
function unitOf(run, column) {
  const unit = run.history.units[column];
  const length = run.main_tool && run.history.units[run.main_tool + "_travel"];
  return run.axisymmetric || !length ? unit : `${unit}/${length}`;
}

function header() {
  const titles = [...new Set(runs.map(run => run.title))];
  document.title = titles.join(" / ");
  element("title").textContent = titles.join(" / ");
  const summary = runs[0].summary || {};
  element("subtitle").textContent = [summary.version && `deltaform ${summary.version}`, summary.units && `units ${summary.units}`,
    runs[0].axisymmetric ? "axisymmetric: forces are of the full circumference" : "plane strain: forces are per unit width",
    "forces are those of the blank on the tool"].filter(Boolean).join("; ");
  for (const run of runs) {
    const name = several() ? run.name + ": " : "";
    if (!run.summary) element("messages").append(node("p", `${name}there is no summary.json: the run was killed, or still runs`, "message bad"));
    else if (run.summary.message) element("messages").append(node("p", `${name}${run.summary.outcome}: ${run.summary.message}`, "message bad"));
    for (const text of run.summary ? run.summary.warnings : [])
      if (text !== run.summary.message) element("messages").append(node("p", `${name}Warning: ${text}`, "message"));
  }
  const table = node("table"), head = node("tr");
  const kinds = [["run", run => run.name], ["outcome", run => (run.summary || {}).outcome],
    ["force of the main tool", run => { const tool = ((run.summary || {}).tools || {})[run.main_tool]; return tool && short(tool.force_z); }],
    ["travel", run => { const tool = ((run.summary || {}).tools || {})[run.main_tool]; return tool && short(tool.travel); }],
    ["thinnest", run => short((run.summary || {}).min_thickness)], ["p/delta", run => short((run.summary || {}).max_penetration_over_delta)],
    ["error of energies", run => short((run.summary || {}).energy_error)], ["increments", run => short((run.summary || {}).increments)],
    ["cut back", run => short((run.summary || {}).cutbacks)], ["Newton iterations", run => short((run.summary || {}).newton_iterations)],
    ["seconds", run => short((run.summary || {}).seconds)]];
  for (const [name] of kinds) head.append(node("th", name));
  table.append(head);
  for (const run of runs) {
    const row = node("tr");
    kinds.forEach(([kind, value], i) => {
      const text = value(run);
      row.append(node("td", text === undefined ? "-" : text, i === 0 ? "name" : kind === "outcome" ? (text === "done" ? "good" : "bad") : ""));
    });
    table.append(row);
  }
  element("cards").append(table);
}

// The section: polygons of one colour are one trace, so that a picture is quick to draw.
const film = {run: 0, timer: null};

function colourOf(share) {
  const place = Math.min(Math.max(share, 0), 1) * (SCALE.length - 1), low = Math.min(Math.floor(place), SCALE.length - 2);
  const part = at => [1, 3, 5].map(i => parseInt(SCALE[at].slice(i, i + 2), 16));
  const [a, b] = [part(low), part(low + 1)];
  return `rgb(${a.map((value, i) => Math.round(value + (b[i] - value) * (place - low))).join(",")})`;
}

function rangeOf(frames, field) {
  let low = Infinity, high = -Infinity;
  for (const frame of frames)
    for (const value of frame.values[field] || [])
      if (value !== null) { low = Math.min(low, value); high = Math.max(high, value); }
  if (!(low <= high)) return [0, 1];
  return low < high ? [low, high] : [low - 1e-9 * (Math.abs(low) || 1), high + 1e-9 * (Math.abs(high) || 1)];
}

function polygons(frame, values, [low, high], mirrored) {
  const traces = [];
  for (let bin = 0; bin < N_COLOURS; ++bin) traces.push({x: [], y: []});
  const centres = {x: [], y: [], values: []};
  for (let cell = 0; cell < frame.cells.length / 4; ++cell) {
    const value = values ? values[cell] : null;
    const bin = value === null ? 0 : Math.min(N_COLOURS - 1, Math.max(0, Math.floor((value - low) / (high - low) * N_COLOURS)));
    const corners = frame.cells.slice(4 * cell, 4 * cell + 4);
    for (const side of mirrored ? [1, -1] : [1]) {
      for (const corner of [...corners, corners[0]]) { traces[bin].x.push(side * frame.r[corner]); traces[bin].y.push(frame.z[corner]); }
      traces[bin].x.push(null); traces[bin].y.push(null);
    }
    centres.x.push(corners.reduce((sum, corner) => sum + frame.r[corner], 0) / 4);
    centres.y.push(corners.reduce((sum, corner) => sum + frame.z[corner], 0) / 4);
    centres.values.push(value);
  }
  return {traces, centres};
}

function filmTraces(run, frame, field, range) {
  const mirrored = element("film-mirror").checked && run.axisymmetric, mesh = element("film-mesh").checked;
  const {traces, centres} = polygons(frame, frame.values[field], range, mirrored);
  const result = traces.map((trace, bin) => {
    const colour = colourOf((bin + .5) / N_COLOURS);
    return {...trace, type: "scatter", mode: "lines", fill: "toself", fillcolor: colour, hoverinfo: "skip", showlegend: false,
            line: {width: mesh ? .6 : .8, color: mesh ? "#ffffff" : colour}};
  });
  const [name, unit] = run.film.fields[field];
  result.push({...centres, type: "scatter", mode: "markers", showlegend: false, customdata: centres.values,
    hovertemplate: `r %{x:.4g}, z %{y:.4g}<br>${words(name)} %{customdata:.4g}<extra></extra>`,
    marker: {size: 6, opacity: 0, color: centres.values, cmin: range[0], cmax: range[1], showscale: true,
             colorscale: SCALE.map((colour, i) => [i / (SCALE.length - 1), colour]),
             colorbar: {title: {text: labelled(words(name), unit), side: "right"}, thickness: 14, len: .9}}});
  Object.entries(frame.tools).forEach(([tool, [r, z]]) => {
    const both = mirrored ? {x: [...r, null, ...r.map(value => -value)], y: [...z, null, ...z]} : {x: r, y: z};
    const number = run.tools.indexOf(tool.replaceAll(" ", "_"));
    result.push({...both, type: "scatter", mode: "lines", name: tool, hoverinfo: "name", connectgaps: false,
                 line: {color: TOOL_COLOURS[Math.max(number, 0) % TOOL_COLOURS.length], width: 2.5}});
  });
  return result;
}

// What the film shows: the blank all along, with some room; tools are endless.
function window_(run, mirrored) {
  let [left, right, low, high] = [Infinity, -Infinity, Infinity, -Infinity];
  for (const frame of run.film.frames) {
    for (const r of frame.r) { left = Math.min(left, r); right = Math.max(right, r); }
    for (const z of frame.z) { low = Math.min(low, z); high = Math.max(high, z); }
  }
  if (mirrored) left = -right;
  const room = .08 * Math.max(right - left, high - low);
  return {x: [left - room, right + room], y: [low - room, high + room]};
}

const travelAt = (run, time) => {
  if (!run.main_tool) return null;
  const times = run.history.columns.time, travels = run.history.columns[run.main_tool + "_travel"];
  if (time <= times[0]) return travels[0] * (times[0] > 0 ? time / times[0] : 1);
  let i = times.findIndex(value => value >= time);
  if (i < 0) i = times.length - 1;
  if (i === 0 || times[i] === times[i - 1]) return travels[i];
  const share = Math.min(1, (time - times[i - 1]) / (times[i] - times[i - 1]));
  return travels[i - 1] + share * (travels[i] - travels[i - 1]);
};

function showFrame(again) {
  const run = runs[film.run], frames = run.film.frames, number = +element("film-slider").value, frame = frames[number];
  if (!frame) return;
  const field = +element("film-field").value, mirrored = element("film-mirror").checked && run.axisymmetric;
  const range = rangeOf(element("film-own-range").checked ? [frame] : frames, field);
  // Whoever has zoomed stays there while the film moves.
  const key = `${film.run} ${mirrored}`, before = element("film").layout;
  const extent = film.view === key && before ? {x: [...before.xaxis.range], y: [...before.yaxis.range]} : window_(run, mirrored);
  film.view = key;
  const unit = run.history.units[run.main_tool + "_travel"] || "";
  const view = layout(labelled(run.axisymmetric ? "r" : "x", unit), labelled(run.axisymmetric ? "z" : "y", unit), {dragmode: "pan"});
  view.xaxis.range = extent.x;
  Object.assign(view.yaxis, {range: extent.y, scaleanchor: "x", scaleratio: 1, zeroline: false});
  Plotly.react("film", filmTraces(run, frame, field, range), view, {...CONFIG, scrollZoom: true, doubleClick: false, modeBarButtonsToRemove: [...CONFIG.modeBarButtonsToRemove, "resetScale2d", "autoScale2d"]});
  const travel = travelAt(run, frame.time);
  element("film-label").textContent = (travel === null ? "" : `${words(run.main_tool)} ${short(travel)} ${unit}, `) + `time ${short(frame.time)}`;
  if (again !== "first") mark(travel, frame.time);
}

function chooseRun() {
  film.run = +element("film-run").value;
  const run = runs[film.run], fields = run.film.fields;
  const wanted = element("film-field").selectedOptions[0]?.textContent;
  fill(element("film-field"), fields.map(([name, unit], i) => [i, labelled(words(name), unit)]));
  const like = text => fields.findIndex(([name, unit]) => labelled(words(name), unit) === text);
  const usual = fields.findIndex(([name]) => name === "equivalent_plastic_strain");
  element("film-field").value = wanted && like(wanted) >= 0 ? like(wanted) : Math.max(usual, 0);
  element("film-slider").max = Math.max(run.film.frames.length - 1, 0);
  element("film-slider").value = element("film-slider").max;
  element("film-mirror-label").hidden = !run.axisymmetric;
  const none = run.film.frames.length === 0;
  element("film").hidden = none;
  element("film-note").textContent = none ? "No pictures were written: Output/Pictures = 0."
    : run.film.thinned ? "Not all pictures of the run are shown, to keep the page small." : "";
}

function play() {
  const button = element("film-play"), slider = element("film-slider");
  if (film.timer) { clearInterval(film.timer); film.timer = null; button.textContent = "play"; return; }
  if (+slider.value >= +slider.max) slider.value = 0;
  button.textContent = "stop";
  showFrame();
  film.timer = setInterval(() => {
    slider.value = +slider.value + 1;
    showFrame();
    if (+slider.value >= +slider.max) play();
  }, 160);
}

function startFilm() {
  fill(element("film-run"), runs.map((run, i) => [i, run.name]));
  element("film-run").parentElement.hidden = !several();
  chooseRun();
  element("film-run").addEventListener("change", () => { chooseRun(); showFrame(); });
  for (const id of ["film-field", "film-mesh", "film-mirror", "film-own-range"]) element(id).addEventListener("change", showFrame);
  element("film-slider").addEventListener("input", showFrame);
  element("film-play").addEventListener("click", play);
  element("film-whole").addEventListener("click", () => { film.view = null; showFrame(); });
  showFrame("first");
}

// Where the film is, in the chart of the forces.
function mark(travel, time) {
  const at = element("force-over").value === "time" ? time : travel;
  Plotly.relayout("force", {shapes: at === null ? [] : [{type: "line", x0: at, x1: at, y0: 0, y1: 1, yref: "paper", line: {color: "#999999", width: 1, dash: "dot"}}]});
}

function forces() {
  const overTime = element("force-over").value === "time";
  const traces = runs.flatMap((run, k) => run.tools.map((tool, i) => ({
    x: run.history.columns[overTime || !run.main_tool ? "time" : run.main_tool + "_travel"], y: run.history.columns[tool + "_force_z"],
    name: several() ? `${words(tool)}, ${run.name}` : words(tool), type: "scatter", mode: "lines",
    line: {color: TOOL_COLOURS[i % TOOL_COLOURS.length], dash: DASHES[k % DASHES.length]}})));
  const run = runs[0], main = run.main_tool;
  const x = overTime || !main ? labelled("time", run.history.units.time === "time" ? "" : run.history.units.time)
    : labelled(`travel of ${words(main)}`, run.history.units[main + "_travel"]);
  Plotly.react("force", traces, layout(x, labelled("force in " + (run.axisymmetric ? "z" : "y"), run.tools.length ? unitOf(run, run.tools[0] + "_force_z") : "")), CONFIG);
}

const stateName = (run, state) => (several() ? run.name + ", " : "") + `${short(state.travel)}` +
  (new Set(run.states.map(one => one.stage)).size > 1 ? `, ${state.stage}` : "");

const LENGTHS = {S0: "initial arc length", R0: "initial radius", r: "radius"};

// Where there are many states, the last one of a run is shown, the others wait in the legend.
function alongSheet() {
  const over = element("profile-over").value, value = element("profile-value").value;
  const traces = runs.flatMap((run, k) => run.states.map((state, s) => {
    const columns = state.profile.columns, age = run.states.length > 1 ? .35 + .65 * s / (run.states.length - 1) : 1;
    return {x: columns[over], y: columns[value], name: stateName(run, state), type: "scatter", mode: "lines", opacity: age,
            visible: s === run.states.length - 1 || run.states.length <= 5 ? true : "legendonly",
            line: {color: RUN_COLOURS[k % RUN_COLOURS.length], width: 1 + age}};
  })).filter(trace => trace.x && trace.y);
  const units = runs.flatMap(run => run.states).map(state => state.profile.units).find(one => value in one) || {};
  Plotly.react("profile", traces, layout(labelled(LENGTHS[over] || over, units[over]), labelled(words(value), units[value])), CONFIG);
}

const touching = run => run.states.filter(state => state.contact && state.contact.columns.S0.length);

function contact() {
  const value = element("contact-value").value, wanted = element("contact-state").value;
  const traces = runs.flatMap((run, k) => touching(run).slice(wanted ? 0 : -1).filter(state => !wanted || stateName(run, state) === wanted).flatMap(state => {
    const columns = state.contact.columns;
    const y = value === "p/delta" ? i => columns.penetration[i] / columns.delta[i] : i => columns[value][i];
    return [...new Set(columns.tool)].map(tool => {
      const rows = columns.tool.map((name, i) => name === tool ? i : -1).filter(i => i >= 0);
      return {x: rows.map(i => columns.S0[i]), y: rows.map(y), name: `${tool} at ${stateName(run, state)}`, type: "scatter", mode: "markers",
              marker: {color: TOOL_COLOURS[Math.max(run.tools.indexOf(tool.replaceAll(" ", "_")), 0) % TOOL_COLOURS.length],
                       symbol: ["circle", "square", "diamond", "cross", "x"][k % 5], size: 6}};
    });
  }));
  const units = (runs.flatMap(touching)[0] || {contact: {units: {}}}).contact.units;
  Plotly.react("contact", traces, layout(labelled(LENGTHS.S0, units.S0), traces.length ? labelled(words(value), units[value]) : "nothing touches"), CONFIG);
}

function tables() {
  const profiles = runs.flatMap(run => run.states.map(state => state.profile));
  const names = [...new Set(profiles.flatMap(table => table.names))];
  const first = ["eps_thickness", "equivalent_plastic_strain", "u_z"].find(name => names.includes(name));
  fill(element("profile-value"), names.map(name => [name, words(name)]), first);
  fill(element("profile-over"), ["S0", "R0", "r"].filter(name => names.includes(name)).map(name => [name, LENGTHS[name]]));
  const kinds = ["pressure", "p/delta", "normal_force", "tangential_force", "slip", "epsilon", "penetration"];
  fill(element("contact-value"), kinds.map(name => [name, words(name)]));
  const states = [...new Set(runs.flatMap(run => touching(run).map(state => stateName(run, state))))];
  fill(element("contact-state"), [["", several() ? "last of each run" : "last"], ...states.map(name => [name, name])]);
  for (const id of ["profile-value", "profile-over"]) element(id).addEventListener("change", alongSheet);
  for (const id of ["contact-value", "contact-state"]) element(id).addEventListener("change", contact);
  alongSheet();
  contact();
}

// Major and minor strain of a sheet: the nodes in the last state, and the paths of some of them through all states.
const N_PATHS = 9;
const isSheet = run => run.states.some(state => "eps_meridional" in state.profile.columns && "eps_hoop" in state.profile.columns);

function inPlane(state) {
  const {eps_meridional: meridional, eps_hoop: hoop} = state.profile.columns;
  return {minor: meridional.map((value, i) => Math.min(value, hoop[i])), major: meridional.map((value, i) => Math.max(value, hoop[i]))};
}

// Some nodes along the sheet, and the one that is strained most.
function nodesOfPaths(last) {
  const n = last.major.length, some = Array.from({length: N_PATHS}, (_, i) => Math.round(i * (n - 1) / (N_PATHS - 1)));
  return [...new Set([...some, last.major.indexOf(Math.max(...last.major))])].sort((a, b) => a - b);
}

function strains() {
  const run = runs[+element("strains-run").value], states = run.states.filter(state => "eps_hoop" in state.profile.columns);
  if (!states.length) { Plotly.react("strains", [], layout("minor strain", "no profile of a sheet was written"), CONFIG); return; }
  const all = states.map(inPlane), last = all.at(-1), columns = states.at(-1).profile.columns, used = columns.forming_limit;
  const traces = nodesOfPaths(last).map(i => ({x: [0, ...all.map(state => state.minor[i])], y: [0, ...all.map(state => state.major[i])], type: "scatter",
    mode: "lines+markers", name: "path", showlegend: false, marker: {size: 3}, line: {width: 1, color: "#8a96a3"},
    hovertemplate: `node at S0 = ${short(columns.S0[i])}: %{x:.4f}, %{y:.4f}<extra></extra>`}));
  traces.push({x: last.minor, y: last.major, type: "scatter", mode: "markers", name: "nodes at the end", customdata: columns.S0.map((place, i) => [place, used ? used[i] : null]),
    hovertemplate: `S0 %{customdata[0]:.4g}: %{x:.4f}, %{y:.4f}${used ? "<br>share of the limit %{customdata[1]:.3f}" : ""}<extra></extra>`,
    marker: {size: 6, color: used || RUN_COLOURS[0], ...(used ? {cmin: 0, cmax: 1, showscale: true, colorscale: SCALE.map((colour, i) => [i / (SCALE.length - 1), colour]),
      colorbar: {title: {text: "share of the limit", side: "right"}, thickness: 14, len: .9}} : {})}});
  const most = Math.max(...last.major, 1e-3) * 1.05;
  [["uniaxial tension", -.5], ["plane strain", 0], ["equibiaxial", 1]].forEach(([name, ratio]) => traces.push({x: [0, ratio * most], y: [0, most], type: "scatter", mode: "lines",
    name, hoverinfo: "name", showlegend: false, line: {width: 1, dash: "dot", color: "#b9c2cc"}}));
  if (run.limit) traces.push({x: run.limit.minor, y: run.limit.major, type: "scatter", mode: "lines", name: "forming limit", line: {color: "#b00020", width: 2.5}});
  Plotly.react("strains", traces, layout("minor strain", "major strain"), CONFIG);
  const largest = used ? Math.max(...used.filter(value => value !== null)) : null;
  element("strains-note").textContent = [used ? `Largest share of the forming limit that a path has used up: ${short(largest)} (1: it necks).` : "",
    states.length < 3 ? "More points of the paths: Output/Travels." : ""].filter(Boolean).join(" ");
}

function startStrains() {
  const sheets = runs.map((run, i) => [i, run.name]).filter(([i]) => isSheet(runs[i]));
  element("strains-section").hidden = sheets.length === 0;
  if (sheets.length === 0) return;
  fill(element("strains-run"), sheets);
  element("strains-run").parentElement.hidden = sheets.length === 1;
  element("strains-run").addEventListener("change", strains);
  strains();
}

function energies() {
  const run = runs[+element("energy-run").value], columns = run.history.columns;
  const parts = ["plastic_energy", "friction_energy", "elastic_energy", "contact_energy", "epsilon_work", "thickness_work"].filter(name => name in columns);
  const x = columns[run.main_tool ? run.main_tool + "_travel" : "time"];
  const traces = parts.map((name, i) => ({x, y: columns[name], name: words(name), type: "scatter", mode: "lines", line: {width: 1.5, color: RUN_COLOURS[i % 6]}}));
  if (parts.length) {
    traces.push({x, y: x.map((_, i) => parts.reduce((sum, name) => sum + columns[name][i], 0)), name: "sum of these", type: "scatter", mode: "lines", line: {width: 2.5, color: "#000000"}});
    traces.push({x, y: x.map((_, i) => columns.tool_work[i] + (columns.load_work ? columns.load_work[i] : 0)), name: "work of tools and loads", type: "scatter", mode: "lines",
                 line: {width: 2.5, dash: "dot", color: "#e69f00"}});
  }
  const over = run.main_tool ? labelled(`travel of ${words(run.main_tool)}`, run.history.units[run.main_tool + "_travel"]) : "time";
  Plotly.react("energy", traces, layout(over, parts.length ? labelled("energy", unitOf(run, parts[0])) : "not asked for (Output/Energies)"), CONFIG);
}

function cost() {
  const traces = runs.flatMap((run, k) => [
    {x: run.history.columns.increment, y: run.history.columns.newton_iterations, name: several() ? `iterations, ${run.name}` : "Newton iterations",
     type: "scatter", mode: "lines", line: {color: RUN_COLOURS[k % 6], width: 1.2, shape: "hvh"}},
    {x: run.cuts.map(cut => cut.increment), y: run.cuts.map(cut => run.history.columns.newton_iterations[cut.increment - 1] ?? null),
     text: run.cuts.map(cut => cut.why), name: several() ? `cut, ${run.name}` : "cut back", type: "scatter", mode: "markers",
     hovertemplate: "increment %{x} cut back<extra></extra>", marker: {color: "#b00020", symbol: "x", size: 7}}]);
  Plotly.react("cost", traces, layout("increment", "iterations"), CONFIG);
  const bars = runs.filter(run => run.timing).map((run, k) => {
    const steps = [...run.timing.sections].sort((a, b) => parseInt(b.name) - parseInt(a.name));
    return {y: steps.map(step => step.name.split(":")[0]), x: steps.map(step => step.seconds), type: "bar", orientation: "h", name: run.name,
            showlegend: several(), marker: {color: RUN_COLOURS[k % 6]}, hovertemplate: "%{y}: %{x:.3g} s<extra></extra>"};
  });
  const view = layout("seconds", "", {barmode: "group"});
  view.yaxis.automargin = true;
  Plotly.react("timing", bars, view, CONFIG);
}

function tableOf(heads, rows) {
  const table = node("table"), head = node("tr");
  for (const text of heads) head.append(node("th", text));
  table.append(head);
  for (const {cells, name} of rows) {
    const row = node("tr", undefined, name);
    for (const text of cells) row.append(node("td", text));
    table.append(row);
  }
  return table;
}

function cuts() {
  const rows = runs.flatMap(run => run.cuts.map(cut => ({cells: [...(several() ? [run.name] : []), cut.increment, short(cut.time), cut.why]})));
  element("cuts").replaceChildren(rows.length ? tableOf([...(several() ? ["run"] : []), "increment", "to time", "why"], rows)
    : node("p", "None: every increment was solved at its first length."));
}

function sceneTable() {
  const entries = [...new Set(runs.flatMap(run => Object.keys(run.scene)))], sought = element("scene-search").value.toLowerCase();
  const values = entry => runs.map(run => run.scene[entry] ?? "-");
  const differs = entry => new Set(values(entry)).size > 1;
  const rows = entries.filter(entry => (!element("scene-differs").checked || differs(entry)) && `${entry} ${values(entry).join(" ")}`.toLowerCase().includes(sought))
    .sort((a, b) => differs(b) - differs(a)).map(entry => ({cells: [entry, ...values(entry)], name: differs(entry) ? "differs" : ""}));
  element("scene").replaceChildren(tableOf(["entry", ...runs.map(run => several() ? run.name : "value")], rows));
}

async function start() {
  runs = JSON.parse(await unpacked("data"));
  const library = node("script", await unpacked("library"));
  document.head.append(library);
  header();
  startFilm();
  forces();
  const frame = runs[0].film.frames.at(-1);
  if (frame) mark(travelAt(runs[0], frame.time), frame.time);
  element("force-over").addEventListener("change", () => { forces(); showFrame(); });
  tables();
  startStrains();
  fill(element("energy-run"), runs.map((run, i) => [i, run.name]));
  element("energy-run").parentElement.hidden = !several();
  element("energy-run").addEventListener("change", energies);
  energies();
  cost();
  cuts();
  element("scene-differs-label").hidden = !several();
  element("scene-differs").checked = several();
  element("scene-search").addEventListener("input", sceneTable);
  element("scene-differs").addEventListener("change", sceneTable);
  sceneTable();
  document.body.dataset.ready = "true";
}

start().catch(error => {
  element("messages").append(node("p", `This page could not be drawn: ${error.message}. It needs a browser of 2023 or later.`, "message bad"));
  throw error;
});
