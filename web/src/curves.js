// One plot over time, or over the values of a key: a card with a title, axes with units, scales to choose, and files of what it shows. uPlot, all with one cursor.
import uPlot from "uplot";
import { csvOf, download, fileName, svgOf } from "./export.js";
import { css, element, short } from "./data.js";

// Okabe and Ito's colours for any colour vision, in an order that keeps neighbours apart; the page's text colour stands for black.
// On dark the same hues, lighter.
const palettes = {
  light: ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#1b2330", "#8c6d31"],
  dark: ["#58b0ee", "#ff8a4c", "#2bc79b", "#e39bc5", "#f0b93a", "#b7a8ff", "#e4e9f0", "#c9a66b"],
};
const colours = 8;
export const colour = (i) => palettes[document.documentElement.dataset.theme === "dark" ? "dark" : "light"][i % colours];
const dashes = [undefined, [7, 4], [2, 3]];
export const dash = (i) => dashes[Math.floor(i / colours) % dashes.length];
export const lineStyle = (i) => ["solid", "dashed", "dotted"][Math.floor(i / colours) % dashes.length]; // the same of a border
export const rangeOf = (values) => {
  let low = Infinity, high = -Infinity;
  for (const v of values) if (Number.isFinite(v)) { low = Math.min(low, v); high = Math.max(high, v); }
  return [low, high];
};

export const axisStyle = () => {
  const stroke = () => css("--soft"), grid = { stroke: () => css("--grid"), width: 1 };
  return { stroke, grid, ticks: grid, font: "12px system-ui, sans-serif", labelFont: "12px system-ui, sans-serif", labelSize: 18 };
};
const height = 226;
const logTick = (v) => (v !== null && /^-?[15]/.test(v.toExponential()) ? short(v) : ""); // 1 and 5 of a decade

// Ticks of a scale that is logarithmic on both sides of 0: powers of ten, every second or third where there are many.
function bothSides(least, most) {
  const low = Math.round(Math.log10(least)), high = Math.floor(Math.log10(most) + 1e-9), step = Math.max(1, Math.ceil((high - low) / 3)), powers = [];
  for (let k = high; k >= low; k -= step) powers.push(10 ** k);
  return [...powers.map((v) => -v), 0, ...powers.reverse()];
}

// The values between which all but a hundredth at each end lie.
function middle(series) {
  const all = series.flatMap((s) => s.values.filter(Number.isFinite)).sort((a, b) => a - b);
  const low = all[Math.floor(0.01 * (all.length - 1))], high = all[Math.ceil(0.99 * (all.length - 1))], margin = 0.06 * (high - low) || 1;
  return [low - margin, high + margin];
}

/**
 * A card in `place` with a plot of series [{ label, values, look }] over `time`; `look`: number of colour and dash, else its own.
 * options: unit, log (logarithmic at first), zero (from 0), legend(series, row), note. choose(time) is called for a click. `along` in place of
 * time: { label, log, words }; words stand for 0, 1, 2 ...
 * Returns { mark(time), redraw(), resize(), destroy() }.
 */
export function curves(place, title, time, series, options, choose) {
  const state = { log: Boolean(options.log), clip: false };
  const heading = element("h3", {}), tools = element("span", { class: "tools" });
  const card = element("div", { class: "plot card" }, element("div", { class: "head" }, heading, tools));
  place.append(card);
  const looks = series.map((s, i) => s.look ?? i);
  let plot = null, marked = null;

  const toggle = (name, text, what) => {
    const button = element("button", { type: "button", title: what, "aria-pressed": String(state[name]) }, text);
    button.onclick = () => {
      state[name] = !state[name];
      button.setAttribute("aria-pressed", String(state[name]));
      draw();
      setTimeout(() => mark(marked)); // uPlot finishes its set-up first
    };
    return button;
  };
  const saver = (text, what, save) => {
    const button = element("button", { type: "button", title: what }, text);
    button.onclick = save;
    return button;
  };
  const clean = title.replace(/ \(.*/, ""), along = options.along ?? { label: "time" };
  // uPlot's own logarithmic axis takes whole decades only: places are logarithms, ticks the values.
  const places = along.log ? time.map(Math.log10) : Array.from(time), from = places[0], to = places[places.length - 1];
  const at = (v) => (along.words ? along.words[v] ?? "" : short(along.log ? 10 ** v : v));
  const every = Math.ceil(places.length / 6);
  // uPlot finds no ticks for values below some 1e-16, as energies of small things in SI units are: such are drawn in another power of ten.
  const whole = Math.max(...series.flatMap((s) => rangeOf(s.values).map(Math.abs)).filter(Number.isFinite), 0);
  const power = whole > 0 && whole < 1e-6 ? 10 ** Math.floor(Math.log10(whole)) : 1, shown = (v) => (v === null ? v : v * power);
  const scaled = power === 1 ? series : series.map((s) => ({ values: s.values.map((v) => (v === undefined ? v : v / power)) }));
  const acrossAxis = along.words ? { range: [-0.4, along.words.length - 0.6] } : along.log ? { range: [from - 0.04 * (to - from), to + 0.04 * (to - from)] } : {};
  const ticksAcross = along.words ? { splits: () => along.words.map((_, i) => i) } : along.log ? { splits: () => places.filter((_, i) => i % every === 0) } : {};
  tools.append(toggle("log", "log", "Logarithmic scale; where values have both signs, logarithmic on both sides of 0"),
    toggle("clip", "clip", "Leaves the largest and the smallest hundredth of the values out of the scale"),
    saver("SVG", "This plot as a picture of lines", () => download(fileName(clean, "svg"), svgOf(plot, title, [along.label, options.unit],
      series.map((s, i) => ({ label: s.label, colour: palettes.light[looks[i] % colours], dash: dash(looks[i]) }))), "image/svg+xml")),
    saver("CSV", "The values of this plot as a table", () => download(fileName(clean, "csv"),
      csvOf([along.label, ...series.map((s) => s.label)], [Array.from(time), ...series.map((s) => s.values)]), "text/csv")));

  function draw() {
    plot?.destroy();
    const positive = scaled.every((s) => s.values.every((v) => !(v <= 0)));
    const largest = Math.max(...scaled.flatMap((s) => rangeOf(s.values).map(Math.abs)).filter(Number.isFinite), 1e-300);
    const least = 10 ** Math.floor(Math.log10(largest * 1e-3)); // linear below
    heading.textContent = title + (state.log ? (positive ? ", logarithmic" : ", logarithmic on both sides of 0") : "");
    const range = state.clip ? { range: () => middle(scaled) } : options.zero && !state.log ? { range: (u, low, high) => [0, high > 0 ? 1.08 * high : 1] } : {};
    const y = state.log ? (positive ? { distr: 3, ...(state.clip ? { range: () => middle(scaled).map((v, i) => (i || v > 0 ? v : largest * 1e-6)) } : {}) }
      : { distr: 4, asinh: least, ...range }) : { distr: 1, ...range };
    const axis = axisStyle();
    plot = new uPlot({
      width: card.clientWidth - 34, height,
      scales: { x: { time: false, ...acrossAxis }, y },
      axes: [{ ...axis, size: 32, label: along.label, values: (u, ticks) => ticks.map(at), ...ticksAcross }, { ...axis, size: 62, label: options.unit, values: (u, ticks) => ticks.map(shown).map(state.log && positive ? logTick : short),
        ...(state.log && !positive ? { splits: () => bothSides(least, largest) } : {}) }],
      cursor: { ...(options.along ? {} : { sync: { key: "gapflow" } }), drag: { x: true, y: false }, points: { size: 7 } },
      legend: { live: true, markers: { dash: (u, i) => lineStyle(looks[i - 1] ?? 0) } },
      series: [{ label: along.label, value: (u, v) => (v === null ? "–" : at(v)) }, ...series.map((s, i) => ({
        label: s.label, stroke: () => colour(looks[i]), width: 1.6, dash: dash(looks[i]), spanGaps: false,
        points: { show: options.along ? true : time.length < 40 ? undefined : false },
        value: (u, v, k, index) => {
          if (index === null || index === undefined) return "–";
          while (index > 0 && s.values[index] === undefined) --index; // other runs' times: this one's last before
          return options.legend ? options.legend(s, index) : short(s.values[index]);
        },
      }))],
      hooks: { draw: [(u) => u.now && moveMark()] },
    }, [places, ...scaled.map((s) => s.values.map((v) => (Number.isFinite(v) ? v : v === undefined ? undefined : null)))]);
    card.insertBefore(plot.root, card.children[1] ?? null);
    plot.now = element("div", { class: "now" });
    plot.over.append(plot.now);
    plot.over.addEventListener("mouseleave", () => setTimeout(() => mark(marked)));
    let pressed = null;
    plot.over.addEventListener("mousedown", (event) => (pressed = event.clientX));
    plot.over.addEventListener("click", (event) => {
      if (pressed !== null && Math.abs(event.clientX - pressed) < 4) choose(plot.posToVal(event.offsetX, "x"));
    });
  }
  function moveMark() {
    const x = marked === null ? -1 : plot.valToPos(marked, "x");
    plot.now.hidden = !(x >= 0 && x <= plot.over.clientWidth);
    plot.now.style.transform = `translateX(${x}px)`;
  }
  function mark(at) {
    marked = at;
    if (at === null) return;
    let row = time.findIndex((t) => t >= at * (1 - 1e-12));
    if (row < 0) row = time.length - 1;
    moveMark();
    plot.setLegend({ idx: row }, false); // the values of that time, while no pointer asks for another
  }
  draw();
  if (options.note) card.append(element("p", { class: "note" }, options.note));
  return { mark, redraw: () => plot.redraw(false, true), destroy: () => plot.destroy(),
    resize: () => plot.setSize({ width: card.clientWidth - 34, height }) };
}

/**
 * The series that change by more than round-off, with the others named: { drawn, still }; null where none does. options.least: a plot whose
 * curves all change less is left out, and options.skipped() is called. options.keep: where none changes, all that are not 0.
 */
export function lively(series, options = {}) {
  const ranges = series.map((s) => rangeOf(s.values));
  const widest = Math.max(...ranges.map(([low, high]) => high - low), 0);
  const scale = Math.max(...ranges.map(([low, high]) => Math.max(Math.abs(low), Math.abs(high))).filter(Number.isFinite), 0);
  if (options.least !== undefined && widest <= options.least) {
    if (widest > 0) options.skipped?.();
    return null;
  }
  const nonzero = (values) => values.some((v) => Number.isFinite(v) && v !== 0);
  const change = (i) => ranges[i][1] - ranges[i][0] > Math.max(1e-4 * widest, 1e-12 * scale);
  const moving = series.some((s, i) => change(i));
  const drawn = series.filter((s, i) => change(i) || ((series.length === 1 || (options.keep && !moving)) && nonzero(s.values)));
  if (drawn.length === 0) return null;
  return { drawn, still: series.filter((s) => !drawn.includes(s) && s.values.length) };
}

/** Whether a logarithmic scale says more of positive series: they span more than a factor of four. */
export const spansMuch = (series) => series.every((s) => s.values.every((v) => !(v <= 0)))
  && Math.max(...series.map((s) => rangeOf(s.values)[1])) > 4 * Math.min(...series.map((s) => rangeOf(s.values)[0]));
