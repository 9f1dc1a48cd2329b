// What a scene asks to be measured: fluxes, points of probes, and bodies with the parts of their forces.
import { foremost } from "./chooser.js";
import { rangeOf } from "./curves.js";
import { short } from "./data.js";
import { units } from "./units.js";

const most = 6; // fluxes and points drawn at first
const forceParts = ["pressure", "shear", "film", "contact", "buoyancy"];

/** The entries of a run's tables, a list a kind; `name` is what a plot calls them. */
export function measuresOf(run) {
  const probes = run.tables.probes.map((probe) => ({ ...probe, name: probe.points > 1 ? `${probe.name} (${probe.place.map(short).join(", ")})` : probe.name }));
  return { fluxes: run.tables.fluxes, probes, forces: run.tables.forces };
}

/** What a kind is called, and what orders its entries. */
export const measureKinds = {
  fluxes: { label: "Fluxes", text: "vary most", of: (column) => (entry) => spread([column(entry, "flux")]) },
  probes: { label: "Probes", text: "vary most", of: (column) => (entry) => spread(["pressure", "u", "v", "w"].map((name) => column(entry, name))) },
  forces: { label: "Parts of forces on", text: "are pushed most", of: (column) => (entry) => pushed(entry, column) },
};

const spread = (lists) => Math.max(0, ...lists.map(rangeOf).map(([low, high]) => high - low).filter(Number.isFinite));
const pushed = (entry, column) => Math.max(0, ...["fx", "fy", "fz"].flatMap((axis) => forceParts.flatMap((part) => rangeOf(column(entry, `${part}_${axis}`))))
  .filter(Number.isFinite).map(Math.abs));

/** Those of a kind that are drawn at first: fluxes and probes in the scene's order, the two bodies that are pushed most. */
export const foremostOf = (kind, list, value) => new Set(kind === "forces" ? foremost(list, 2, value) : list.slice(0, most));

/** Plots of fluxes and probes. Those written at different times have plots of their own. */
export function measurePlots(run, column, { fluxes, probes }) {
  const unit = units(run.dimension);
  const plots = (entries, title, size, columns) => {
    const lists = new Map();
    for (const entry of entries) {
      const time = Array.from(run.numbers(entry.time)), key = time.join();
      if (time.length < 2) continue;
      if (!lists.has(key)) lists.set(key, { title, unit: size, time, series: [], keep: true });
      for (const [name, label] of columns) {
        const values = column(entry, name);
        if (values.some(Number.isFinite)) lists.get(key).series.push({ label: label ? `${entry.name} ${label}` : entry.name, values });
      }
    }
    return [...lists.values()].filter(({ series }) => series.length);
  };
  const spins = run.dimension === 2 ? [["vorticity", ""]] : ["x", "y", "z"].map((axis) => [`vorticity_${axis}`, axis]);
  return [
    ...plots(fluxes, "Flux", unit.flux, [["flux", ""]]),
    ...plots(fluxes, "Inflow and outflow", unit.flux, [["inflow", "in"], ["outflow", "out"]]),
    ...plots(fluxes, "Part of the flux in films", unit.flux, [["film", ""]]),
    ...plots(probes, "Pressure at probes", unit.pressure, [["pressure", ""]]),
    ...plots(probes, "Velocity at probes", unit.velocity, [["u", "u"], ["v", "v"], ["w", "w"]]),
    ...plots(probes, "Vorticity at probes", unit.divergence, spins),
  ];
}

/** Plots of the parts of the force on bodies, one an axis. */
export function forcePlots(run, column, bodies) {
  const unit = units(run.dimension), flat = run.dimension === 2, length = Math.max(...run.domain.size);
  return bodies.flatMap((body) => {
    const time = Array.from(run.numbers(body.time)), little = 1e-6 * pushed(body, column);
    if (time.length < 2) return [];
    const plot = (axis, word, size, least) => ({ title: `Parts of the ${word} on ${body.name}`, unit: size, time, least,
      series: forceParts.map((part) => ({ label: part, values: column(body, `${part}_${axis}`) })).filter((s) => s.values.length) });
    return [...(flat ? ["fx", "fy"] : ["fx", "fy", "fz"]).map((axis) => plot(axis, `force ${axis}`, unit.force, little)),
      ...(flat ? [["torque", "torque"]] : ["tx", "ty", "tz"].map((axis) => [axis, `torque ${axis}`]))
        .map(([axis, word]) => plot(axis, word, unit.torque, little * length))];
  });
}
