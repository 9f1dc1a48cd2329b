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

/** A colour table with its range: { low, high, table, index(value) }. */
export function colours(run, name) {
  const { table, low, high } = run.colours[name];
  const map = { low, high, table: run.numbers(table) };
  map.index = (value) => 3 * Math.max(0, Math.min(255, Math.round((255 * (value - map.low)) / (map.high - map.low))));
  map.css = (value) => { const i = map.index(value); return `rgb(${map.table[i]},${map.table[i + 1]},${map.table[i + 2]})`; };
  return map;
}

/** Colour bars with title and ends. */
export function drawScales(scales) {
  document.getElementById("scales").replaceChildren(...scales.map(([title, map]) => {
    const canvas = element("canvas", { width: 256, height: 1, "aria-hidden": "true" });
    const context = canvas.getContext("2d"), image = context.createImageData(256, 1);
    for (let i = 0; i < 256; ++i) {
      image.data.set(map.table.subarray(3 * i, 3 * i + 3), 4 * i);
      image.data[4 * i + 3] = 255;
    }
    context.putImageData(image, 0, 0);
    const ticks = [0, 0.25, 0.5, 0.75, 1].map((s) => element("span", {}, short(Number((map.low + s * (map.high - map.low)).toPrecision(3)))));
    return element("div", { class: "scale" }, element("span", { class: "title" }, title), canvas, element("div", { class: "ticks" }, ...ticks));
  }));
}

/** A box next to the pointer; returns show(text or null, x, y). */
export function tip(place) {
  const box = element("div", { id: "tip", hidden: true });
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
