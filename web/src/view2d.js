// The run in 2D: field, bodies, films along the gaps, arrows of the velocity, coordinates at the edges. Wheel zooms, drag moves, double click
// shows all.
import { chains, css, element, short } from "./data.js";
import { checkbox, colours, drawScales, segments, tip } from "./controls.js";
import { outlinesOf, roundOf } from "./shapes.js";
import { units } from "./units.js";

const filmWidth = 5; // pixels at least: a gap of a hundredth of a cell must be seen

const margin = { left: 52, bottom: 40, top: 8, right: 12 };

/**
 * `host`: { place, choices, scales, shared }: elements for the picture, for its choices and for the colour scales, and what several views share:
 * the first one makes it and has the choices. Returns { show(frame), redraw(), canvas, scales(), gapNames(film) }.
 */
export function view2d(run, host) {
  const { place } = host;
  const canvas = element("canvas", { role: "img", "aria-label": "Field, bodies and films at the chosen time" });
  place.append(canvas);
  const say = tip(place);
  const context = canvas.getContext("2d");
  const { size } = run.domain;
  let origin = run.domain.origin; // goes with a grid that follows a body, and what is seen with it
  const first = !host.shared.maps;
  if (first) {
    const fields = ["pressure", "speed"].filter((name) => run.frames.some((f) => f.planes.some((p) => (name === "speed" ? p.u : p[name]))));
    Object.assign(host.shared, { maps: { pressure: colours(run, "pressure"), speed: colours(run, "speed"), film: colours(run, "film") }, fields,
      state: { field: fields[0] ?? null, arrows: fields.includes("speed"), smooth: true }, view: { scale: 1, x: 0, y: 0 }, draws: [] });
  }
  const { maps, fields, state, view, draws } = host.shared; // view: pixels a length; world point at the top left corner of the area
  const changed = () => { for (const each of draws) each(); };
  const films = run.frames.some((f) => f.film.thickness[2] > 0);
  let frame = null;
  const outlines = run.bodies.map((body) => ({ points: run.numbers(body.points), chains: chains(body.outlines, run.numbers) }));
  const paths = outlines.map(({ points, chains: loops }, b) => {
    const path = new Path2D(), round = roundOf(run.scene.body[b], points);
    if (round) return round.path(path);
    for (const loop of loops) {
      loop.forEach((node, i) => path[i ? "lineTo" : "moveTo"](points[2 * node], points[2 * node + 1]));
      path.closePath();
    }
    return path;
  });
  const image = document.createElement("canvas");
  let painted = "";

  const scales = () => [...(state.field ? [[`${state.field} (${units(2)[state.field === "speed" ? "velocity" : "pressure"]})`, maps[state.field]]] : []),
    ...(films ? [[`film pressure (${units(2).pressure})`, maps.film]] : [])];
  if (first) {
    const redrawScales = () => drawScales(host.scales, scales(), changed), { choices } = host;
    if (fields.length > 1) choices.append(segments(fields.map((f) => [f, f[0].toUpperCase() + f.slice(1)]), state.field, (field) => {
      state.field = field;
      redrawScales();
      changed();
    }));
    if (fields.includes("speed")) choices.append(checkbox("Velocity arrows", state.arrows, (on) => { state.arrows = on; changed(); }));
    if (fields.length) choices.append(checkbox("Smooth", state.smooth, (on) => { state.smooth = on; changed(); }));
    const reset = element("button", { type: "button", title: "Double click in the picture does the same" }, "Show all");
    const toGap = element("button", { type: "button", title: "Look at the thinnest place of the gaps" }, "Zoom to gap");
    reset.onclick = () => { fit(); changed(); };
    toGap.onclick = () => { zoomToGap(); changed(); };
    choices.append(reset, ...(films ? [toGap] : []));
    redrawScales();
  }

  // The domain fills the width, or the height that the window leaves.
  let width = 0, height = 0, area = { width: 0, height: 0 };
  function resize() {
    const ratio = size[1] / size[0];
    width = place.clientWidth;
    area = { width: width - margin.left - margin.right };
    height = Math.round(Math.min(area.width * ratio + margin.top + margin.bottom, Math.max(320, window.innerHeight - 360), 760));
    area.height = height - margin.top - margin.bottom;
    canvas.style.height = `${height}px`;
    const dots = window.devicePixelRatio || 1;
    canvas.width = Math.round(width * dots);
    canvas.height = Math.round(height * dots);
    fit();
  }
  function fit() {
    view.scale = whole();
    view.x = origin[0] - 0.5 * (area.width / view.scale - size[0]);
    view.y = origin[1] + size[1] + 0.5 * (area.height / view.scale - size[1]);
  }
  const whole = () => Math.min(area.width / size[0], area.height / size[1]);
  const toPixel = (x, y) => [margin.left + (x - view.x) * view.scale, margin.top + (view.y - y) * view.scale];
  const toWorld = (a, b) => [view.x + (a - margin.left) / view.scale, view.y - (b - margin.top) / view.scale];

  function zoomToGap() {
    const { film } = frame;
    if (!film.thickness.length) return;
    const all = Array.from(film.thickness.keys()), atMoving = all.filter(nextToMoving);
    const thinnest = (atMoving.length ? atMoving : all).reduce((best, i) => (film.thickness[i] < film.thickness[best] ? i : best));
    view.scale = whole() * 4;
    const x = film.points[2 * thinnest], y = film.points[2 * thinnest + 1];
    view.x = x - 0.5 * area.width / view.scale;
    view.y = y + 0.5 * area.height / view.scale;
  }

  const near = outlinesOf(run, outlines);
  // Whether a film node lies on a body that moves: gaps between fixed ones are of less interest.
  function nextToMoving(node) {
    const { film, placements } = frame, reach = 0.75 * film.thickness[node] + 0.02 * run.domain.spacing;
    return run.bodies.some((body, b) => body.motion !== "fixed" &&
      near.distance(b, placements, film.points[2 * node], film.points[2 * node + 1]) < reach);
  }

  function paintField(plane) {
    const key = `${frame.number} ${state.field} ${maps[state.field].version}`;
    if (key === painted) return;
    painted = key;
    const [nx, ny] = plane.cells, map = maps[state.field], values = plane[state.field];
    image.width = nx;
    image.height = ny;
    const brush = image.getContext("2d"), pixels = brush.createImageData(nx, ny);
    for (let j = 0; j < ny; ++j)
      for (let i = 0; i < nx; ++i) {
        const value = values[i + nx * j], to = 4 * (i + nx * (ny - 1 - j));
        if (Number.isNaN(value)) continue;
        const from = map.index(value);
        pixels.data[to] = map.table[from];
        pixels.data[to + 1] = map.table[from + 1];
        pixels.data[to + 2] = map.table[from + 2];
        pixels.data[to + 3] = 255;
      }
    brush.putImageData(pixels, 0, 0);
  }

  function draw() {
    if (!frame || width === 0) return;
    const dots = canvas.width / width;
    context.setTransform(dots, 0, 0, dots, 0, 0);
    context.clearRect(0, 0, width, height);
    const [x0, y0] = toPixel(origin[0], origin[1] + size[1]);
    context.save();
    context.beginPath();
    context.rect(x0, y0, size[0] * view.scale, size[1] * view.scale);
    context.clip();
    context.beginPath();
    context.rect(margin.left, margin.top, area.width, area.height);
    context.clip();
    const plane = frame.planes[0], values = plane?.[state.field];
    context.fillStyle = values ? css("--solid") : css("--hover");
    context.fillRect(0, 0, width, height);
    if (values) {
      paintField(plane);
      context.imageSmoothingEnabled = state.smooth;
      context.imageSmoothingQuality = "high";
      const [a, b] = toPixel(plane.low[0], plane.low[1] + plane.cells[1] * plane.spacing);
      context.drawImage(image, a, b, plane.cells[0] * plane.spacing * view.scale, plane.cells[1] * plane.spacing * view.scale);
      if (state.arrows) drawArrows(plane);
    }
    drawBodies();
    drawFilms();
    context.restore();
    context.save();
    context.beginPath();
    context.rect(margin.left, margin.top, area.width, area.height);
    context.clip();
    context.strokeStyle = css("--edge");
    context.lineWidth = 1;
    context.strokeRect(x0 + 0.5, y0 + 0.5, size[0] * view.scale - 1, size[1] * view.scale - 1);
    context.restore();
    drawCoordinates();
  }

  // Ticks at round numbers left of and below what is seen of the domain.
  function drawCoordinates() {
    context.fillStyle = context.strokeStyle = css("--soft");
    context.font = "12px system-ui, sans-serif";
    context.lineWidth = 1;
    const seen = (axis) => {
      const [low, high] = axis === 0 ? [view.x, view.x + area.width / view.scale] : [view.y - area.height / view.scale, view.y];
      return [Math.max(low, origin[axis]), Math.min(high, origin[axis] + size[axis])];
    };
    const left = Math.max(margin.left, toPixel(origin[0], 0)[0]), bottom = Math.min(height - margin.bottom, toPixel(0, origin[1])[1]);
    for (const axis of [0, 1]) {
      const [low, high] = seen(axis);
      if (!(high > low)) continue;
      const rough = (axis === 0 ? 80 : 48) / view.scale, power = 10 ** Math.floor(Math.log10(rough));
      const step = [1, 2, 5, 10].find((m) => m * power >= rough) * power, digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
      for (let n = Math.ceil(low / step - 1e-9); n * step <= high + 1e-9 * step; ++n) {
        const text = Math.abs(n * step) >= 1e5 ? short(n * step) : (n * step).toFixed(Math.min(digits, 12)).replace("-", "−");
        context.beginPath();
        if (axis === 0) {
          const [x] = toPixel(n * step, 0);
          context.moveTo(x, bottom);
          context.lineTo(x, bottom + 4);
          context.textAlign = "center";
          context.fillText(text, x, bottom + 16);
        } else {
          const [, y] = toPixel(0, n * step);
          context.moveTo(left - 4, y);
          context.lineTo(left, y);
          context.textAlign = "right";
          context.fillText(text, left - 7, y + 4);
        }
        context.stroke();
      }
    }
    context.textAlign = "center";
    const [xs, ys] = [seen(0), seen(1)].map((ends) => 0.5 * (ends[0] + ends[1]));
    context.fillText("x (length)", toPixel(xs, 0)[0], bottom + 33);
    context.save();
    context.translate(left - 42, toPixel(0, ys)[1]);
    context.rotate(-0.5 * Math.PI);
    context.fillText("y (length)", 0, 4);
    context.restore();
  }

  function drawBodies() {
    context.lineWidth = 1.2;
    paths.forEach((path, b) => {
      const [r00, r01, , r10, r11, , , , , sx, sy] = frame.placements.subarray(12 * b, 12 * b + 12);
      const s = view.scale;
      const matrix = new DOMMatrix([s * r00, -s * r10, s * r01, -s * r11, margin.left + s * (sx - view.x), margin.top + s * (view.y - sy)]);
      const placed = new Path2D();
      placed.addPath(path, matrix);
      context.fillStyle = css("--solid");
      context.strokeStyle = css("--edge");
      context.fill(placed, "evenodd");
      context.stroke(placed);
    });
  }

  function drawFilms() {
    const { film } = frame;
    for (const edge of [true, false])
      for (const chain of film.chains)
        for (let i = 0; i + 1 < chain.length; ++i) {
          const [a, b] = [chain[i], chain[i + 1]];
          const h = Math.max(filmWidth, 0.5 * (film.thickness[a] + film.thickness[b]) * view.scale);
          context.lineWidth = edge ? h + 2.5 : h;
          context.strokeStyle = edge ? css("--edge") : maps.film.css(0.5 * (film.pressure[a] + film.pressure[b]));
          // A little longer than the element: no seams between neighbours.
          const [p, q] = toPixel(film.points[2 * a], film.points[2 * a + 1]), [r, s] = toPixel(film.points[2 * b], film.points[2 * b + 1]);
          const length = Math.hypot(r - p, s - q) || 1, more = edge ? 1.25 : 0.5, [ex, ey] = [(more * (r - p)) / length, (more * (s - q)) / length];
          context.beginPath();
          context.moveTo(p - ex, q - ey);
          context.lineTo(r + ex, s + ey);
          context.stroke();
        }
  }

  function cellAt(plane, x, y) {
    const i = Math.floor((x - plane.low[0]) / plane.spacing), j = Math.floor((y - plane.low[1]) / plane.spacing);
    return i >= 0 && j >= 0 && i < plane.cells[0] && j < plane.cells[1] ? i + plane.cells[0] * j : -1;
  }

  function drawArrows(plane) {
    if (!plane.u) return;
    const apart = 26, longest = 24;
    context.strokeStyle = context.fillStyle = state.field === "speed" ? "rgb(255 255 255 / .8)" : "rgb(20 28 40 / .62)";
    context.lineWidth = 1.1;
    context.beginPath();
    // Fixed in the domain, so that arrows do not swim when the view moves.
    const step = apart / view.scale;
    for (let y = Math.floor((view.y - area.height / view.scale) / step) * step; y < view.y; y += step)
      for (let x = Math.floor(view.x / step) * step; x < view.x + area.width / view.scale; x += step) {
        const c = cellAt(plane, x, y);
        if (c < 0 || !plane.fluid[c]) continue;
        const size = Math.min(longest, (longest * plane.speed[c]) / maps.speed.high);
        if (!(size > 2)) continue;
        const [a, b] = toPixel(x, y), ex = plane.u[c] / plane.speed[c], ey = -plane.v[c] / plane.speed[c];
        const [ta, tb] = [a + 0.5 * size * ex, b + 0.5 * size * ey], head = Math.min(5, 0.4 * size);
        context.moveTo(a - 0.5 * size * ex, b - 0.5 * size * ey);
        context.lineTo(ta, tb);
        context.moveTo(ta - head * (ex - 0.5 * ey), tb - head * (ey + 0.5 * ex));
        context.lineTo(ta, tb);
        context.lineTo(ta - head * (ex + 0.5 * ey), tb - head * (ey - 0.5 * ex));
      }
    context.stroke();
  }

  // ---- pointer

  function describe(a, b) {
    const [x, y] = toWorld(a, b), { film, planes } = frame;
    const lines = [`x ${short(x)}   y ${short(y)}`];
    let nearest = -1, distance = 10; // pixels
    for (let i = 0; i < film.thickness.length; ++i) {
      const [p, q] = toPixel(film.points[2 * i], film.points[2 * i + 1]), d = Math.hypot(p - a, q - b);
      if (d < distance) { distance = d; nearest = i; }
    }
    const body = run.bodies.find((_, i) => inside(i, x, y));
    if (nearest >= 0) lines.push(near.gap(frame, nearest), `film pressure ${short(film.pressure[nearest])}`, `thickness ${short(film.thickness[nearest])}`);
    else if (body) lines.push(body.name);
    else if (planes[0]) {
      const c = cellAt(planes[0], x, y);
      if (c < 0) return null;
      for (const name of fields) if (planes[0][name] && !Number.isNaN(planes[0][name][c])) lines.push(`${name} ${short(planes[0][name][c])}`);
    }
    return lines.join("\n");
  }
  function inside(b, x, y) {
    const [r00, r01, , r10, r11, , , , , sx, sy] = frame.placements.subarray(12 * b, 12 * b + 12);
    const [dx, dy] = [x - sx, y - sy];
    context.setTransform(1, 0, 0, 1, 0, 0);
    return context.isPointInPath(paths[b], r00 * dx + r10 * dy, r01 * dx + r11 * dy, "evenodd");
  }
  let held = null;
  canvas.addEventListener("pointerdown", (event) => {
    held = [event.offsetX, event.offsetY];
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointerup", () => (held = null));
  canvas.addEventListener("pointermove", (event) => {
    if (held) {
      view.x -= (event.offsetX - held[0]) / view.scale;
      view.y += (event.offsetY - held[1]) / view.scale;
      held = [event.offsetX, event.offsetY];
      changed();
    }
    say(frame ? describe(event.offsetX, event.offsetY) : null, event.offsetX, event.offsetY);
  });
  canvas.addEventListener("pointerleave", () => say(null));
  canvas.addEventListener("dblclick", () => { fit(); changed(); });
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    const [x, y] = toWorld(event.offsetX, event.offsetY), most = whole();
    view.scale = Math.max(0.5 * most, Math.min(1e5 * most, view.scale * Math.exp(-0.0015 * event.deltaY)));
    view.x = x - (event.offsetX - margin.left) / view.scale;
    view.y = y + (event.offsetY - margin.top) / view.scale;
    changed();
  }, { passive: false });

  new ResizeObserver(() => {
    if (place.clientWidth === width) return;
    resize();
    draw();
  }).observe(place);
  resize();
  draws.push(draw);
  function show(next) {
    frame = next;
    const low = run.domain.origin.map((x, axis) => x + (next.shift?.[axis] ?? 0));
    if (first) {
      view.x += low[0] - origin[0];
      view.y += low[1] - origin[1];
    }
    origin = low;
    draw();
  }
  return { show, redraw: draw, canvas, scales,
    gapNames: (film) => film.chains.map((chain) => near.gap(frame, chain[Math.floor(0.5 * (chain.length - 1))])),
    remove: () => draws.splice(draws.indexOf(draw), 1) };
}
