// SPDX-License-Identifier: Apache-2.0
// Rapier in WebAssembly, in single precision: shapes, rays, casts, and one contact of two balls.
import * as rapier from "@dimforge/rapier3d-compat";
import { across_axis, box, difference, hit, middle_and_half, upright } from "./held.mjs";

const f = Math.fround, one = { x: 0, y: 0, z: 0, w: 1 };
const vector = ([x, y, z]) => ({ x, y, z });
const list = ({ x, y, z }) => [x, y, z];
const cuboid = (held) => held && { shape: new rapier.Cuboid(...held.half), at: vector(held.center) };
const ball = ({ center, radius }) => ({ shape: new rapier.Ball(radius), at: vector(center) });
const solid = (aabb) => (aabb.min.length === 3 ? cuboid(box(aabb, f)) : undefined);
const meet = (a, b) => a && b && a.shape.intersectsShape(a.at, one, b.shape, b.at, one);
const nowhere = { x: 0, y: 0, z: 0 };
const turned = (obb) => cuboid(upright(obb));
const triangle = (corners) => ({ shape: new rapier.Triangle(...corners.map(vector)), at: nowhere });
/** The hull of the vertices, which it makes itself. */
const hull = ({ vertices }) => ({ shape: new rapier.ConvexPolyhedron(new Float32Array(vertices.flat())), at: nowhere });
const rounded = ({ vertices }, radius) =>
  ({ shape: new rapier.RoundConvexPolyhedron(new Float32Array(vertices.flat()), null, radius), at: nowhere });
const surface = ({ vertices, faces }) =>
  ({ shape: new rapier.TriMesh(new Float32Array(vertices.flat()), new Uint32Array(faces.flat())), at: nowhere });
/** Its capsules lie along y: others need a rotation, which it cannot hold exactly. */
function capsule({ segment: [a, b], radius }) {
  const along = a[0] === b[0] && a[2] === b[2] && middle_and_half(Math.min(a[1], b[1]), Math.max(a[1], b[1]), f);
  return along ? { shape: new rapier.Capsule(along[1], radius), at: vector([a[0], along[0], a[2]]) } : undefined;
}
/** The half-space behind the plane has the origin of its place on its boundary. */
function behind(plane) {
  const unit = across_axis(plane, f);
  const at = unit?.normal.map((c) => -c * unit.offset);
  return unit && { shape: new rapier.HalfSpace(vector(unit.normal)), at: vector(at) };
}
/** A ray, or with the end 1 a segment, and a solid: t is in units of the direction, 0 where it starts inside. */
function passage(origin, direction, end, solid) {
  if (!solid || !direction) return undefined;
  const t = solid.shape.castRay(new rapier.Ray(vector(origin), vector(direction)), solid.at, one, end, true);
  return t >= 0 ? { relation: "hit", first: t } : { relation: "none" };
}
const farthest = 3.4028234663852886e38;  // the greatest float
const of_ray = ({ origin, direction }, solid) => passage(origin, direction, farthest, solid);
const of_segment = ([a, b], solid) => passage(a, difference(b, a, f), 1, solid);
const spatial = ({ center }) => center.length === 3;

/** a moves and b rests, for one step; documented: null, or the time of impact. */
function first_contact(a, velocity, b) {
  if (!a || !b || !velocity) return undefined;
  const found = a.shape.castShape(a.at, one, vector(velocity), b.shape, b.at, one, nowhere, 0, 1, true);
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
    aabb_obb: ({ aabb, obb }) => meet(solid(aabb), turned(obb)),
    sphere_obb: ({ sphere, obb }) => meet(ball(sphere), turned(obb)),
    sphere_triangle: ({ sphere, triangle: t }) => meet(ball(sphere), triangle(t)),
    sphere_capsule: ({ sphere, capsule: c }) => meet(ball(sphere), capsule(c)),
    sphere_convex: ({ sphere, mesh }) => meet(ball(sphere), hull(mesh)),
    capsule_capsule: ({ a, b }) => meet(capsule(a), capsule(b)),
    capsule_plane: ({ capsule: c, plane }) => meet(capsule(c), behind(plane)),
    capsule_triangle: ({ capsule: c, triangle: t }) => meet(capsule(c), triangle(t)),
    capsule_aabb: ({ capsule: c, aabb }) => meet(capsule(c), solid(aabb)),
    capsule_obb: ({ capsule: c, obb }) => meet(capsule(c), turned(obb)),
    capsule_convex: ({ capsule: c, mesh }) => {
      const held = capsule(c);
      return held && meet(held, hull(mesh));
    },
    // `contactShape` gives depth and direction, but no features, which an answer with them needs.
    penetration: ({ a, b, radius_a, radius_b }) => meet(rounded(a, radius_a), rounded(b, radius_b)),
    obb_plane: ({ obb, plane }) => meet(turned(obb), behind(plane)),
    triangle_obb: ({ triangle: t, obb }) => meet(triangle(t), turned(obb)),
    ray_triangle: ({ ray, triangle: t }) => of_ray(ray, triangle(t)).relation === "hit",
    ray_obb: ({ ray, obb }) => of_ray(ray, turned(obb)),
    segment_obb: ({ segment, obb }) => of_segment(segment, turned(obb)),
    ray_capsule: ({ ray, capsule: c }) => of_ray(ray, capsule(c)),
    segment_capsule: ({ segment, capsule: c }) => of_segment(segment, capsule(c)),
    ray_mesh: ({ ray, mesh }) => (mesh.faces.length > 0 ? of_ray(ray, surface(mesh)).relation === "hit" : false),
    closest_point_on_obb: ({ point, obb }) => {
      const held = turned(obb);
      return held && { point: list(held.shape.projectPoint(held.at, one, vector(point), true).point) };
    },
    swept_sphere_aabb: ({ sphere, velocity, aabb }) => first_contact(ball(sphere), velocity, solid(aabb)),
    swept_sphere_triangle: ({ sphere, velocity, triangle: t }) => first_contact(ball(sphere), velocity, triangle(t)),
    swept_sphere_mesh: ({ sphere, velocity, mesh }) =>
      mesh.faces.length > 0 ? first_contact(ball(sphere), velocity, surface(mesh)) : undefined,
    swept_capsule_capsule: ({ a, b, velocity }) => first_contact(capsule(a), velocity, capsule(b)),
    swept_obb_obb: ({ a, b, velocity }) => first_contact(turned(a), velocity, turned(b)),
    elastic_collision: ({ masses, velocities, normal }) => bounced(masses, velocities, normal, 1),
    restitution_collision: ({ masses, velocities, normal, e }) => bounced(masses, velocities, normal, e),
  };
};
