// Plots in one place that are drawn anew together: one mark of the time for all, and their width follows the place's.

/** Returns { renew(make), mark(time), redraw() }; make() gives the plots of curves() that stand in `place` from now on. */
export function plotList(place) {
  let plots = [], marked = null, width = place.clientWidth;
  const mark = (at) => {
    marked = at;
    for (const plot of plots) plot.mark(at);
  };
  new ResizeObserver(() => {
    if (place.clientWidth === width) return;
    width = place.clientWidth;
    for (const plot of plots) plot.resize();
  }).observe(place);
  const renew = (make) => {
    for (const plot of plots) plot.destroy();
    place.replaceChildren();
    plots = make();
    setTimeout(() => mark(marked)); // uPlot finishes its set-up first
  };
  return { renew, mark, redraw: () => plots.forEach((plot) => plot.redraw()) };
}
