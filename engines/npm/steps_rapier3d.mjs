// SPDX-License-Identifier: Apache-2.0
// Rapier in WebAssembly, in single precision.
import * as rapier from "@dimforge/rapier3d-compat";

export const hello = {
  number: "binary32",
  cannot: ["particles", "stick", "penalty"],
  thresholds: [
    "contacts from 0.002 m away (normalizedPredictionDistance)",
    "0.001 m of depth are left (normalizedAllowedLinearError)",
  ],
};

const vector = ([x, y, z]) => ({ x, y, z });

export async function start({ gravity, timestep, restitution, option, bodies, walls }) {
  await rapier.init();
  const world = new rapier.World(vector(gravity));
  world.timestep = timestep;
  const index = new Map(), colliders = [];
  const add = (shape, kind) => {
    const body = world.createRigidBody(kind);
    const collider = world.createCollider(shape.setFriction(0).setRestitution(restitution), body);
    index.set(collider.handle, colliders.length);
    colliders.push(collider);
    return body;
  };
  const made = bodies.map((body) => {
    const shape = body.shape === "sphere" ? rapier.ColliderDesc.ball(body.radius) :
      rapier.ColliderDesc.cuboid(...body.half_extents);
    const kind = body.fixed ? rapier.RigidBodyDesc.fixed() : rapier.RigidBodyDesc.dynamic().setCanSleep(false)
      .setLinvel(...body.velocity).lockRotations().setCcdEnabled(option === 2);
    return add(shape.setMass(body.mass), kind.setTranslation(...body.position));
  });
  for (const { normal, offset } of walls) {
    const shape = new rapier.ColliderDesc(new rapier.HalfSpace(vector(normal)));
    add(shape, rapier.RigidBodyDesc.fixed().setTranslation(...normal.map((x) => -offset * x)));
  }
  return {
    step(met) {
      world.step();
      for (const one of colliders.slice(0, bodies.length)) {
        world.contactPairsWith(one, (other) => world.contactPair(one, other, (manifold) => {
          for (let k = 0; k < manifold.numContacts(); ++k)
            if (manifold.contactImpulse(k) > 0) met(index.get(one.handle), index.get(other.handle));
        }));
      }
    },
    body(i) {
      const p = made[i].translation(), v = made[i].linvel();
      return [p.x, p.y, p.z, v.x, v.y, v.z];
    },
  };
}
