// Dimensions of quantities in the scene's own units. In 2D masses, forces and energies are per unit depth.

/** { force, torque, pressure, energy } ...: what stands on an axis. */
export function units(dimension) {
  const flat = dimension === 2, depth = flat ? " / length" : "";
  return { time: "time", length: "length", velocity: "length / time", angle: "rad", rate: "rad / time", force: `force${depth}`,
    torque: `force × length${depth}`, pressure: "force / length²", energy: `energy${depth}`, divergence: "1 / time", seconds: "seconds",
    count: "number", flux: flat ? "length² / time" : "length³ / time" };
}

/** The unit of a column of bodies.csv, gaps.csv or fluxes.csv, "ball.fy"; "" where it has none that is known. */
export function unitOf(quantity, dimension) {
  const unit = units(dimension), column = quantity.slice(quantity.lastIndexOf(".") + 1);
  const kinds = [[/^([xyz]|thickness|length)$/, unit.length], [/^(v[xyz]|opening_rate)$/, unit.velocity], [/^f[xyz]$|force$/, unit.force],
    [/^(torque|t[xyz])$/, unit.torque], [/^(omega|w[xyz])$/, unit.rate], [/^angle$/, unit.angle], [/^pressure/, unit.pressure],
    [/^(flux|inflow|outflow|film|bodies)$/, unit.flux]];
  return kinds.find(([pattern]) => pattern.test(column))?.[1] ?? "";
}
