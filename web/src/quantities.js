// The quantities of a run's tables that plots show: title, unit, series.
import { short } from "./data.js";
import { forcePlots, measurePlots } from "./measures.js";
import { units } from "./units.js";

export const gapName = (gap) => `${gap.a} – ${gap.b}`;

/** A column of an entry of the tables; a crowd's is made of its bodies'. */
export function reader(run) {
  const kept = new Map();
  return function column(entry, name) {
    if (!entry.members) return entry.columns[name] ? Array.from(run.numbers(entry.columns[name])) : [];
    const key = `${entry.name} ${name}`;
    if (!kept.has(key)) {
      const all = entry.members.map((body) => column(body, name)).filter((values) => values.length);
      kept.set(key, (all[0] ?? []).map((_, i) => entry.of(all.map((values) => values[i]))));
    }
    return kept.get(key);
  };
}

/** Bodies that move, and of every crowd its mean, smallest and largest. Without crowds' bodies among `own`. */
export function bodiesOf(run) {
  const bodies = run.tables.bodies.filter((body) => body.motion !== "fixed");
  const crowds = (run.scene.crowd ?? []).map((crowd) => ({ crowd, members: bodies.filter((b) => b.name.startsWith(`${crowd.name}_`)) }))
    .filter(({ members }) => members.length > 1);
  const groups = crowds.flatMap(({ crowd, members }) => [["mean", (v) => v.reduce((a, b) => a + b, 0) / v.length],
    ["smallest", (v) => Math.min(...v)], ["largest", (v) => Math.max(...v)]]
    .map(([word, of]) => ({ name: `${crowd.name}: ${word} of ${members.length}`, members, of, columns: members[0].columns, mean: word === "mean" })));
  return { bodies, groups };
}

/** How far a body is from its start. */
export function way(run, column) {
  return (body) => Math.hypot(...["x", "y", "z"].slice(0, run.dimension).map((name) => {
    const values = column(body, name);
    return values.length ? values[values.length - 1] - values[0] : 0;
  })) || 0;
}

const sinceStart = (v) => v.map((x) => x - v[0]);

/**
 * All plots: [{ title, unit, series: [{ label, values, raw? }], options }]. `bodies`, `gaps`, `measures`: those chosen; `of`: all bodies, by which
 * round-off is judged. A plot with `sole` has one curve, which its title names; one with `time` has times of its own. `alone`: title of a series that has a
 * plot to itself, where several runs are compared.
 */
export function plotsOf(run, column, bodies, gaps, measures, of) {
  const unit = units(run.dimension), names = run.dimension === 2 ? ["x", "y"] : ["x", "y", "z"];
  const axes = (prefix) => names.map((a) => [prefix + a, prefix + a]);
  const ofBodies = (columns, change = (v) => v) => bodies.flatMap((body) => columns.flatMap(([name, label]) => {
    const raw = column(body, name);
    return raw.length ? [{ label: label ? `${body.name} ${label}` : body.name, values: change(raw), raw }] : [];
  }));
  const ofGaps = (columns) => gaps.flatMap((gap) =>
    columns.map(([name, label, alone]) => ({ label: label ? `${gapName(gap)} ${label}` : gapName(gap), values: column(gap, name),
      ...(alone ? { alone: `${alone}: ${gapName(gap)}` } : {}) })));
  const largest = (prefix, change = (v) => v) => {
    let most = 0;
    for (const body of of) for (const [name] of axes(prefix)) for (const v of change(column(body, name))) if (Math.abs(v) > most) most = Math.abs(v);
    return most;
  };
  const length = Math.max(...run.domain.size), little = 1e-6;
  const moved = (little * largest("", sinceStart)) / length, turning = (little * largest("v")) / length, torque = little * largest("f") * length;
  const turned = () => bodies.filter((body) => !body.members).map((body) => {
    const q = ["qw", "qx", "qy", "qz"].map((name) => column(body, name));
    return { label: body.name, values: (q[0] ?? []).map((_, i) => 2 * Math.acos(Math.min(1, Math.abs(q.reduce((sum, c) => sum + c[i] * c[0], 0))))) };
  });
  const table = { columns: run.tables.steps }, step = (name) => column(table, name);
  const after = (name) => step(name).map((v, i) => (i === 0 ? NaN : v)); // the start is no step
  const fluid = step("energy_fluid"), solid = step("energy_bodies");
  return [
    { title: "Position (change since the start)", unit: unit.length, series: ofBodies(axes(""), sinceStart), legend: (s, i) => short(s.raw[i]) },
    { title: "Velocity", unit: unit.velocity, series: ofBodies(axes("v")) },
    ...(run.dimension === 2 ? [
      { title: "Angle (rad)", unit: unit.angle, series: ofBodies([["angle", ""]]), least: moved },
      { title: "Angular velocity", unit: unit.rate, series: ofBodies([["omega", ""]]), least: turning }] : [
      { title: "Turned since the start (rad)", unit: unit.angle, series: turned(), least: moved },
      { title: "Angular velocity", unit: unit.rate, series: ofBodies(axes("w")), least: turning }]),
    { title: "Force of the fluid", unit: unit.force, series: ofBodies(axes("f")) },
    { title: "Torque of the fluid", unit: unit.torque, series: ofBodies(run.dimension === 2 ? [["torque", ""]] : axes("t")), least: torque },
    { title: "Gap thickness", unit: unit.length, series: ofGaps([["thickness", ""]]), log: true },
    { title: "Opening rate of gaps", unit: unit.velocity, series: ofGaps([["opening_rate", ""]]) },
    { title: "Film pressure, smallest and largest", unit: unit.pressure, series: ofGaps([["pressure_min", "min", "Smallest film pressure"], ["pressure_max", "max", "Largest film pressure"]]) },
    { title: "Force of films", unit: unit.force, series: ofGaps([["force", ""]]) },
    { title: "Contact force", unit: unit.force, series: ofGaps([["contact_force", ""]]).filter((s) => s.values.some((v) => Number.isFinite(v) && v !== 0)) },
    ...measurePlots(run, column, measures),
    ...forcePlots(run, column, measures.forces),
    { title: "Kinetic energy", unit: unit.energy, series: [{ label: "fluid", values: fluid },
      ...(of.length ? [{ label: "bodies", values: solid }, { label: "both", values: fluid.map((e, i) => e + solid[i]) }] : [])] },
    { title: "Step size", unit: unit.time, series: [{ label: "Δt", values: after("dt") }], log: true, sole: true },
    { title: "Iterations of the solver", unit: unit.count, series: [{ label: "iterations", values: step("iterations") }], zero: true, sole: true },
    { title: "Largest divergence", unit: unit.divergence, series: [{ label: "divergence", values: after("divergence_max") }], log: true, sole: true },
    { title: "Time of a step (seconds)", unit: unit.seconds, series: [{ label: "seconds", values: after("seconds") }], zero: true, sole: true },
  ];
}
