// What is shown in the view: choices above it and the colour scales below.
import { element, short } from "./data.js";

/** Buttons of which one is chosen: options [[key, text]]; returns the element. */
export function segments(options, chosen, choose) {
  const box = element("div", { class: "segments", role: "group" });
  for (const [key, text] of options) {
    const button = element("button", { type: "button", "aria-pressed": String(key === chosen) }, text);
    button.onclick = () => {
      for (const other of box.children) other.setAttribute("aria-pressed", String(other === button));
      choose(key);
    };
    box.append(button);
  }
  return box;
}

export function checkbox(text, checked, change) {
  const box = element("input", { type: "checkbox", checked });
  box.onchange = () => change(box.checked);
  return element("label", {}, box, text);
}

/**
 * A colour table with its range: { low, high, log, table, index(value), css(value), value(share) }. Logarithmic with both signs: on both sides
 * of 0, linear below a thousandth of the largest.
 */
export function colours(run, name) {
  const { table, low, high } = run.colours[name];
  const map = { low, high, first: [low, high], log: false, table: run.numbers(table), version: 0 };
  const bend = () => {
    if (!map.log) return [(v) => v, (v) => v];
    if (map.low > 0) return [(v) => Math.log(Math.max(v, 1e-300)), Math.exp];
    const c = 1e-3 * Math.max(Math.abs(map.low), Math.abs(map.high)) || 1;
    return [(v) => Math.asinh(v / c), (v) => c * Math.sinh(v)];
  };
  let [there, back] = bend(), from = map.low, width = map.high - map.low;
  map.set = (change) => {
    Object.assign(map, change);
    [there, back] = bend();
    from = there(map.low);
    width = there(map.high) - from || 1;
    ++map.version;
  };
  map.index = (value) => 3 * Math.max(0, Math.min(255, Math.round((255 * (there(value) - from)) / width)));
  map.css = (value) => { const i = map.index(value); return `rgb(${map.table[i]},${map.table[i + 1]},${map.table[i + 2]})`; };
  map.value = (share) => back(from + share * width);
  return map;
}

/** Colour bars with title, ends and their settings; changed() is called for another range. */
export function drawScales(place, scales, changed) {
  place.replaceChildren(...scales.map(([title, map]) => {
    const canvas = element("canvas", { width: 256, height: 1, "aria-hidden": "true" }), ticks = element("div", { class: "ticks" });
    const paint = () => {
      const context = canvas.getContext("2d"), image = context.createImageData(256, 1);
      for (let i = 0; i < 256; ++i) {
        image.data.set(map.table.subarray(3 * i, 3 * i + 3), 4 * i);
        image.data[4 * i + 3] = 255;
      }
      context.putImageData(image, 0, 0);
      ticks.replaceChildren(...[0, 0.25, 0.5, 0.75, 1].map((s) => element("span", {}, short(Number(map.value(s).toPrecision(3))))));
    };
    const end = (key, word) => {
      const input = element("input", { type: "number", step: "any", value: String(Number(map[key].toPrecision(4))), "aria-label": `${word} of ${title}` });
      input.onchange = () => {
        const value = Number(input.value), other = key === "low" ? map.high : map.low;
        if (input.value === "" || !(key === "low" ? value < other : value > other)) return void (input.value = String(Number(map[key].toPrecision(4))));
        map.set({ [key]: value });
        paint();
        changed();
      };
      return input;
    };
    const low = end("low", "Low end"), high = end("high", "High end");
    const log = checkbox("logarithmic", map.log, (on) => { map.set({ log: on }); paint(); changed(); });
    const reset = element("button", { type: "button" }, "as at first");
    reset.onclick = () => {
      map.set({ low: map.first[0], high: map.first[1], log: false });
      low.value = String(Number(map.low.toPrecision(4)));
      high.value = String(Number(map.high.toPrecision(4)));
      log.firstChild.checked = false;
      paint();
      changed();
    };
    paint();
    return element("div", { class: "scale" }, element("span", { class: "title" }, title), canvas, ticks,
      element("details", { class: "ends" }, element("summary", {}, "Scale"), element("div", { class: "bar" }, "from", low, "to", high, log, reset)));
  }));
}

/** A box next to the pointer; returns show(text or null, x, y). */
export function tip(place) {
  const box = element("div", { class: "tip", hidden: true });
  place.append(box);
  return (text, x, y) => {
    box.hidden = text === null;
    if (text === null) return;
    box.textContent = text;
    const left = x + 16 + box.offsetWidth > place.clientWidth ? x - 12 - box.offsetWidth : x + 16;
    const top = y + 16 + box.offsetHeight > place.clientHeight ? y - 12 - box.offsetHeight : y + 16;
    box.style.left = `${Math.max(0, left)}px`;
    box.style.top = `${Math.max(0, top)}px`;
  };
}
