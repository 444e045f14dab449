// SPDX-License-Identifier: Apache-2.0
// planck, Box2D in JavaScript with double precision: circles, boxes of the broad phase, one contact of two circles.
import { AABB, Circle, CollideCircles, Manifold, Settings, Transform, Vec2, World } from "planck";
import { hit } from "./held.mjs";

const vector = ([x, y]) => new Vec2(x, y);
const aabb = ({ min, max }) => new AABB(vector(min), vector(max));
const at = (center) => new Transform(vector(center), 0);
const step = 1 / 1024;

/** Documented: below velocityThreshold, 1 if it is not set, there is no restitution (set to 0 here); a body moves
 * maxTranslation a step at most. */
function bounced(masses, velocities, normal, e) {
  const all_planar = [...velocities, normal].every((v) => v[2] === 0);
  const slow = velocities.every((v) => Math.hypot(...v) * step <= Settings.maxTranslation);
  const held = all_planar && slow ? hit(velocities, normal) : undefined;
  if (!held) return undefined;
  Settings.velocityThreshold = 0;
  const world = new World({ gravity: new Vec2(0, 0), allowSleep: false, continuousPhysics: false });
  const radius = held.distance / 2;
  const body = (mass, center, velocity) => {
    const made = world.createBody({ type: "dynamic", position: vector(center), linearVelocity: vector(velocity) });
    made.createFixture(new Circle(radius), { density: 1, friction: 0, restitution: e });
    made.setMassData({ mass, center: new Vec2(0, 0), I: (mass * radius * radius) / 2 });
    return made;
  };
  const a = body(masses[0], [0, 0], velocities[0]), b = body(masses[1], held.between, velocities[1]);
  world.step(step);
  return { velocities: [a, b].map((made) => [made.getLinearVelocity().x, made.getLinearVelocity().y, 0]) };
}

/** Nothing is documented of touching. */
export default () => ({
  boundary: "unspecified",
  sphere_sphere: ({ a, b }) => {
    if (a.center.length === 3) return undefined;
    const manifold = new Manifold();
    CollideCircles(manifold, new Circle(a.radius), at(a.center), new Circle(b.radius), at(b.center));
    return manifold.pointCount > 0;
  },
  aabb_aabb: ({ a, b }) => (a.min.length === 3 ? undefined : AABB.testOverlap(aabb(a), aabb(b))),
  elastic_collision: ({ masses, velocities, normal }) => bounced(masses, velocities, normal, 1),
  restitution_collision: ({ masses, velocities, normal, e }) => bounced(masses, velocities, normal, e),
});
