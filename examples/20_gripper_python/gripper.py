#!/usr/bin/env python3
"""Two fingers close on a ball under water and lift it: what a controller in Python does between the steps of a simulation.

    python3 gripper.py [--cells 128] [--pictures FOLDER]

Prints when the grip closes and how the lift ends.
"""
import argparse
from pathlib import Path

import numpy as np

import gapflow
from gapflow import Ball, Box, Contact, Domain, Fluid, Scene, Sides, Simulation, Time

radius, width, height = 0.4, 0.2, 0.8  # of the ball; of a finger
floor_gap = 0.004
grip, lift = 2.0, 0.6                  # force of each finger; how far up
lift_start, lift_time = 2.3, 2.5
fastest, slowest, approach_rate = 0.4, 0.02, 2.0  # approach: speed = rate * gap, within limits


def scene(cells: int) -> Scene:
    fingers = [Box(name=name, size=[width, height], position=[2.0 + side * 0.9, 0.6], density=3.0, free=["x", "y"])
               for name, side in (("left", -1), ("right", 1))]
    ball = Ball(name="ball", radius=radius, position=[2.0, radius + floor_gap], density=2.0)
    return Scene(title="a gripper under water", gravity=[0.0, -1.0],
                 domain=Domain(size=[4.0, 3.0], cells=[cells, cells * 3 // 4], sides=Sides(y_high="open")),
                 fluid=Fluid(density=1.0), contact=Contact(friction=0.6, thickness=0.002), bodies=[*fingers, ball],
                 time=Time(end=5.5, max_step=0.02))


class Gripper:
    """Each finger: along x first a speed that falls with the gap, then, once both touch, a force; along y it follows a height."""

    def __init__(self, sim: Simulation) -> None:
        self.ball, self.start = sim.bodies["ball"], 0.6
        self.fingers = [(sim.bodies["left"], 1.0), (sim.bodies["right"], -1.0)]  # with the direction that closes
        self.closed_at: float | None = None

    def gap(self, finger: gapflow.BodyState) -> float:
        return abs(finger.centre[0] - self.ball.centre[0]) - width / 2 - radius

    def height(self, time: float) -> float:
        s = np.clip((time - lift_start) / lift_time, 0, 1)
        return self.start + lift * s * s * (3 - 2 * s)

    def __call__(self, sim: Simulation) -> None:
        touching = {name for row in sim.gaps if row["contact_force"] > 0 for name in (row["body_a"], row["body_b"])}
        if self.closed_at is None and {"left", "right", "ball"} <= touching:
            self.closed_at = sim.time
        for finger, inwards in self.fingers:
            if self.closed_at is None:
                wanted = inwards * np.clip(approach_rate * self.gap(finger), slowest, fastest)
                across = 20 * finger.mass * (wanted - finger.velocity[0])
            else:
                across = inwards * grip
            weight = finger.mass - finger.volume  # in water, gravity 1
            load = 0.5 * (self.ball.mass - self.ball.volume) if sim.time > lift_start else 0.0
            up = weight + load + finger.mass * (200 * (self.height(sim.time) - finger.centre[1]) - 30 * finger.velocity[1])
            finger.set_force([across, up])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--cells", type=int, default=128, help="along x")
    parser.add_argument("--pictures", type=Path, help="folder for motion.png and fields.png")
    arguments = parser.parse_args()

    sim = Simulation(scene(arguments.cells))
    gripper = Gripper(sim)
    rows, moments = [], {0.6: None, 1.2: None, 3.2: None, 4.8: None}

    def record(sim: Simulation, report: gapflow.StepReport) -> None:
        on_ball = [row for row in sim.gaps if "ball" in (row["body_a"], row["body_b"])]
        by = {(set(row[["body_a", "body_b"]].tolist()) - {"ball"}).pop(): row for row in on_ball}
        rows.append([sim.time, gripper.gap(gripper.fingers[0][0]), gripper.gap(gripper.fingers[1][0]),
                     by["left"]["force"] if "left" in by else 0.0, by["left"]["contact_force"] if "left" in by else 0.0,
                     gripper.ball.centre[1], sim.bodies["left"].centre[1], gripper.ball.centre[0], report.dt])
        for note in report.notes:
            print(f"t = {sim.time:.3f}: {note}")

    if arguments.pictures:
        import matplotlib
        matplotlib.use("Agg")
        import matplotlib.pyplot as plt
        from gapflow import plot
        figure, places = plt.subplots(2, 2, figsize=(11, 8), constrained_layout=True)
        for moment, axes in zip(moments, places.flat):
            sim.run(until=moment, control=gripper, callback=record)
            plot.state(sim, "speed", axes=axes)
        arguments.pictures.mkdir(parents=True, exist_ok=True)
        figure.savefig(arguments.pictures / "fields.png", dpi=80)
    sim.run(control=gripper, callback=record)

    time, left, right, film, contact, ball, finger, x, dt = np.array(rows).T
    print(f"{sim.steps} steps; grip closed at t = {gripper.closed_at}; smallest gap {left.min():.4f}")
    print(f"ball: height {ball[-1]:.4f} (rest {ball[0]:.4f}), finger rose {finger[-1] - finger[0]:.4f}, x {x[-1]:.4f}, "
          f"contact force {contact[-1]:.4f}")
    if arguments.pictures:
        figure, (top, middle, bottom) = plt.subplots(3, 1, figsize=(8, 8), sharex=True, constrained_layout=True)
        top.semilogy(time, left, label="left"), top.semilogy(time, right, "--", label="right")
        top.set_ylabel("gap to the ball"), top.legend()
        middle.plot(time, film, label="film, on the left finger"), middle.plot(time, contact, label="contact")
        middle.set_ylabel("force"), middle.set_ylim(-2 * grip, 2 * grip), middle.legend()
        bottom.plot(time, ball - ball[0], label="ball"), bottom.plot(time, finger - finger[0], "--", label="finger")
        bottom.plot(time, [gripper.height(t) - gripper.start for t in time], ":", label="wanted")
        bottom.set_ylabel("rise"), bottom.set_xlabel("time"), bottom.legend()
        figure.savefig(arguments.pictures / "motion.png", dpi=80)


if __name__ == "__main__":
    main()
