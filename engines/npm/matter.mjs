// SPDX-License-Identifier: Apache-2.0
// matter-js: bounds, hulls, and one contact of two squares.
import matter from "matter-js";
import { hit } from "./held.mjs";

const { Bodies, Body, Bounds, Composite, Engine, Vertices } = matter;
const bounds = ({ min, max }) => ({ min: { x: min[0], y: min[1] }, max: { x: max[0], y: max[1] } });

/** Two squares side by side that do not turn, one step of 1000 / 60, its unit of time for velocities. Along an axis
 * only, and not faster than half their size a step: it is documented to have no continuous collision detection. */
function bounced(masses, velocities, normal, e) {
  const across = normal.findIndex((c) => c !== 0), size = 64;
  const planar = [...velocities, normal].every((v) => v[2] === 0) && normal.filter((c) => c !== 0).length === 1;
  const along = planar && velocities.every((v) => v.every((c, k) => k === across || c === 0));
  const held = along ? hit(velocities, normal) : undefined;
  if (!held || held.approach > size / 2) return undefined;
  const engine = Engine.create({ gravity: { x: 0, y: 0 } });
  const way = held.between.map((c) => Math.sign(c) * size);
  const options = { restitution: e, friction: 0, frictionStatic: 0, frictionAir: 0, inertia: Infinity };
  const pair = masses.map((mass, k) => {
    const square = Bodies.rectangle(k * way[0], k * way[1], size, size, options);
    Body.setMass(square, mass);
    Body.setVelocity(square, { x: velocities[k][0], y: velocities[k][1] });
    return square;
  });
  Composite.add(engine.world, pair);
  Engine.update(engine, 1000 / 60);
  return { velocities: pair.map((square) => [Body.getVelocity(square).x, Body.getVelocity(square).y, 0]) };
}

/** Nothing is documented of touching. The hull is given back as points of the list. */
export default () => ({
  boundary: "unspecified",
  aabb_aabb: ({ a, b }) => (a.min.length === 2 ? Bounds.overlaps(bounds(a), bounds(b)) : undefined),
  convex_hull_2d: ({ points }) => {
    const hull = Vertices.hull(points.map(([x, y], place) => ({ x, y, place }))).map(({ place }) => place);
    return hull.length > 2 ? { dimension: 2, polygon: hull } : undefined;
  },
  elastic_collision: ({ masses, velocities, normal }) => bounced(masses, velocities, normal, 1),
  restitution_collision: ({ masses, velocities, normal, e }) => bounced(masses, velocities, normal, e),
});
