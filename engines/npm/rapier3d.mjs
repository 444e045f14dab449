// SPDX-License-Identifier: Apache-2.0
// Rapier in WebAssembly, in single precision: shapes, casts, and one contact of two balls.
import * as rapier from "@dimforge/rapier3d-compat";
import { box, difference, hit, upright } from "./held.mjs";

const f = Math.fround, one = { x: 0, y: 0, z: 0, w: 1 };
const vector = ([x, y, z]) => ({ x, y, z });
const list = ({ x, y, z }) => [x, y, z];
const cuboid = (held) => held && { shape: new rapier.Cuboid(...held.half), at: vector(held.center) };
const ball = ({ center, radius }) => ({ shape: new rapier.Ball(radius), at: vector(center) });
const solid = (aabb) => (aabb.min.length === 3 ? cuboid(box(aabb, f)) : undefined);
const meet = (a, b) => a && b && a.shape.intersectsShape(a.at, one, b.shape, b.at, one);
const spatial = ({ center }) => center.length === 3;

/** a moves and b rests, for one step; documented: null, or the time of impact. */
function first_contact(a, velocity, b) {
  if (!a || !b || !velocity) return undefined;
  const still = { x: 0, y: 0, z: 0 };
  const found = a.shape.castShape(a.at, one, vector(velocity), b.shape, b.at, one, still, 0, 1, true);
  return found ? { relation: "hit", t: found.time_of_impact } : { relation: "never" };
}

function body(world, mass, center, velocity, radius, restitution) {
  const kind = rapier.RigidBodyDesc.dynamic().setTranslation(...center).setLinvel(...velocity).setCanSleep(false);
  const made = world.createRigidBody(kind);
  const shape = rapier.ColliderDesc.ball(radius).setMass(mass).setFriction(0).setRestitution(restitution);
  world.createCollider(shape.setRestitutionCombineRule(rapier.CoefficientCombineRule.Min), made);
  return made;
}

/** Two balls that touch, one step of 1/1024 without gravity. */
function bounced(masses, velocities, normal, e) {
  const held = hit(velocities, normal, f);
  if (!held) return undefined;
  const world = new rapier.World({ x: 0, y: 0, z: 0 });
  world.timestep = 1 / 1024;
  const a = body(world, masses[0], [0, 0, 0], velocities[0], held.distance / 2, e);
  const b = body(world, masses[1], held.between, velocities[1], held.distance / 2, e);
  world.step();
  const after = [list(a.linvel()), list(b.linvel())];
  world.free();
  return { velocities: after };
}

/** Nothing is documented of touching. */
export default async () => {
  await rapier.init();
  return {
    boundary: "unspecified",
    number: "binary32",
    sphere_sphere: ({ a, b }) => (spatial(a) ? meet(ball(a), ball(b)) : undefined),
    aabb_aabb: ({ a, b }) => meet(solid(a), solid(b)),
    sphere_aabb: ({ sphere, aabb }) => (spatial(sphere) ? meet(ball(sphere), solid(aabb)) : undefined),
    obb_obb: ({ a, b }) => meet(cuboid(upright(a)), cuboid(upright(b))),
    swept_sphere_sphere: ({ a, b, velocity_a, velocity_b }) =>
      first_contact(ball(a), difference(velocity_a, velocity_b, f), ball(b)),
    swept_aabb_aabb: ({ a, b, velocity }) => first_contact(solid(a), velocity, solid(b)),
    elastic_collision: ({ masses, velocities, normal }) => bounced(masses, velocities, normal, 1),
    restitution_collision: ({ masses, velocities, normal, e }) => bounced(masses, velocities, normal, e),
  };
};
