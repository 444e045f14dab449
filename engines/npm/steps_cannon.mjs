// SPDX-License-Identifier: Apache-2.0
// cannon-es, in double precision.
import { Body, Box, ContactMaterial, Material, Plane, Sphere, Vec3, World } from "cannon-es";

export const hello = {
  cannot: ["particles", "stick", "penalty"],
  thresholds: ["a contact is a spring of 1e7 N/m that relaxes over 3 steps", "no continuous detection"],
};

export function start({ gravity, timestep, restitution, bodies, walls }) {
  const world = new World({ gravity: new Vec3(...gravity), allowSleep: false });
  const material = new Material();
  world.addContactMaterial(new ContactMaterial(material, material, { friction: 0, restitution }));
  const index = new Map();
  const add = (body) => {
    index.set(body, index.size);
    world.addBody(body);
    return body;
  };
  const still = { material, linearDamping: 0, angularDamping: 0, fixedRotation: true };
  const made = bodies.map((body) => add(new Body({
    ...still, mass: body.fixed ? 0 : body.mass, position: new Vec3(...body.position),
    velocity: new Vec3(...body.velocity),
    shape: body.shape === "sphere" ? new Sphere(body.radius) : new Box(new Vec3(...body.half_extents)),
  })));
  for (const { normal, offset } of walls) {
    const position = new Vec3(...normal.map((x) => -offset * x));
    const wall = new Body({ ...still, mass: 0, shape: new Plane(), position });
    wall.quaternion.setFromVectors(new Vec3(0, 0, 1), new Vec3(...normal));
    add(wall);
  }
  return {
    step(met) {
      world.step(timestep);
      for (const { multiplier, bi, bj } of world.contacts) if (multiplier > 0) met(index.get(bi), index.get(bj));
    },
    body(i) {
      const { x, y, z } = made[i].position, v = made[i].velocity;
      return [x, y, z, v.x, v.y, v.z];
    },
  };
}
