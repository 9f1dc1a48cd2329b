// What the page carries: JSON, and one compressed stream of numbers (report_page.cpp tells its layout).

const kinds = { f32: Float32Array, f64: Float64Array, i32: Int32Array, u8: Uint8Array };

/** The page's JSON, with numbers(reference, base) to look arrays up; of several runs, `runs` have it too. */
export async function load() {
  const run = JSON.parse(document.getElementById("gapflow-data").textContent);
  const text = atob(document.getElementById("gapflow-numbers").textContent);
  const packed = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) packed[i] = text.charCodeAt(i);
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  const bytes = await new Response(stream).arrayBuffer();
  run.numbers = ([type, offset, count, low, high], base = 0) =>
    type === "q16" ? field(new Uint8Array(bytes, base + offset, 2 * count), count, low, high)
      : new kinds[type](bytes, base + offset, count);
  for (const each of run.runs ?? []) Object.assign(each, { numbers: run.numbers, colours: run.colours });
  return run;
}

// 16-bit codes, as differences, high bytes first; 0 is no value.
function field(bytes, count, low, high) {
  const values = new Float32Array(count);
  const unit = (high - low) / 65534;
  let code = 0;
  for (let i = 0; i < count; ++i) {
    code = (code + (bytes[i] << 8) + bytes[count + i]) & 65535;
    values[i] = code === 0 ? NaN : low + (code - 1) * unit;
  }
  return values;
}

/** Frames with their arrays decoded, a few kept. */
export function frameReader(run, keep = 6) {
  const cache = new Map();
  return (index) => {
    if (cache.has(index)) return cache.get(index);
    const { base, ...stored } = run.frames[index];
    const get = (reference) => run.numbers(reference, base);
    const planes = stored.planes.map((plane) => {
      const decoded = { ...plane, fluid: get(plane.fluid) };
      for (const name of ["pressure", "speed", "u", "v"]) if (plane[name]) decoded[name] = get(plane[name]);
      if (decoded.u) decoded.speed = decoded.u.map((u, i) => Math.hypot(u, decoded.v[i]));
      return decoded;
    });
    const film = { points: get(stored.film.points), thickness: get(stored.film.thickness), pressure: get(stored.film.pressure) };
    if (stored.film.elements) film.elements = get(stored.film.elements);
    if (stored.film.chains) film.chains = chains(stored.film.chains, get);
    const frame = { ...stored, planes, film, placements: get(stored.placements) };
    if (stored.volume) {
      frame.volume = { ...stored.volume };
      for (const name of ["pressure", "speed"]) if (stored.volume[name]) frame.volume[name] = get(stored.volume[name]);
    }
    cache.set(index, frame);
    if (cache.size > keep) cache.delete(cache.keys().next().value);
    return frame;
  };
}

/** Lists of node numbers, a chain each. */
export function chains(reference, get) {
  const nodes = get(reference.nodes), ends = get(reference.ends);
  return Array.from(ends, (end, i) => nodes.subarray(i > 0 ? ends[i - 1] : 0, end));
}

/** A number for readers: four digits. */
export function short(value) {
  if (value === null || value === undefined || Number.isNaN(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size < 1e-3 || size >= 1e5) {
    const [digits, power] = value.toExponential(3).split("e");
    return `${Number(digits)}e${Number(power)}`.replace("-", "−").replace("e-", "e−");
  }
  return String(Number(value.toPrecision(4))).replace("-", "−");
}

export function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes))
    if (key in made && typeof value !== "string") made[key] = value;
    else made.setAttribute(key, value);
  made.append(...children);
  return made;
}

export const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
