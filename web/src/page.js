// Puts the page together; `makeView` is the view for the run's dimension.
import { compare } from "./compare.js";
import { element, frameReader, load } from "./data.js";
import { pictureButtons } from "./export.js";
import { player } from "./player.js";
import { drawPlots, drawProfile } from "./plots.js";
import { drawFacts, drawGaps, drawLimits, drawMachine, drawScene, problem } from "./texts.js";

export async function page(makeView) {
  chooseTheme();
  if (typeof DecompressionStream === "undefined")
    return problem("This browser is too old for the page: it needs one of 2023 or later.");
  const run = await load();
  const redraws = [];
  if (run.runs) {
    compare(run, makeView, redraws);
    return finish(redraws);
  }
  drawFacts(run);
  drawScene(run);
  drawMachine(run);
  drawLimits(run);
  let transport = null;
  const plots = drawPlots(run, (time) => transport?.goToTime(time));
  redraws.push(plots.redraw);
  if (run.frames.length > 0) {
    document.getElementById("view").hidden = false;
    const beside = document.getElementById("beside"), read = frameReader(run);
    const card = (name = "") => beside.appendChild(element("div", { class: name }));
    const hasFilms = run.frames.some((frame) => frame.film.thickness[2] > 0);
    const profile = run.dimension === 2 && hasFilms ? drawProfile(run, card("plot")) : null;
    const gaps = run.tables.gaps.length > 0 ? drawGaps(run, card()) : null;
    const key = (name) => element("kbd", {}, name);
    const pointer = run.dimension === 2 ? "Wheel zooms, drag moves, double click shows all" : "Drag turns, wheel zooms, right drag moves";
    card().append(element("p", { class: "note", style: "margin:0" }, key("space"), " plays, ", key("←"), " ", key("→"),
      ` step. ${pointer}; hover for values.`));
    let view = null;
    try {
      view = makeView(run, { place: document.getElementById("picture"), choices: document.getElementById("choices"),
        scales: document.getElementById("scales"), shared: {} });
    } catch (error) {
      document.getElementById("picture").append(element("p", { class: "note" },
        `The view cannot be drawn here (${error.message}). The plots below do not need it.`));
    }
    transport = player(run.frames.map((frame) => frame.time), (index) => {
      const frame = read(index);
      view?.show(frame);
      profile?.show(frame.film, view?.gapNames?.(frame.film) ?? []);
      gaps?.(frame.time);
      plots.mark(frame.time);
    });
    if (view) document.getElementById("transport").append(...pictureButtons(run.title, () => [{ ...view, name: "" }], transport));
    if (profile) redraws.push(profile.redraw);
    if (view) redraws.push(view.redraw);
    // The midst of the run says more than its start, where most are at rest.
    transport.go(Math.ceil(0.4 * (run.frames.length - 1)));
  }
  finish(redraws);
}

function finish(redraws) {
  document.getElementById("theme").addEventListener("click", () => {
    const root = document.documentElement;
    root.dataset.theme = root.dataset.theme === "dark" ? "light" : "dark";
    for (const redraw of redraws) redraw();
  });
  document.documentElement.dataset.ready = "yes";
}

function chooseTheme() {
  document.documentElement.dataset.theme = matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
}
