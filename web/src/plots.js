// Plots over time: uPlot, all with one cursor and one zoom.
import uPlot from "uplot";
import { css, element, short } from "./data.js";

// Okabe and Ito's colours for any colour vision, in an order that keeps neighbours apart; the page's text colour stands for black.
// On dark the same hues, lighter.
const palettes = {
  light: ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#1b2330", "#8c6d31"],
  dark: ["#58b0ee", "#ff8a4c", "#2bc79b", "#e39bc5", "#f0b93a", "#b7a8ff", "#e4e9f0", "#c9a66b"],
};
const colours = 8;
const colour = (i) => palettes[document.documentElement.dataset.theme === "dark" ? "dark" : "light"][i % colours];
const dashes = [undefined, [7, 4], [2, 3]];
const nonzero = (values) => values.some((v) => Number.isFinite(v) && v !== 0);
const rangeOf = (values) => {
  let low = Infinity, high = -Infinity;
  for (const v of values) if (Number.isFinite(v)) { low = Math.min(low, v); high = Math.max(high, v); }
  return [low, high];
};

/** Draws all plots; returns { mark(time), redraw() }. choose(time) is called for a click. */
export function drawPlots(run, choose) {
  const time = run.numbers(run.tables.time);
  const column = (columns, name) => (columns[name] ? Array.from(run.numbers(columns[name])) : []);
  const place = document.getElementById("plots"), chips = document.getElementById("chips");
  const bodies = run.tables.bodies.filter((body) => body.motion !== "fixed");
  const gaps = run.tables.gaps;
  const gapName = (gap) => `${gap.a} – ${gap.b}`;
  const many = 5;
  const moves = (name) => bodies.some((body) => body.name === name);
  const lively = gaps.filter((gap) => moves(gap.a) || moves(gap.b));
  const shown = { bodies: new Set(bodies.slice(0, many)), gaps: new Set((lively.length ? lively : gaps).slice(0, many)) };
  let plots = [], skipped = [];

  function addChips(label, list, set, name) {
    if (list.length < 2) return;
    chips.append(element("span", {}, label));
    for (const entry of list) {
      const chip = element("button", { type: "button", "aria-pressed": String(set.has(entry)) }, name(entry));
      chip.onclick = () => {
        set.has(entry) ? set.delete(entry) : set.add(entry);
        chip.setAttribute("aria-pressed", String(set.has(entry)));
        draw();
      };
      chips.append(chip);
    }
  }
  addChips("Bodies", bodies, shown.bodies, (body) => body.name);
  addChips("Gaps", gaps, shown.gaps, gapName);

  function ofBodies(columns, change = (v) => v) {
    const list = [];
    for (const body of bodies.filter((b) => shown.bodies.has(b)))
      for (const [name, label] of columns) {
        const raw = column(body.columns, name);
        if (raw.length) list.push({ label: `${body.name} ${label}`, values: change(raw), raw });
      }
    return list;
  }
  const ofGaps = (columns) => gaps.filter((g) => shown.gaps.has(g)).flatMap((gap) =>
    columns.map(([name, label]) => ({ label: label ? `${gapName(gap)} ${label}` : gapName(gap), values: column(gap.columns, name) })));
  // Largest size of any body's columns: what is round-off is judged by it.
  function largest(prefix, change = (v) => v) {
    let most = 0;
    for (const body of bodies)
      for (const [name] of axes(prefix))
        for (const v of change(column(body.columns, name))) if (Math.abs(v) > most) most = Math.abs(v);
    return most;
  }
  const sinceStart = (v) => v.map((x) => x - v[0]);
  const axes = (prefix) => (run.dimension === 2 ? ["x", "y"] : ["x", "y", "z"]).map((a) => [prefix + a, prefix + a]);

  function draw() {
    for (const plot of plots) plot.destroy();
    plots = [];
    place.replaceChildren();
    if (time.length < 2) {
      place.append(element("p", { class: "note" }, time.length === 1
        ? "The run has written its start only: there is nothing to plot yet." : "The run has written no step."));
      return;
    }
    const length = Math.max(...run.domain.size), little = 1e-6;
    skipped = [];
    add("Position (change since the start)", ofBodies(axes(""), sinceStart), { legend: (s, i) => short(s.raw[i]) });
    add("Velocity", ofBodies(axes("v")));
    if (run.dimension === 2) {
      add("Angle (rad)", ofBodies([["angle", "angle"]]), { least: (little * largest("", sinceStart)) / length });
      add("Angular velocity", ofBodies([["omega", "ω"]]), { least: (little * largest("v")) / length });
    } else {
      add("Turned since the start (rad)", turned(), { least: (little * largest("", sinceStart)) / length });
      add("Angular velocity", ofBodies(axes("w")), { least: (little * largest("v")) / length });
    }
    add("Force of the fluid", ofBodies(axes("f")));
    add("Torque of the fluid", ofBodies(run.dimension === 2 ? [["torque", "torque"]] : axes("t")), { least: little * largest("f") * length });
    add("Gap thickness", ofGaps([["thickness", ""]]), { log: true });
    add("Opening rate of gaps", ofGaps([["opening_rate", ""]]));
    add("Film pressure, smallest and largest", ofGaps([["pressure_min", "min"], ["pressure_max", "max"]]));
    add("Force of films", ofGaps([["force", ""]]));
    add("Contact force", ofGaps([["contact_force", ""]]).filter((s) => nonzero(s.values)));
    const fluid = column(run.tables.steps, "energy_fluid"), solid = column(run.tables.steps, "energy_bodies");
    add("Kinetic energy", [
      { label: "fluid", values: fluid }, { label: "bodies", values: solid },
      { label: "both", values: fluid.map((e, i) => e + solid[i]) }]);
    const after = (name) => column(run.tables.steps, name).map((v, i) => (i === 0 ? NaN : v)); // the start is no step
    add("Step size", [{ label: "Δt", values: after("dt") }], { log: true });
    add("Iterations of the solver", [{ label: "iterations", values: column(run.tables.steps, "iterations") }], { zero: true });
    add("Largest divergence", [{ label: "divergence", values: after("divergence_max") }], { log: true });
    add("Time of a step (seconds)", [{ label: "seconds", values: after("seconds") }], { zero: true });
    if (skipped.length) place.append(element("p", { class: "note" }, `Not drawn, nothing there but round-off: ${skipped.join(", ")}.`));
    setTimeout(() => mark(marked)); // uPlot finishes its set-up first
  }

  function turned() {
    return bodies.filter((b) => shown.bodies.has(b)).map((body) => {
      const q = ["qw", "qx", "qy", "qz"].map((name) => column(body.columns, name));
      return { label: body.name, values: (q[0] ?? []).map((_, i) =>
        2 * Math.acos(Math.min(1, Math.abs(q.reduce((sum, c) => sum + c[i] * c[0], 0))))) };
    });
  }

  // A plot of the series that change; nothing where none does.
  function add(title, series, options = {}) {
    const ranges = series.map((s) => rangeOf(s.values));
    const widest = Math.max(...ranges.map(([low, high]) => high - low), 0);
    const scale = Math.max(...ranges.map(([low, high]) => Math.max(Math.abs(low), Math.abs(high))).filter(Number.isFinite), 0);
    if (options.least !== undefined && widest <= options.least) {
      if (widest > 0) skipped.push(title.toLowerCase());
      return;
    }
    const change = (i) => ranges[i][1] - ranges[i][0] > Math.max(1e-4 * widest, 1e-12 * scale);
    const drawn = series.filter((s, i) => change(i) || (series.length === 1 && nonzero(s.values)));
    if (drawn.length === 0) return;
    const still = series.filter((s) => !drawn.includes(s) && s.values.length).map((s) => s.label);
    const log = options.log && drawn.every((s) => s.values.every((v) => !(v <= 0)))
      && Math.max(...drawn.map((s) => rangeOf(s.values)[1])) > 4 * Math.min(...drawn.map((s) => rangeOf(s.values)[0]));
    const card = element("div", { class: "plot card" }, element("h3", {}, title + (log ? ", logarithmic" : "")));
    place.append(card);
    const stroke = () => css("--soft"), grid = { stroke: () => css("--grid"), width: 1 };
    const axis = { stroke, grid, ticks: grid, font: "12px system-ui, sans-serif" };
    const fromZero = { range: (u, low, high) => [0, high > 0 ? 1.08 * high : 1] };
    const logTick = (v) => (v !== null && /^[15]/.test(v.toExponential()) ? short(v) : ""); // 1 and 5 of a decade
    const plot = new uPlot({
      width: card.clientWidth - 34, height: 210,
      scales: { x: { time: false }, y: { distr: log ? 3 : 1, ...(options.zero ? fromZero : {}) } },
      axes: [{ ...axis, size: 32 }, { ...axis, size: 62, values: (u, ticks) => ticks.map(log ? logTick : short) }],
      cursor: { sync: { key: "gapflow" }, drag: { x: true, y: false }, points: { size: 7 } },
      legend: { live: true },
      series: [{ label: "time", value: (u, v) => short(v) }, ...drawn.map((s, i) => ({
        label: s.label, stroke: () => colour(i), width: 1.6, dash: dashes[Math.floor(i / colours) % dashes.length], spanGaps: false,
        points: { show: time.length < 40 ? undefined : false },
        value: (u, v, k, index) => (index === null || index === undefined ? "–" : options.legend ? options.legend(s, index) : short(v)),
      }))],
      hooks: { draw: [(u) => u.now && moveMark(u)] },
    }, [Array.from(time), ...drawn.map((s) => s.values.map((v) => (Number.isFinite(v) ? v : null)))], card);
    plot.now = element("div", { class: "now" });
    plot.over.append(plot.now);
    plot.over.addEventListener("mouseleave", () => setTimeout(() => mark(marked)));
    let pressed = null;
    plot.over.addEventListener("mousedown", (event) => (pressed = event.clientX));
    plot.over.addEventListener("click", (event) => {
      if (pressed !== null && Math.abs(event.clientX - pressed) < 4) choose(plot.posToVal(event.offsetX, "x"));
    });
    if (still.length) card.append(element("p", { class: "note" }, `not drawn (changes below 0.01 % of these): ${still.join(", ")}`));
    plots.push(plot);
  }

  let marked = null;
  function moveMark(plot) {
    const x = marked === null ? -1 : plot.valToPos(marked, "x");
    plot.now.hidden = !(x >= 0 && x <= plot.over.clientWidth);
    plot.now.style.transform = `translateX(${x}px)`;
  }
  function mark(at) {
    marked = at;
    let row = time.findIndex((t) => t >= at * (1 - 1e-12));
    if (row < 0) row = time.length - 1;
    for (const plot of plots) {
      moveMark(plot);
      plot.setLegend({ idx: row }, false); // the values of that time, while no pointer asks for another
    }
  }
  draw();
  let width = place.clientWidth;
  new ResizeObserver(() => {
    if (place.clientWidth === width) return;
    width = place.clientWidth;
    for (const plot of plots) plot.setSize({ width: plot.root.parentElement.clientWidth - 34, height: 210 });
  }).observe(place);
  return { mark, redraw: () => plots.forEach((plot) => plot.redraw(false, true)) };
}

/** Film pressure and thickness along the gaps of a frame, one gap after the other (2D); returns show(film). */
export function drawProfile(card) {
  const title = element("h3", {}, "Along the gaps");
  const note = element("p", { class: "note" }, "Distance along the films, one after the other with breaks.");
  card.append(title, note);
  let plot = null;
  const make = (data) => {
    const stroke = () => css("--soft"), grid = { stroke: () => css("--grid"), width: 1 };
    const axis = { stroke, grid, ticks: grid, font: "12px system-ui, sans-serif" };
    plot = new uPlot({
      width: card.clientWidth - 34, height: 220,
      scales: { x: { time: false }, h: { range: (u, low, high) => [0, high > 0 ? 1.1 * high : 1] } },
      axes: [{ ...axis, size: 32 }, { ...axis, size: 56, values: (u, t) => t.map(short) },
        { ...axis, scale: "h", side: 1, size: 56, grid: { show: false }, values: (u, t) => t.map(short) }],
      cursor: { drag: { x: true, y: false }, points: { size: 7 } },
      series: [{ label: "distance", value: (u, v) => short(v) },
        { label: "film pressure", stroke: () => colour(1), width: 1.8, points: { show: false }, value: (u, v) => short(v) },
        { label: "thickness", scale: "h", stroke: () => colour(0), width: 1.4, dash: [6, 4], points: { show: false }, value: (u, v) => short(v) }],
    }, data, card);
  };
  const show = (film) => {
    const data = [[], [], []];
    const apart = (a, b) => Math.hypot(film.points[2 * a] - film.points[2 * b], film.points[2 * a + 1] - film.points[2 * b + 1]);
    const total = film.chains.reduce((sum, chain) => chain.reduce((s, node, i) => s + (i ? apart(node, chain[i - 1]) : 0), sum), 0);
    let along = 0;
    for (const chain of film.chains) {
      for (let i = 0; i < chain.length; ++i) {
        const a = chain[i];
        along += i ? apart(a, chain[i - 1]) : 0;
        data[0].push(along);
        data[1].push(film.pressure[a]);
        data[2].push(film.thickness[a]);
      }
      along += 0.02 * total; // a break between films
      data[0].push(along);
      data[1].push(null);
      data[2].push(null);
      along += 0.02 * total;
    }
    note.textContent = film.chains.length === 0 ? "No film at this time."
      : film.chains.length === 1 ? "Distance along the film." : "Distance along the films, one after the other with breaks.";
    plot ? plot.setData(data) : make(data);
  };
  new ResizeObserver(() => plot?.setSize({ width: card.clientWidth - 34, height: 220 })).observe(card);
  return { show, redraw: () => plot?.redraw(false, true) };
}
