// Facts, scene, machine: the page's tables.
import { element, short } from "./data.js";

const list = (values) => values.map(short).join(" × ");
const vector = (v) => (Array.isArray(v) ? `(${v.map(short).join(", ")})` : short(v));

function table(rows, kind = "data") {
  return element("table", { class: kind }, element("tbody", {}, ...rows.map((row) => element("tr", {},
    ...row.map((cell, i) => element(i === 0 ? "th" : "td", i === 0 ? { scope: "row" } : {}, cell))))));
}

// A run's cells along each axis; a record of an earlier version has those of a uniform grid alone.
const cellsOf = ({ record, scene }) => record.cells ?? scene.domain.cells;

export function drawFacts(run) {
  const { record, scene } = run;
  const facts = document.getElementById("facts");
  facts.append(element("span", { class: `status ${record.status}` }, record.status));
  const end = scene.time?.end;
  for (const text of [
    `${run.dimension}D, ${list(cellsOf(run) ?? [])} cells`,
    `${record.steps} ${record.steps === 1 ? "step" : "steps"} to time ${short(record.time)}${end && record.time < end ? ` of ${short(end)}` : ""}`,
    `computed in ${short(record.timings?.total_seconds)} seconds`])
    facts.append(element("span", {}, text));
  if (record.message) problem(`The run failed: ${record.message}`);
}

export function problem(text) {
  const place = document.getElementById("problem");
  place.textContent = text;
  place.hidden = false;
}

const side = (value) => (typeof value === "string" ? value
  : Object.entries(value).map(([key, v]) => `${key} ${Array.isArray(v) ? vector(v) : v}`).join(", "));

const shape = (body) => {
  const sizes = ["size", "radius", "length", "normal", "file"].filter((key) => key in body)
    .map((key) => `${key} ${typeof body[key] === "string" ? body[key] : vector(body[key])}`);
  return `${body.shape}${body.inside_out ? ", inside out" : ""}: ${sizes.join(", ")}`;
};

const driven = (body) => {
  const parts = [];
  const nonzero = (v) => [v].flat().some((x) => x !== 0);
  if (body.free) parts.push(`free along ${body.free.join(", ")}`);
  for (const key of ["velocity", "angular_velocity", "force", "torque"])
    if (key in body && nonzero(body[key])) parts.push(`${key.replace("_", " ")} ${vector(body[key])}`);
  if (body.motion_file) parts.push(`file ${body.motion_file}`);
  if (body.hinge) parts.push(`hinge at ${vector(body.hinge.point)}`);
  if (body.spring) {
    const { anchor, stiffness, damping } = body.spring;
    parts.push(`spring to ${vector(anchor)}, stiffness ${short(stiffness)}, damping ${short(damping)}`);
  }
  return parts.join("; ");
};

export function drawScene(run) {
  const { scene } = run;
  const place = document.getElementById("scene");
  const head = ["body", "shape", "position", "density or mass", "motion", ""];
  const most = 20;
  const bodies = element("table", { class: "data" },
    element("thead", {}, element("tr", {}, ...head.map((name) => element("th", { scope: "col" }, name)))),
    element("tbody", {}, ...scene.body.slice(0, most).map((body) => {
      const weight = body.mass !== undefined ? `mass ${short(body.mass)}` : short(body.density);
      const cells = [body.name, shape(body), vector(body.position), weight, body.motion, driven(body)];
      return element("tr", {}, ...cells.map((cell) => element("td", {}, cell)));
    })));
  const { domain, fluid, gap, contact, time } = scene;
  const rows = [
    ["domain", `${list(domain.size)} from ${vector(domain.origin)}, ${list(cellsOf(run) ?? [])} cells of ${short(run.domain.spacing)}${
      domain.core ? ` in a core from ${vector(domain.core.low)} to ${vector(domain.core.high)}, growing by ${short(domain.growth)} at most outside` : ""}`],
    ...(domain.follow ? [["follows", `${domain.follow.body} along ${domain.follow.axes.join(", ")}`]] : []),
    ["sides", Object.entries(domain.sides).map(([name, value]) => `${name}: ${side(value)}`).join(", ")],
    ["fluid", `density ${short(fluid.density)}, viscosity ${short(fluid.viscosity)}, reference pressure ${short(fluid.reference_pressure)}`],
    ["gravity", vector(scene.gravity)],
    ["gaps", `model ${gap.model}, threshold ${gap.threshold}${gap.threshold === "auto" ? "" : " cells"}, ` +
      `roughness ${short(gap.roughness)}, exit ${gap.exit}`],
    ["contact", `${gap.contact}, restitution ${short(contact.restitution)}, friction ${short(contact.friction)}`],
    ["time", `${time.end !== undefined ? `to ${short(time.end)}, ` : ""}` +
      `${time.max_step !== undefined ? `steps of ${short(time.max_step)} at most, ` : ""}cfl ${short(time.cfl)}, gap cfl ${short(time.gap_cfl)}`],
    ["solver", `${scene.solver.backend}, tolerance ${short(scene.solver.tolerance)}`],
    ["grid", `${scene.grid.fractions}, advection ${scene.grid.advection}`]];
  place.append(element("div", { class: "card scroll" }, bodies,
    ...(scene.body.length > most ? [element("p", { class: "note" }, `and ${scene.body.length - most} more bodies, below`)] : [])));
  place.append(element("div", { class: "card scroll", style: "margin-top:16px" }, table(rows)));
  place.append(element("details", {}, element("summary", {}, "The resolved scene, all keys"),
    element("pre", {}, JSON.stringify(scene, null, 2))));
}

export function drawMachine(run) {
  const { machine = {}, timings = {}, peak_memory_bytes: memory = {}, version } = run.record;
  const place = document.getElementById("machine");
  const mebibytes = (bytes) => (bytes === undefined ? "–" : `${short(bytes / 1048576)} MiB`);
  const facts = table([
    ["Gapflow", version ?? "–"], ["processor", machine.cpu ?? "–"], ["cores of the machine", String(machine.cores ?? "–")],
    ["ranks × threads", `${machine.ranks ?? "–"} × ${machine.threads ?? "–"}`], ["time", `${short(timings.total_seconds)} seconds`],
    ["peak memory", machine.ranks > 1 ? `${mebibytes(memory.sum)}, largest rank ${mebibytes(memory.largest_rank)}` : mebibytes(memory.sum)]]);
  const stages = Object.entries(timings.stages ?? {}).sort((a, b) => b[1].seconds - a[1].seconds);
  const longest = Math.max(...stages.map(([, stage]) => stage.seconds), 1e-300);
  const rows = stages.map(([name, stage]) => element("tr", {}, element("td", {}, name), element("td", {}, short(stage.seconds) + " s"),
    element("td", { class: "share" }, element("div", { style: `width:${(100 * stage.seconds) / longest}%` }))));
  place.append(element("div", { class: "columns" }, element("div", { class: "card scroll" }, facts),
    element("div", { class: "card scroll" }, rows.length
      ? element("table", { class: "data stages", style: "width:100%" }, element("tbody", {}, ...rows))
      : element("p", { class: "note" }, "No stage has been timed."))));
}

export function drawLimits(run) {
  const parts = [];
  if (run.frames.length < run.frames_of_run) parts.push(`${run.frames.length} of ${run.frames_of_run} output times are in this page`);
  const steps = run.tables.time[2];
  if (steps < run.tables.of) parts.push(`${steps} of ${run.tables.of} steps are in the plots`);
  const plane = run.frames[0]?.planes[0];
  if (plane && plane.spacing > 1.01 * run.domain.spacing)
    parts.push(`fields are shown ${Math.round(plane.spacing / run.domain.spacing)} times coarser than computed`);
  const text = parts.length ? `To keep it small: ${parts.join("; ")}. The run's folder has everything. ` : "";
  document.getElementById("limits").textContent =
    `${text}Units are those of the scene. Made by gapflow report; plots by uPlot` +
    `${run.dimension === 3 ? ", 3D by three.js" : ""} (MIT licence, in this file).`;
}

/** What every gap has at a time: returns show(time). */
export function drawGaps(run, card) {
  const time = run.numbers(run.tables.time);
  const get = (gap, name) => run.numbers(gap.columns[name]);
  const moves = (name) => run.tables.bodies.some((body) => body.name === name && body.motion !== "fixed");
  const gaps = run.tables.gaps.map((gap) => ({ name: `${gap.a} – ${gap.b}`, still: !(moves(gap.a) || moves(gap.b)),
    ...Object.fromEntries(["thickness", "pressure_min", "pressure_max", "force", "contact_force"].map((name) => [name, get(gap, name)])) }));
  card.append(element("h3", {}, "Gaps at this time"));
  const body = element("div", { class: "scroll" });
  card.append(body);
  return (at) => {
    let row = 0;
    while (row + 1 < time.length && time[row + 1] <= at * (1 + 1e-12)) ++row;
    const present = gaps.filter((gap) => Number.isFinite(gap.thickness[row]))
      .sort((a, b) => a.still - b.still || a.thickness[row] - b.thickness[row]);
    if (!present.length) {
      body.replaceChildren(element("p", { class: "note" }, "No gap thinner than the film threshold, and no contact."));
      return;
    }
    const cells = (gap) => [["thickness", `${short(gap.thickness[row])} (${short(gap.thickness[row] / run.domain.spacing)} cells)`],
      ["film pressure", `${short(gap.pressure_min[row])} … ${short(gap.pressure_max[row])}`], ["film force", short(gap.force[row])],
      ...(gap.contact_force[row] ? [["contact force", short(gap.contact_force[row])]] : [])];
    const most = 4;
    const name = (gap) => element("div", { style: "font-weight:600;font-size:14px;margin-top:6px" }, gap.name);
    body.replaceChildren(...present.slice(0, most).flatMap((gap) => [name(gap), table(cells(gap))]),
      ...(present.length > most ? [element("p", { class: "note" }, `and ${present.length - most} more`)] : []));
  };
}
