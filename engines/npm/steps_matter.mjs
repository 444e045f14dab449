// SPDX-License-Identifier: Apache-2.0
// matter-js, in the plane. Its unit of length is a pixel, its velocities are pixels in 1/60 s.
import matter from "matter-js";

const { Bodies, Body, Composite, Engine } = matter;
const pixels = 128, rate = 60;  // in a metre; in a second
const thick = 64 * pixels;      // of a wall

export const hello = {
  cannot: ["particles", "stick", "penalty", "space"],
  thresholds: [
    `no bounce below ${2 * rate / pixels} m/s at 60 steps a second (restingThresh, 2 pixels a step)`,
    "a circle is a polygon of at most 26 sides", "no continuous detection",
  ],
};

export function start({ gravity, timestep, restitution, bodies, walls }) {
  const engine = Engine.create({ enableSleeping: false });
  engine.gravity = { x: gravity[0] * pixels / 1e6, y: gravity[1] * pixels / 1e6, scale: 1 };
  const usual = { restitution, friction: 0, frictionStatic: 0, frictionAir: 0, inertia: Infinity, slop: 0 };
  const index = new Map();
  const made = bodies.map((body, i) => {
    const [x, y] = body.position.map((c) => c * pixels), options = { ...usual, isStatic: body.fixed };
    const one = body.shape === "sphere" ? Bodies.circle(x, y, body.radius * pixels, options) :
      Bodies.rectangle(x, y, 2 * body.half_extents[0] * pixels, 2 * body.half_extents[1] * pixels, options);
    if (!body.fixed) {
      Body.setMass(one, body.mass);
      Body.setInertia(one, Infinity);
      Body.setVelocity(one, { x: body.velocity[0] * pixels / rate, y: body.velocity[1] * pixels / rate });
    }
    index.set(one.id, i);
    Composite.add(engine.world, one);
    return one;
  });
  walls.forEach(({ normal: [x, y, z], offset }, i) => {
    if (z !== 0) return;
    const middle = -offset * pixels - thick / 2;
    const options = { ...usual, isStatic: true, angle: Math.atan2(y, x) };
    const one = Bodies.rectangle(middle * x, middle * y, thick, 2000 * pixels, options);
    index.set(one.id, bodies.length + i);
    Composite.add(engine.world, one);
  });
  return {
    step(met) {
      Engine.update(engine, 1000 * timestep);
      // It does not say which of its pairs that overlap got an impulse.
      for (const { isActive, bodyA, bodyB } of engine.pairs.list)
        if (isActive) met(index.get(bodyA.id), index.get(bodyB.id));
    },
    body(i) {
      const { x, y } = made[i].position, v = Body.getVelocity(made[i]);
      return [x / pixels, y / pixels, 0, v.x * rate / pixels, v.y * rate / pixels, 0];
    },
  };
}
