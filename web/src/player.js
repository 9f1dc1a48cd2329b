// Time slider, play button and keys.

/** Plays the times of frames; show(index) is called for every new one. Returns { go(index), goToTime(time), index(), text(), count, wait }. */
export function player(times, show) {
  const slider = document.getElementById("slider"), play = document.getElementById("play"), now = document.getElementById("now");
  const last = times.length - 1;
  let index = -1, timer = null;
  const wait = Math.round(Math.min(250, Math.max(50, 6000 / (last + 1))));
  slider.max = String(last);
  const apart = Math.max((times[last] - times[0]) / Math.max(last, 1), 1e-9);
  const digits = Math.min(6, Math.max(2, Math.ceil(-Math.log10(apart)) + 1));
  function go(to) {
    const wanted = Math.max(0, Math.min(last, to));
    if (wanted === index) return;
    index = wanted;
    slider.value = String(index);
    now.textContent = `t = ${times[index].toFixed(digits)} · ${index + 1} of ${last + 1}`;
    show(index);
  }
  function stop() {
    clearInterval(timer);
    timer = null;
    play.textContent = "▶";
    play.setAttribute("aria-label", "Play");
  }
  function toggle() {
    if (timer !== null) return stop();
    if (index === last) go(0);
    play.textContent = "❚❚";
    play.setAttribute("aria-label", "Pause");
    // The whole run in about six seconds.
    const advance = () => {
      go(index + 1);
      if (index === last) stop();
    };
    timer = setInterval(advance, wait);
  }
  slider.addEventListener("input", () => { stop(); go(Number(slider.value)); });
  play.addEventListener("click", toggle);
  document.addEventListener("keydown", (event) => {
    const on = event.target;
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (on.closest?.("button, select, summary, a, input:not(#slider)")) return;
    const keys = { " ": toggle, ArrowRight: () => { stop(); go(index + 1); }, ArrowLeft: () => { stop(); go(index - 1); },
      Home: () => { stop(); go(0); }, End: () => { stop(); go(last); } };
    if (!keys[event.key]) return;
    event.preventDefault();
    keys[event.key]();
  });
  play.disabled = slider.disabled = last < 1;
  return { go, index: () => index, count: last + 1, wait, text: () => `t = ${times[index].toFixed(digits)}`, goToTime: (time) => {
    stop();
    go(nearest(times, time));
  } };
}

/** Number of the time nearest to one. */
export function nearest(times, time) {
  let best = 0;
  times.forEach((t, i) => { if (Math.abs(t - time) < Math.abs(times[best] - time)) best = i; });
  return best;
}
