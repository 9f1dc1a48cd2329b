// The quantities of a sweep over the keys that vary: one plot a quantity, one curve for each choice of the other keys' values.
import { chooser, foremost } from "./chooser.js";
import { curves, rangeOf } from "./curves.js";
import { element } from "./data.js";
import { plotList } from "./plot_list.js";
import { unitOf, units } from "./units.js";

const most = 6; // drawn at first
const kinds = [["mean", "mean over time"], ["last", "last"], ["min", "smallest"], ["max", "largest"]];

// Where the values of a key lie on an axis: numbers where they are, vectors that differ in one number by it, else one after the other.
export function axisOf({ name, values }) {
  const numbers = values.map((v) => (v.trim() === "" ? NaN : Number(v)));
  if (numbers.every(Number.isFinite)) return { name, at: numbers };
  const lists = values.map((v) => (/^\[[^[\]"']*\]$/.test(v.trim()) ? v.trim().slice(1, -1).split(",").map(Number) : []));
  const differ = lists[0].map((_, i) => i).filter((i) => lists.some((list) => list[i] !== lists[0][i]));
  if (differ.length === 1 && lists.every((list) => list.length === lists[0].length && list.every(Number.isFinite)))
    return { name: `${name}, ${["x", "y", "z"][differ[0]] ?? `number ${differ[0] + 1}`}`, at: lists.map((list) => list[differ[0]]) };
  const words = [...new Set(values)];
  return { name, at: values.map((v) => words.indexOf(v)), words };
}

// In equal ratios over more than a factor of eight: logarithmic.
function inRatios(at) {
  const all = [...new Set(at)].sort((a, b) => a - b);
  return all.length > 2 && all[0] > 0 && all[all.length - 1] > 8 * all[0] &&
    all.slice(2).every((x, i) => Math.abs(Math.log(x / all[i + 1]) - Math.log(all[1] / all[0])) < 0.05 * Math.log(all[1] / all[0]));
}

// Buttons of which one is pressed.
function choice(place, label, entries, chosen, changed) {
  if (entries.length < 2) return;
  const buttons = entries.map(([key, text]) => {
    const button = element("button", { type: "button", "aria-pressed": String(key === chosen) }, text);
    button.onclick = () => {
      for (const other of buttons) other.setAttribute("aria-pressed", String(other === button));
      changed(key);
    };
    return button;
  });
  place.append(element("div", { class: "bar" }, label, element("span", { class: "segments" }, ...buttons)));
}

/** Draws them before `where`; nothing where no run has results. run.sweep: { keys, quantities }. Returns redraw(). */
export function drawSweep(page, where) {
  const { keys, quantities: stored } = page.sweep;
  const quantities = stored.map(({ name, ...columns }) => ({ name, ...Object.fromEntries(kinds.map(([kind]) => [kind, Array.from(page.numbers(columns[kind]))])) }))
    .filter((quantity) => quantity.last.some(Number.isFinite));
  if (!quantities.length || !keys.length || keys[0].values.length < 2) return () => {};
  const place = element("div", { class: "plots" }), bars = element("div", { class: "chips" });
  where.before(element("section", { id: "sweep" }, element("h2", {}, keys.length > 1 ? "Over the keys that vary" : `Over ${keys[0].name}`), bars, place));
  // Of runs that end once they are steady the last value is what they were made for.
  let key = 0, kind = page.runs.every((run) => run.scene.time?.until_steady) ? "last" : "mean";
  const vary = (quantity) => { // over their own size
    const [low, high] = rangeOf(quantity[kind]);
    return high > low ? (high - low) / Math.max(Math.abs(low), Math.abs(high)) : 0;
  };
  const sizes = new Map(), sizeOf = (values) => Math.max(0, ...rangeOf(values).filter(Number.isFinite).map(Math.abs));
  for (const quantity of quantities) { // what is small beside others of its unit is round-off
    const unit = unitOf(quantity.name, page.dimension);
    sizes.set(unit, Math.max(sizes.get(unit) ?? 0, ...kinds.map(([of]) => sizeOf(quantity[of]))));
  }
  // As in the plots over time: angles, rates and torques are round-off where they are small beside ways, velocities and forces.
  const unit = units(page.dimension), length = Math.max(...page.runs[0].domain.size), little = 1e-6;
  const way = Math.max(0, ...quantities.filter((q) => unitOf(q.name, page.dimension) === unit.length)
    .flatMap((q) => q.max.map((most, run) => most - q.min[run])).filter(Number.isFinite));
  const least = new Map([[unit.angle, (little * way) / length], [unit.rate, (little * (sizes.get(unit.velocity) ?? 0)) / length],
    [unit.torque, little * (sizes.get(unit.force) ?? 0) * length]]);
  const lively = quantities.filter(({ name, ...values }) => {
    const of = unitOf(name, page.dimension);
    return kinds.some(([kind]) => sizeOf(values[kind]) > (least.get(of) ?? 0) && rangeOf(values[kind])[1] - rangeOf(values[kind])[0] > 1e-9 * sizes.get(of));
  });
  const still = quantities.filter((q) => !lively.includes(q)).map((q) => q.name);
  const chosen = new Set(lively.length <= 12 ? lively : foremost(lively, most, vary));
  const list = plotList(place), plots = () => list.renew(draw);
  choice(bars, "Over", keys.map(({ name }, i) => [i, name]), key, (to) => { key = to; plots(); });
  choice(bars, "Value", kinds, kind, (to) => { kind = to; plots(); });
  chooser(bars, "Quantities", lively, chosen, (quantity) => quantity.name, { text: "vary most", value: vary }, plots);
  if (still.length) bars.append(element("p", { class: "note" }, `Not drawn, the same in all runs or round-off: ${still.join(", ")}.`));

  function draw() {
    const axis = axisOf(keys[key]), others = keys.filter((_, i) => i !== key);
    const groups = new Map(); // the runs of a curve, by the other keys' values
    axis.at.forEach((_, run) => {
      const name = others.map((other) => `${other.name} = ${other.values[run]}`).join(", ");
      if (!groups.has(name)) groups.set(name, []);
      groups.get(name).push(run);
    });
    const x = [...new Set(axis.at)].sort((a, b) => a - b);
    const along = { label: axis.name, words: axis.words, log: inRatios(axis.at) };
    return lively.filter((quantity) => chosen.has(quantity)).map((quantity) => {
      const word = kinds.find(([of]) => of === kind)[1];
      const series = [...groups].map(([name, runs]) => {
        const values = x.map(() => undefined);
        for (const run of runs) values[x.indexOf(axis.at[run])] = Number(quantity[kind][run].toPrecision(10)); // no axis of round-off, which uPlot cannot draw
        return { label: name || word, values };
      });
      return curves(place, `${quantity.name}, ${word}`, x, series, { unit: unitOf(quantity.name, page.dimension), along }, () => {});
    });
  }
  plots();
  return list.redraw;
}
