// The run in 3D: body surfaces, films coloured by their pressure, a slice of the field that moves. Drag turns, wheel zooms, right drag moves.
import {
  AmbientLight, BufferAttribute, BufferGeometry, CanvasTexture, DataTexture, DirectionalLight, DoubleSide, EdgesGeometry, BoxGeometry,
  GreaterDepth, Group, HemisphereLight, LinearFilter, LineBasicMaterial, LineSegments, Matrix4, Mesh, MeshBasicMaterial, MeshLambertMaterial, NearestFilter,
  PerspectiveCamera, PlaneGeometry, Raycaster, Scene, SphereGeometry, Sprite, SpriteMaterial, SRGBColorSpace, Vector2, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { toCreasedNormals } from "three/examples/jsm/utils/BufferGeometryUtils.js";
import { css, element, short } from "./data.js";
import { checkbox, colours, drawScales, segments, tip } from "./controls.js";
import { units } from "./units.js";

const axisNames = ["x", "y", "z"];

/** As view2d; without gapNames. */
export function view3d(run, host) {
  const { place } = host;
  const renderer = new WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
  const canvas = renderer.domElement;
  canvas.setAttribute("role", "img");
  canvas.setAttribute("aria-label", "Bodies, films and a slice of the field at the chosen time");
  place.append(canvas);
  const say = tip(place);
  const first = !host.shared.maps;
  if (first) {
    const fields = ["pressure", "speed"].filter((name) => run.frames.some((frame) => frame.planes.some((plane) => plane[name])));
    Object.assign(host.shared, { maps: { pressure: colours(run, "pressure"), speed: colours(run, "speed"), film: colours(run, "film") }, fields,
      state: { field: fields[0] ?? null, axis: 1, opacity: 1, at: [null, null, null], through: true }, draws: [], cameras: [] });
  }
  const { maps, fields, state, draws, cameras } = host.shared; // at: where the slices across each axis are at the start; null: where the run's own are
  const changed = () => { for (const each of draws) each(); };
  const films = run.frames.some((frame) => frame.film.thickness[2] > 0);
  let frame = null;
  const shift = new Vector3(); // of a grid that follows a body since the start: box, slices and camera go with it
  const origin = new Vector3(...run.domain.origin), size = new Vector3(...run.domain.size), middle = origin.clone().addScaledVector(size, 0.5);

  // ---- things to see
  const scene = new Scene();
  scene.add(new HemisphereLight(0xffffff, 0x8a93a3, 1.9), new AmbientLight(0xffffff, 0.35));
  const lamp = new DirectionalLight(0xffffff, 1.5);
  scene.add(lamp);
  const frameLines = new LineSegments(new EdgesGeometry(new BoxGeometry(size.x, size.y, size.z)), new LineBasicMaterial());
  frameLines.position.copy(middle);
  const box = new Group();
  box.add(frameLines);
  scene.add(box);
  const labels = axisNames.map((name, axis) => {
    const sprite = new Sprite(new SpriteMaterial({ depthTest: false, transparent: true }));
    const at = origin.clone();
    at.setComponent(axis, at.getComponent(axis) + 0.5 * size.getComponent(axis));
    at[axis === 0 ? "y" : "x"] -= 0.05 * size.length() / 1.7;
    if (axis === 1) at.x = origin.x + size.x + 0.05 * size.length() / 1.7;
    sprite.position.copy(at);
    sprite.scale.set(0.24 * size.length(), 0.06 * size.length(), 1);
    box.add(sprite);
    const text = () => {
      const low = origin.getComponent(axis) + shift.getComponent(axis);
      const ends = [low, low + size.getComponent(axis)].map((v) => short(Number(v.toPrecision(4))));
      return `${name}: ${ends[0]} … ${ends[1]} (length)`;
    };
    return { text, sprite };
  });
  const sphere = new SphereGeometry(1, run.bodies.length > 100 ? 32 : 64, run.bodies.length > 100 ? 16 : 32);
  const bodies = run.bodies.map((body, b) => {
    const of = run.scene.body[b];
    if (of?.shape === "ball" && !of.inside_out && body.points[2] > 0) { // round at any distance
      const points = run.numbers(body.points), middle = [0, 0, 0], n = points.length / 3;
      points.forEach((v, i) => (middle[i % 3] += v / n));
      const mesh = new Mesh(sphere, new MeshLambertMaterial({ color: 0xc4ccd6 }));
      mesh.matrixAutoUpdate = false;
      mesh.name = body.name;
      mesh.userData.own = new Matrix4().makeTranslation(...middle).multiply(new Matrix4().makeScale(of.radius, of.radius, of.radius));
      scene.add(mesh);
      return mesh;
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(run.numbers(body.points).slice(), 3));
    geometry.setIndex(new BufferAttribute(new Uint32Array(run.numbers(body.elements)), 1));
    const clear = body.inside_out ? { transparent: true, opacity: 0.12, depthWrite: false } : {}; // would hide everything
    const mesh = new Mesh(body.elements[2] > 0 ? toCreasedNormals(geometry, 0.6) : geometry,
      new MeshLambertMaterial({ color: 0xc4ccd6, side: DoubleSide, ...clear }));
    mesh.matrixAutoUpdate = false;
    mesh.name = body.name;
    mesh.userData.container = body.inside_out;
    scene.add(mesh);
    return mesh;
  });
  const film = new Mesh(new BufferGeometry(), new MeshBasicMaterial({ vertexColors: true, side: DoubleSide,
    polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -2 }));
  // The same films where something hides them.
  const hidden = new Mesh(film.geometry, new MeshBasicMaterial({ vertexColors: true, side: DoubleSide,
    transparent: true, opacity: 0.45, depthFunc: GreaterDepth, depthWrite: false }));
  hidden.renderOrder = 2;
  scene.add(film, hidden);
  const slice = new Mesh(new PlaneGeometry(1, 1), new MeshBasicMaterial({ side: DoubleSide, transparent: true, alphaTest: 0.5 }));
  scene.add(slice);

  // ---- choices
  const scales = () => [...(state.field ? [[`${state.field} on the slice (${units(3)[state.field === "speed" ? "velocity" : "pressure"]})`, maps[state.field]]] : []),
    ...(films ? [[`film pressure (${units(3).pressure})`, maps.film]] : [])];
  if (first) drawChoices();
  function drawChoices() {
    const { choices } = host, drawAll = () => drawScales(host.scales, scales(), changed);
    if (fields.length > 1) choices.append(segments(fields.map((f) => [f, f[0].toUpperCase() + f.slice(1)]), state.field, (field) => {
      state.field = field;
      drawAll();
      changed();
    }));
    if (fields.length) {
      const place = element("input", { type: "range", min: "0", max: "1000", "aria-label": "Place of the slice" });
      const at = element("output", {}), box = element("label", { class: "slice" }, "at", place, at);
      const opacity = element("input", { type: "range", min: "5", max: "100", value: "100", "aria-label": "Opacity of the slice" });
      const own = () => run.frames[0].planes.find((p) => p.axis === state.axis)?.position ?? middle.getComponent(state.axis);
      const tell = () => {
        box.hidden = state.axis < 0;
        if (state.axis < 0) return;
        const where = state.at[state.axis] ?? own();
        place.value = String(Math.round((1000 * (where - origin.getComponent(state.axis))) / size.getComponent(state.axis)));
        at.textContent = short(Number(where.toPrecision(4)));
      };
      place.oninput = () => {
        state.at[state.axis] = origin.getComponent(state.axis) + (Number(place.value) / 1000) * size.getComponent(state.axis);
        tell();
        changed();
      };
      opacity.oninput = () => { state.opacity = Number(opacity.value) / 100; changed(); };
      choices.append("Slice", segments([...axisNames.map((name, axis) => [axis, name]), [-1, "none"]], state.axis, (axis) => {
        state.axis = axis;
        tell();
        changed();
      }), box, element("label", {}, "opacity", opacity));
      tell();
    }
    if (films) choices.append(checkbox("Films through bodies", state.through, (on) => { state.through = on; changed(); }));
    const reset = element("button", { type: "button" }, "Reset view");
    reset.onclick = () => { state.at = [null, null, null]; lookFromStart(); changed(); };
    choices.append(reset);
    drawAll();
  }

  // ---- camera
  const camera = new PerspectiveCamera(32, 1, 0.01 * size.length(), 20 * size.length());
  camera.up.set(0, 0, 1);
  const controls = new OrbitControls(camera, canvas);
  let follows = false; // another view's camera
  controls.addEventListener("change", () => {
    render();
    if (follows) return;
    for (const other of cameras) if (other !== follow) other(camera.position, controls.target);
  });
  function follow(position, target) {
    follows = true;
    camera.position.copy(position);
    controls.target.copy(target);
    controls.update();
    follows = false;
    render();
  }
  cameras.push(follow);
  function lookFromStart() {
    const direction = new Vector3(0.62, -1.35, 0.62).normalize();
    const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((k) => origin.clone().add(new Vector3(k & 1, (k >> 1) & 1, k >> 2).multiply(size)).add(shift));
    const up = new Vector3(0, 0, 1);
    controls.target.copy(middle).add(shift);
    // The nearest place from which all corners are inside the picture, as much above as below the middle.
    for (let distance = 0.6 * size.length(); distance < 8 * size.length(); distance *= 1.03) {
      camera.position.copy(controls.target).addScaledVector(direction, distance);
      controls.update();
      camera.updateMatrixWorld();
      const seen = corners.map((corner) => corner.clone().project(camera));
      const high = Math.max(...seen.map((p) => p.y)), low = Math.min(...seen.map((p) => p.y));
      if (high - low < 1.9 && Math.max(...seen.map((p) => Math.abs(p.x))) < 0.95 && Math.abs(high + low) < 0.06) break;
      controls.target.addScaledVector(up, 0.25 * (high + low) * distance * Math.tan((0.5 * camera.fov * Math.PI) / 180));
    }
  }
  let width = 0;
  function resize() {
    width = place.clientWidth;
    const height = Math.round(Math.min(0.78 * width, Math.max(340, window.innerHeight - 360), 760));
    renderer.setPixelRatio(Math.min(2, window.devicePixelRatio || 1));
    renderer.setSize(width, height, false);
    canvas.style.height = `${height}px`;
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
  }

  // ---- a frame
  // The run's own slice, or, elsewhere, one of the coarser values of the whole domain.
  function planeNow() {
    const own = frame.planes.find((p) => p.axis === state.axis), set = state.at[state.axis], at = set + shift.getComponent(Math.max(0, state.axis));
    if (set === null || set === undefined || !frame.volume || (own && Math.abs(at - own.position) < 0.5 * run.domain.spacing)) return own;
    const { cells, low, spacing } = frame.volume, axis = state.axis, in_plane = [0, 1, 2].filter((a) => a !== axis);
    const layer = Math.max(0, Math.min(cells[axis] - 1, Math.floor((at - low[axis]) / spacing))), steps = [1, cells[0], cells[0] * cells[1]];
    const [nx, ny] = in_plane.map((a) => cells[a]);
    const cut = (values) => values && Float32Array.from({ length: nx * ny }, (_, c) =>
      values[layer * steps[axis] + (c % nx) * steps[in_plane[0]] + Math.floor(c / nx) * steps[in_plane[1]]]);
    const plane = { axis, position: at, in_plane, cells: [nx, ny], low: in_plane.map((a) => low[a]), spacing,
      pressure: cut(frame.volume.pressure), speed: cut(frame.volume.speed) };
    plane.fluid = (plane.pressure ?? plane.speed).map((v) => (Number.isNaN(v) ? 0 : 1));
    return plane;
  }
  function placeSlice() {
    const plane = state.axis < 0 ? undefined : planeNow(), values = plane?.[state.field];
    slice.visible = Boolean(values);
    if (!values) return;
    const [nx, ny] = plane.cells, map = maps[state.field], pixels = new Uint8Array(4 * nx * ny);
    for (let c = 0; c < nx * ny; ++c) {
      if (Number.isNaN(values[c])) { // clear, and light where the neighbours' colours run out
        pixels.set([225, 228, 232, 0], 4 * c);
        continue;
      }
      const from = map.index(values[c]);
      pixels.set([map.table[from], map.table[from + 1], map.table[from + 2], 255], 4 * c);
    }
    slice.material.map?.dispose();
    const texture = new DataTexture(pixels, nx, ny);
    texture.colorSpace = SRGBColorSpace;
    texture.magFilter = LinearFilter;
    texture.minFilter = NearestFilter;
    texture.needsUpdate = true;
    slice.material.map = texture;
    slice.material.opacity = state.opacity;
    slice.material.alphaTest = 0.5 * state.opacity;
    slice.material.depthWrite = state.opacity > 0.95;
    slice.material.needsUpdate = true;
    const ex = new Vector3(), ey = new Vector3(), at = new Vector3();
    ex.setComponent(plane.in_plane[0], nx * plane.spacing);
    ey.setComponent(plane.in_plane[1], ny * plane.spacing);
    at.setComponent(plane.axis, plane.position);
    plane.in_plane.forEach((axis, i) => at.setComponent(axis, plane.low[i] + 0.5 * plane.cells[i] * plane.spacing));
    slice.matrixAutoUpdate = false;
    slice.matrix.makeBasis(ex, ey, ex.clone().cross(ey).normalize()).setPosition(at);
    slice.matrixWorldNeedsUpdate = true;
    slice.userData.plane = plane;
  }
  function placeFilm() {
    const { points, pressure, elements } = frame.film;
    const geometry = new BufferGeometry(), shades = new Uint8Array(3 * pressure.length);
    pressure.forEach((p, i) => { const from = maps.film.index(p); shades.set(maps.film.table.subarray(from, from + 3), 3 * i); });
    geometry.setAttribute("position", new BufferAttribute(points.slice(), 3));
    // Vertex colours are linear in three: the table is sRGB.
    const linear = Float32Array.from(shades, (c) => (c <= 10 ? c / 255 / 12.92 : ((c / 255 + 0.055) / 1.055) ** 2.4));
    geometry.setAttribute("color", new BufferAttribute(linear, 3));
    geometry.setIndex(new BufferAttribute(new Uint32Array(elements), 1));
    film.geometry.dispose();
    film.geometry = geometry;
    hidden.geometry = geometry;
    film.visible = elements.length > 0;
    hidden.visible = film.visible && state.through;
  }
  function update() {
    if (!frame) return;
    placeSlice();
    placeFilm();
    bodies.forEach((mesh, b) => {
      const p = frame.placements.subarray(12 * b, 12 * b + 12);
      mesh.matrix.set(p[0], p[1], p[2], p[9], p[3], p[4], p[5], p[10], p[6], p[7], p[8], p[11], 0, 0, 0, 1);
      if (mesh.userData.own) mesh.matrix.multiply(mesh.userData.own);
      mesh.matrixWorldNeedsUpdate = true;
    });
    render();
  }
  function paintLabels() {
    frameLines.material.color.set(css("--soft"));
    for (const { text, sprite } of labels) {
      const board = document.createElement("canvas");
      board.width = 512;
      board.height = 128;
      const brush = board.getContext("2d");
      brush.font = "600 40px system-ui, sans-serif";
      brush.textAlign = "center";
      brush.textBaseline = "middle";
      brush.fillStyle = css("--soft");
      brush.fillText(text(), 256, 64);
      sprite.material.map?.dispose();
      sprite.material.map = new CanvasTexture(board);
      sprite.material.map.colorSpace = SRGBColorSpace;
      sprite.material.needsUpdate = true;
    }
  }
  function render() {
    lamp.position.copy(camera.position).add(new Vector3(0, 0, 0.6 * size.length()));
    renderer.setClearColor(css("--card"), 1);
    renderer.render(scene, camera);
  }

  // ---- values under the pointer
  const ray = new Raycaster();
  canvas.addEventListener("pointermove", (event) => {
    if (!frame || event.buttons) return say(null);
    const x = (event.offsetX / canvas.clientWidth) * 2 - 1, y = 1 - (event.offsetY / canvas.clientHeight) * 2;
    ray.setFromCamera(new Vector2(x, y), camera);
    const hits = ray.intersectObjects([film, slice, ...bodies].filter((mesh) => mesh.visible && mesh.geometry.attributes.position?.count > 0), false);
    if (state.through) hits.sort((a, b) => (b.object === film) - (a.object === film)); // as it is seen
    const text = hits.map(describe).find((found) => found !== null) ?? null;
    say(text, event.offsetX, event.offsetY);
  });
  canvas.addEventListener("pointerleave", () => say(null));
  function describe(hit) {
    const where = `x ${short(hit.point.x)}   y ${short(hit.point.y)}   z ${short(hit.point.z)}`;
    if (hit.object === film) {
      const { pressure, thickness } = frame.film, node = hit.face.a;
      return `${where}\nfilm pressure ${short(pressure[node])}\nthickness ${short(thickness[node])}`;
    }
    if (hit.object === slice) {
      const { plane } = slice.userData;
      const [i, j] = plane.in_plane.map((axis, k) => Math.floor((hit.point.getComponent(axis) - plane.low[k]) / plane.spacing));
      const c = Math.min(i, plane.cells[0] - 1) + plane.cells[0] * Math.min(j, plane.cells[1] - 1);
      if (!plane.fluid[c]) return null;
      return [where, ...fields.filter((f) => !Number.isNaN(plane[f]?.[c])).map((f) => `${f} ${short(plane[f][c])}`)].join("\n");
    }
    return hit.object.userData.container ? null : `${where}\n${hit.object.name}`;
  }

  new ResizeObserver(() => {
    if (place.clientWidth === width) return;
    resize();
    render();
  }).observe(place);
  resize();
  paintLabels();
  lookFromStart();
  draws.push(update);
  function show(next) {
    frame = next;
    const way = new Vector3(...(next.shift ?? [0, 0, 0])).sub(shift);
    if (way.lengthSq() > 0) {
      shift.add(way);
      box.position.copy(shift);
      follow(camera.position.clone().add(way), controls.target.clone().add(way));
      paintLabels();
    }
    update();
  }
  return { show, redraw: () => { paintLabels(); render(); }, canvas, scales,
    remove: () => {
      draws.splice(draws.indexOf(update), 1);
      cameras.splice(cameras.indexOf(follow), 1);
      renderer.dispose();
      renderer.forceContextLoss();
    } };
}
