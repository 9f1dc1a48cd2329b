// Which bodies or gaps are drawn: a button each where there are few; where there are many those chosen, a search, and the first few of an
// order ("moved furthest").
import { element } from "./data.js";

const few = 12;

/** `list`: entries; `chosen`: a Set of them, which changes; name(entry); `order`: { text, value(entry) }, largest first. */
export function chooser(place, label, list, chosen, name, order, changed) {
  if (list.length < 2) return;
  const box = element("div", { class: "chooser" });
  place.append(box);
  const chip = (entry, pressed) => {
    const button = element("button", { type: "button", "aria-pressed": String(pressed) }, name(entry));
    button.onclick = () => {
      chosen.has(entry) ? chosen.delete(entry) : chosen.add(entry);
      draw();
      changed();
    };
    return button;
  };
  const ranked = () => [...list].sort((a, b) => order.value(b) - order.value(a));
  const names = new Map(list.map((entry) => [name(entry), entry]));
  function draw() {
    if (list.length <= few) return box.replaceChildren(element("span", {}, label), ...list.map((entry) => chip(entry, chosen.has(entry))));
    const known = `names-${label.toLowerCase().replaceAll(" ", "-")}`;
    const search = element("input", { type: "search", placeholder: `add one of ${list.length}`, list: known, "aria-label": `Add to ${label}` });
    search.setAttribute("list", known);
    search.onchange = () => {
      const entry = names.get(search.value) ?? list.find((e) => name(e).toLowerCase().includes(search.value.toLowerCase()));
      if (!entry || !search.value) return;
      chosen.add(entry);
      draw();
      changed();
    };
    const first = element("select", { "aria-label": `${label} that ${order.text}` }, element("option", { value: "" }, `those that ${order.text}`),
      ...[5, 10, 20].map((n) => element("option", { value: String(n) }, `the ${n} that ${order.text}`)));
    first.onchange = () => {
      if (!first.value) return;
      chosen.clear();
      for (const entry of ranked().slice(0, Number(first.value))) chosen.add(entry);
      draw();
      changed();
    };
    box.replaceChildren(element("span", {}, label), ...list.filter((e) => chosen.has(e)).map((e) => chip(e, true)), search,
      element("datalist", { id: known }, ...[...names.keys()].map((n) => element("option", { value: n }))), first);
  }
  draw();
}

/** The first of an order, for the start. */
export const foremost = (list, count, value) => [...list].sort((a, b) => value(b) - value(a)).slice(0, count);
