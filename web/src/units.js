// Dimensions of quantities in the scene's own units. In 2D masses, forces and energies are per unit depth.

/** { force, torque, pressure, energy } ...: what stands on an axis. */
export function units(dimension) {
  const flat = dimension === 2, depth = flat ? " / length" : "";
  return { time: "time", length: "length", velocity: "length / time", angle: "rad", rate: "rad / time", force: `force${depth}`,
    torque: `force × length${depth}`, pressure: "force / length²", energy: `energy${depth}`, divergence: "1 / time", seconds: "seconds",
    count: "number" };
}
