// SPDX-License-Identifier: Apache-2.0
// cannon-es: boxes of the broad phase, balls and boxes of the narrow phase, one contact of two balls.
import { AABB, Body, Box, ContactMaterial, Material, Sphere, Vec3, World } from "cannon-es";
import { box, hit, upright } from "./held.mjs";

const vector = (v) => new Vec3(...v);
const list = ({ x, y, z }) => [x, y, z];
const aabb = ({ min, max }) => new AABB({ lowerBound: vector(min), upperBound: vector(max) });
const ball = ({ center, radius }) => ({ shape: new Sphere(radius), center });
const solid = (held) => held && { shape: new Box(vector(held.half)), center: held.center };
const body = ({ shape, center }, mass, velocity) =>
  new Body({ mass, shape, position: vector(center), velocity, linearDamping: 0, angularDamping: 0, material });
const material = new Material();

function contacts(a, b) {
  if (!a || !b) return undefined;
  const world = new World(), result = [];
  world.narrowphase.getContacts([body(a, 1)], [body(b, 1)], world, result, [], [], []);
  return result.length > 0;
}

/** One step of 1/60 without gravity. Balls that only touch are no contact to it: these overlap a little. Documented:
 * a contact is a spring of contactEquationStiffness, 1e7 if it is not set, that relaxes over
 * contactEquationRelaxation steps, 3 if it is not set. */
function bounced(masses, velocities, normal, e) {
  const held = hit(velocities, normal);
  if (!held) return undefined;
  const world = new World({ gravity: new Vec3(0, 0, 0), allowSleep: false });
  world.addContactMaterial(new ContactMaterial(material, material, { friction: 0, restitution: e }));
  const shape = new Sphere(held.distance / 2);
  const a = body({ shape, center: [0, 0, 0] }, masses[0], vector(velocities[0]));
  const b = body({ shape, center: held.between.map((c) => c * (1 - 2 ** -20)) }, masses[1], vector(velocities[1]));
  world.addBody(a);
  world.addBody(b);
  world.step(1 / 60);
  return { velocities: [list(a.velocity), list(b.velocity)] };
}

/** Nothing is documented of touching. */
export default () => ({
  boundary: "unspecified",
  sphere_sphere: ({ a, b }) => (a.center.length === 3 ? contacts(ball(a), ball(b)) : undefined),
  aabb_aabb: ({ a, b }) => (a.min.length === 3 ? aabb(a).overlaps(aabb(b)) : undefined),
  sphere_aabb: ({ sphere, aabb: solid_box }) =>
    sphere.center.length === 3 ? contacts(ball(sphere), solid(box(solid_box))) : undefined,
  obb_obb: ({ a, b }) => contacts(solid(upright(a)), solid(upright(b))),
  elastic_collision: ({ masses, velocities, normal }) => bounced(masses, velocities, normal, 1),
  restitution_collision: ({ masses, velocities, normal, e }) => bounced(masses, velocities, normal, e),
});
