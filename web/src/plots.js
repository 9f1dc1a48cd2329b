// Plots of one run over time, and along the gaps of a frame.
import uPlot from "uplot";
import { chooser, foremost } from "./chooser.js";
import { axisStyle, colour, curves, lively, spansMuch } from "./curves.js";
import { element, short } from "./data.js";
import { foremostOf, measureKinds, measuresOf } from "./measures.js";
import { plotList } from "./plot_list.js";
import { bodiesOf, gapName, plotsOf, reader, way } from "./quantities.js";
import { units } from "./units.js";

const most = 5; // drawn at first
const mostFilms = 12; // along the gaps

/** Draws all plots; returns { mark(time), redraw() }. choose(time) is called for a click. */
export function drawPlots(run, choose) {
  const time = run.numbers(run.tables.time), column = reader(run);
  const place = document.getElementById("plots"), chips = document.getElementById("chips");
  const { bodies, groups } = bodiesOf(run), gaps = run.tables.gaps;
  const moves = (name) => bodies.some((body) => body.name === name), far = way(run, column);
  const thin = (gap) => -Math.min(...column(gap, "thickness").filter(Number.isFinite));
  const moving = gaps.filter((gap) => moves(gap.a) || moves(gap.b));
  const means = groups.filter((group) => group.mean), single = bodies.filter((b) => !groups.some((g) => g.members.includes(b)));
  const shown = { bodies: new Set([...means, ...foremost(bodies.length > 12 && single.length ? single : bodies, means.length ? 3 : most, far)]),
    gaps: new Set(foremost(moving.length ? moving : gaps, most, thin)) };
  if (bodies.length <= 12 && !means.length) shown.bodies = new Set(bodies.slice(0, most));
  if (gaps.length <= 12) shown.gaps = new Set((moving.length ? moving : gaps).slice(0, most));
  const list = plotList(place), draw = () => list.renew(plots), measures = measuresOf(run);
  chooser(chips, "Bodies", [...groups, ...bodies], shown.bodies, (body) => body.name,
    { text: "moved furthest", value: (body) => (body.members ? -1 : far(body)) }, draw);
  chooser(chips, "Gaps", gaps, shown.gaps, gapName, { text: "were thinnest", value: thin }, draw);
  for (const [kind, { label, text, of }] of Object.entries(measureKinds)) {
    shown[kind] = foremostOf(kind, measures[kind], of(column));
    chooser(chips, label, measures[kind], shown[kind], (entry) => entry.name, { text, value: of(column) }, draw);
  }

  function plots() {
    if (time.length < 2) {
      place.append(element("p", { class: "note" }, time.length === 1
        ? "The run has written its start only: there is nothing to plot yet." : "The run has written no step."));
      return [];
    }
    const drawn = [], skipped = [], all = [...groups, ...bodies];
    const chosen = Object.fromEntries(Object.keys(measureKinds).map((kind) => [kind, measures[kind].filter((entry) => shown[kind].has(entry))]));
    for (const entry of plotsOf(run, column, all.filter((b) => shown.bodies.has(b)), gaps.filter((g) => shown.gaps.has(g)), chosen, bodies)) {
      const found = lively(entry.series, { least: entry.least, keep: entry.keep, skipped: () => skipped.push(entry.title.toLowerCase()) });
      if (!found) continue;
      const note = found.still.length ? `not drawn (changes below 0.01 % of these): ${found.still.map((s) => s.label).join(", ")}` : "";
      drawn.push(curves(place, entry.title, entry.time ?? time, found.drawn, { ...entry, log: entry.log && spansMuch(found.drawn), note }, choose));
    }
    if (skipped.length) place.append(element("p", { class: "note" }, `Not drawn, nothing there but round-off: ${skipped.join(", ")}.`));
    return drawn;
  }
  draw();
  return list;
}

/** Film pressure and thickness along the gaps of a frame, one gap after the other with their names (2D); returns show(film, names), a name a chain. */
export function drawProfile(run, card) {
  const title = element("h3", {}, "Along the gaps"), unit = units(run.dimension);
  const note = element("p", { class: "note" });
  card.append(title, note);
  let plot = null, captions = [];
  // Names above the curves, those that have room.
  const write = (u) => {
    const brush = u.ctx, dots = devicePixelRatio || 1;
    brush.save();
    brush.font = `${11 * dots}px system-ui, sans-serif`;
    brush.fillStyle = axisStyle().stroke();
    brush.textAlign = "center";
    let free = -Infinity;
    captions.forEach(([at, text]) => {
      const half = 0.5 * brush.measureText(text).width;
      const x = Math.min(Math.max(u.valToPos(at, "x", true), u.bbox.left + half), u.bbox.left + u.bbox.width - half);
      if (x - half < free || captions.length < 2) return;
      free = x + half + 6 * dots;
      brush.fillText(text, x, u.bbox.top + 12 * dots);
    });
    brush.restore();
  };
  const make = (data) => {
    const axis = axisStyle();
    plot = new uPlot({
      width: card.clientWidth - 34, height: 240,
      scales: { x: { time: false }, h: { range: (u, low, high) => [0, high > 0 ? 1.1 * high : 1] } },
      axes: [{ ...axis, size: 32, label: "distance along the films (length)", values: (u, t) => t.map(short) }, { ...axis, size: 56, label: `film pressure (${unit.pressure})`, values: (u, t) => t.map(short) },
        { ...axis, scale: "h", side: 1, size: 56, label: "thickness (length)", grid: { show: false }, values: (u, t) => t.map(short) }],
      cursor: { drag: { x: true, y: false }, points: { size: 7 } },
      series: [{ label: "distance", value: (u, v) => short(v) },
        { label: "film pressure", stroke: () => colour(1), width: 1.8, points: { show: false }, value: (u, v) => short(v) },
        { label: "thickness", scale: "h", stroke: () => colour(0), width: 1.4, dash: [6, 4], points: { show: false }, value: (u, v) => short(v) }],
      hooks: { draw: [write] },
    }, data, card);
  };
  const show = (film, names) => {
    const data = [[], [], []];
    const apart = (a, b) => Math.hypot(film.points[2 * a] - film.points[2 * b], film.points[2 * a + 1] - film.points[2 * b + 1]);
    const thinnest = (chain) => chain.reduce((least, node) => Math.min(least, film.thickness[node]), Infinity);
    const all = film.chains.map((chain, n) => ({ chain, name: names[n] ?? "" }));
    const drawn = all.length <= mostFilms ? all : all.sort((a, b) => thinnest(a.chain) - thinnest(b.chain)).slice(0, mostFilms);
    const total = drawn.reduce((sum, { chain }) => chain.reduce((s, node, i) => s + (i ? apart(node, chain[i - 1]) : 0), sum), 0);
    let along = 0;
    captions = [];
    drawn.forEach(({ chain, name }) => {
      const start = along;
      for (let i = 0; i < chain.length; ++i) {
        const a = chain[i];
        along += i ? apart(a, chain[i - 1]) : 0;
        data[0].push(along);
        data[1].push(film.pressure[a]);
        data[2].push(film.thickness[a]);
      }
      captions.push([0.5 * (start + along), name]);
      along += 0.02 * total; // a break between films
      data[0].push(along);
      data[1].push(null);
      data[2].push(null);
      along += 0.02 * total;
    });
    note.textContent = film.chains.length === 0 ? "No film at this time."
      : film.chains.length === 1 ? `Between ${names[0] || "its walls"}.`
        : drawn.length < film.chains.length ? `The ${mostFilms} thinnest of ${film.chains.length} films, one after the other, with breaks.` : "One film after the other, with breaks.";
    plot ? plot.setData(data) : make(data);
  };
  new ResizeObserver(() => plot?.setSize({ width: card.clientWidth - 34, height: 240 })).observe(card);
  return { show, redraw: () => plot?.redraw(false, true) };
}
