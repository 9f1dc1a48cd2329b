// A page of several runs: plots with a curve a run, views beside each other with one slider.
import uPlot from "uplot";
import { chooser, foremost } from "./chooser.js";
import { colour, curves, lineStyle, lively, spansMuch } from "./curves.js";
import { element, frameReader, short } from "./data.js";
import { pictureButtons } from "./export.js";
import { foremostOf, measureKinds, measuresOf } from "./measures.js";
import { nearest, player } from "./player.js";
import { plotList } from "./plot_list.js";
import { bodiesOf, gapName, plotsOf, reader, way } from "./quantities.js";
import { drawSweep } from "./sweep.js";

const mostViews = { 2: 6, 3: 4 }; // a browser draws few pictures in 3D at once

export function compare(page, makeView, redraws) {
  const runs = page.runs.map((run, number) => ({ ...run, number }));
  const dot = (run) => {
    const mark = element("i", {});
    const paint = () => {
      const line = lineStyle(run.number);
      mark.style.background = line === "solid" ? colour(run.number) : "none";
      mark.style.border = `2px ${line} ${colour(run.number)}`;
    };
    paint();
    redraws.push(paint);
    return mark;
  };
  drawRuns(runs, dot);
  const transport = drawViews(page, runs, makeView, dot, redraws);
  const plots = drawCurves(runs, (time) => transport?.player.goToTime(time));
  transport?.watch((time) => plots.mark(time));
  redraws.push(plots.redraw);
  if (page.sweep) redraws.push(drawSweep(page, document.getElementById("view")));
  for (const name of ["scene", "machine"]) document.getElementById(name).closest("section").hidden = true;
  const shown = runs.reduce((sum, run) => sum + run.frames.length, 0), all = runs.reduce((sum, run) => sum + run.frames_of_run, 0);
  document.getElementById("limits").textContent = shown < all ? `Of ${all} output times of all runs ${shown} are in this page.` : "";
}

function drawRuns(runs, dot) {
  document.getElementById("facts").append(element("span", {}, `${runs.length} runs beside each other`));
  const head = ["", "run", "folder", "status", "steps", "time", "seconds"];
  document.getElementById("view").before(element("section", {}, element("div", { class: "card scroll runs" }, element("table", { class: "data" },
    element("thead", {}, element("tr", {}, ...head.map((name) => element("th", { scope: "col" }, name)))),
    element("tbody", {}, ...runs.map((run) => element("tr", {}, element("td", {}, dot(run)), ...[run.label, run.folder, run.record.status,
      String(run.record.steps), short(run.record.time), short(run.record.timings?.total_seconds)].map((cell) => element("td", {}, cell)))))))));
}

function drawViews(page, runs, makeView, dot, redraws) {
  const drawable = runs.filter((run) => run.frames.length > 0);
  if (!drawable.length) return null;
  document.getElementById("view").hidden = false;
  document.getElementById("view").style.gridTemplateColumns = "minmax(0, 1fr)";
  document.getElementById("beside").hidden = true;
  const picture = document.getElementById("picture"), most = mostViews[page.dimension], shared = {};
  picture.className = "panes";
  let panes = [];
  const chosen = new Set(drawable.slice(0, most));
  // The run with the most output times gives the slider's; the others show their nearest.
  const times = drawable.reduce((best, run) => (run.frames.length > best.frames.length ? run : best)).frames.map((frame) => frame.time);
  const latest = Math.max(...drawable.map((run) => run.frames[run.frames.length - 1].time));
  if (latest > times[times.length - 1]) times.push(latest);
  const watchers = [];
  let now = 0;
  function showPane(pane) {
    const frame = pane.read(nearest(pane.times, now));
    pane.view.show(frame);
    pane.note.textContent = Math.abs(frame.time - now) > 1e-9 * Math.max(now, 1) ? `at t = ${short(frame.time)}` : "";
  }
  function build() {
    for (const pane of panes) pane.view.remove();
    picture.replaceChildren();
    const list = drawable.filter((run) => chosen.has(run)).slice(0, most);
    picture.style.gridTemplateColumns = `repeat(${list.length > 4 ? 3 : Math.min(2, Math.max(list.length, 1))}, minmax(0, 1fr))`;
    panes = list.map((run) => {
      const place = element("div", { class: "picture" }), note = element("p", { class: "note" });
      picture.append(element("div", { class: "pane" }, element("h3", {}, dot(run), run.label), place, note));
      return { run, place, note, read: frameReader(run), times: run.frames.map((frame) => frame.time) };
    });
    for (const pane of panes) // when all are placed: the first ones have their final width
      pane.view = makeView(pane.run, { place: pane.place, choices: document.getElementById("choices"), scales: document.getElementById("scales"), shared });
    for (const pane of panes) showPane(pane);
  }
  const choice = element("div", { id: "runs" });
  picture.before(choice);
  chooser(choice, "Runs shown", drawable, chosen, (run) => run.label, { text: "come first", value: (run) => -run.number }, build);
  build();
  const transport = player(times, (index) => {
    now = times[index];
    for (const pane of panes) showPane(pane);
    for (const watch of watchers) watch(now);
  });
  document.getElementById("transport").append(...pictureButtons(page.title, () => panes.map((pane) => ({ ...pane.view, name: pane.run.label })), transport));
  redraws.push(() => { for (const pane of panes) pane.view.redraw(); });
  transport.go(Math.ceil(0.4 * (times.length - 1)));
  return { player: transport, watch: (f) => { watchers.push(f); f(now); } };
}

// One plot a quantity of a body or gap; the times of all runs in one list, with holes where a run has no row.
function drawCurves(runs, choose) {
  const place = document.getElementById("plots"), chips = document.getElementById("chips");
  const each = runs.map((run) => {
    const column = reader(run), { bodies, groups } = bodiesOf(run);
    return { run, column, far: way(run, column), bodies: [...groups, ...bodies], own: bodies, gaps: run.tables.gaps, measures: measuresOf(run), time: Array.from(run.numbers(run.tables.time)) };
  });
  const names = (lists) => [...new Set(lists.flat())];
  const bodies = names(each.map((e) => e.bodies.map((b) => b.name))), gaps = names(each.map((e) => e.gaps.map(gapName)));
  const far = (name) => Math.max(...each.map((e) => { const b = e.bodies.find((x) => x.name === name); return b && !b.members ? e.far(b) : -1; }));
  const thin = (name) => Math.max(...each.map((e) => {
    const gap = e.gaps.find((g) => gapName(g) === name);
    return gap ? -Math.min(...e.column(gap, "thickness").filter(Number.isFinite)) : -Infinity;
  }));
  const shown = { bodies: new Set(foremost(bodies, 2, far)), gaps: new Set(foremost(gaps, 2, thin)) };
  const list = plotList(place), draw = () => list.renew(plots);
  chooser(chips, "Bodies", bodies, shown.bodies, (name) => name, { text: "moved furthest", value: far }, draw);
  chooser(chips, "Gaps", gaps, shown.gaps, (name) => name, { text: "were thinnest", value: thin }, draw);
  const kinds = Object.entries(measureKinds);
  for (const [kind, { label, text, of }] of kinds) {
    const all = names(each.map((e) => e.measures[kind].map((entry) => entry.name)));
    const value = (name) => Math.max(...each.map((e) => e.measures[kind].filter((entry) => entry.name === name).map(of(e.column))).flat());
    shown[kind] = foremostOf(kind, all, value);
    chooser(chips, label, all, shown[kind], (name) => name, { text, value }, draw);
  }
  function plots() {
    const drawn = [], found = new Map(), alive = new Set(); // by title and what is drawn: the runs' series; those that more than round-off changes in some run
    for (const { run, column, bodies: all, own, gaps: of, measures, time } of each.filter((e) => e.time.length > 1))
      for (const entry of plotsOf(run, column, all.filter((b) => shown.bodies.has(b.name)), of.filter((g) => shown.gaps.has(gapName(g))),
        Object.fromEntries(kinds.map(([kind]) => [kind, measures[kind].filter((entry) => shown[kind].has(entry.name))])), own))
        for (const series of entry.series) {
          const [what, more] = entry.title.split(/(?= \()/);
          const title = entry.sole ? entry.title : series.alone ?? `${what}: ${series.label}${more ?? ""}`;
          if (lively(entry.series, { least: entry.least })?.drawn.includes(series)) alive.add(title);
          if (!found.has(title)) found.set(title, { entry, list: [] });
          found.get(title).list.push({ label: run.label, values: series.values, time: entry.time ?? time, look: run.number });
        }
    for (const [title, { entry, list }] of found) {
      if (!alive.has(title) || !lively(list)) continue;
      const joined = uPlot.join(list.map((s) => [s.time, s.values.map((v) => (Number.isFinite(v) ? v : null))]));
      const series = list.map((s, i) => ({ ...s, values: Array.from(joined[i + 1], (v) => (v === null ? NaN : v)) }));
      drawn.push(curves(place, title, joined[0], series, { unit: entry.unit, zero: entry.zero, log: entry.log && spansMuch(list) }, choose));
    }
    return drawn;
  }
  draw();
  return list;
}
