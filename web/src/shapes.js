// Shapes of bodies in 2D: round ones as curves, and distances to outlines.

// Middle and direction of the points of an outline that is its own mirror image.
function middleOf(points) {
  const n = points.length / 2;
  let x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  for (let i = 0; i < n; ++i) { x += points[2 * i] / n; y += points[2 * i + 1] / n; }
  for (let i = 0; i < n; ++i) {
    const [a, b] = [points[2 * i] - x, points[2 * i + 1] - y];
    xx += a * a;
    xy += a * b;
    yy += b * b;
  }
  return { x, y, angle: 0.5 * Math.atan2(2 * xy, xx - yy) };
}

/** A disk or capsule as a curve: { path(path) } adds it where the body's points lie; null for other shapes. Not for containers, whose points have a
 * rim besides. */
export function roundOf(body, points) {
  if (!body || body.inside_out || !points.length || !["ball", "capsule"].includes(body.shape)) return null;
  const { x, y, angle } = middleOf(points), half = 0.5 * (body.length ?? 0), [ex, ey] = [half * Math.cos(angle), half * Math.sin(angle)];
  return { path: (path) => {
    path.arc(x + ex, y + ey, body.radius, angle - 0.5 * Math.PI, angle + 0.5 * Math.PI);
    path.arc(x - ex, y - ey, body.radius, angle + 0.5 * Math.PI, angle + 1.5 * Math.PI);
    path.closePath();
    return path;
  } };
}

/** Distances from outlines, { points, chains } a body, and names of gaps. */
export function outlinesOf(run, outlines) {
  const boxes = outlines.map(({ points }) => {
    const xs = points.filter((_, i) => i % 2 === 0), ys = points.filter((_, i) => i % 2 === 1);
    return { x: 0.5 * (Math.min(...xs) + Math.max(...xs)), y: 0.5 * (Math.min(...ys) + Math.max(...ys)),
      reach: 0.5 * Math.hypot(Math.max(...xs) - Math.min(...xs), Math.max(...ys) - Math.min(...ys)) };
  });
  const placed = (placements, b) => placements.subarray(12 * b, 12 * b + 12);
  function distance(b, placements, x, y) {
    const p = placed(placements, b), { points, chains } = outlines[b];
    const at = (i) => [p[0] * points[2 * i] + p[1] * points[2 * i + 1] + p[9], p[3] * points[2 * i] + p[4] * points[2 * i + 1] + p[10]];
    let least = Infinity;
    for (const loop of chains)
      for (let k = 1; k < loop.length; ++k) {
        const [ax, ay] = at(loop[k - 1]), [bx, by] = at(loop[k]), [ex, ey] = [bx - ax, by - ay];
        const s = Math.max(0, Math.min(1, ((x - ax) * ex + (y - ay) * ey) / (ex * ex + ey * ey || 1)));
        least = Math.min(least, Math.hypot(x - ax - s * ex, y - ay - s * ey));
      }
    return least;
  }
  /** The two nearest of bodies and walls at a node of the films: "upper – lower". */
  function gap({ film, placements }, node) {
    const x = film.points[2 * node], y = film.points[2 * node + 1], { origin, size } = run.domain, found = [];
    run.bodies.forEach((body, b) => {
      const p = placed(placements, b), box = boxes[b];
      const away = Math.hypot(x - p[0] * box.x - p[1] * box.y - p[9], y - p[3] * box.x - p[4] * box.y - p[10]) - box.reach;
      if (away < 2 * film.thickness[node] + run.domain.spacing) found.push([distance(b, placements, x, y), body.name]);
    });
    ["x", "y"].forEach((axis, i) => [["low", origin[i]], ["high", origin[i] + size[i]]].forEach(([end, wall]) =>
      found.push([Math.abs((i ? y : x) - wall), `wall:${axis}_${end}`])));
    return found.sort((a, b) => a[0] - b[0]).slice(0, 2).map(([, name]) => name).join(" – ");
  }
  return { distance, gap };
}
