// SPDX-License-Identifier: Apache-2.0
// three.js: boxes, balls, oriented boxes, capsules and hulls of its math and its addons, and rays to meshes.
import { Box2, Box3, BufferAttribute, BufferGeometry, DoubleSide, Line3, Matrix3, Mesh, MeshBasicMaterial, Ray,
  Raycaster, Sphere, Triangle, Vector2, Vector3 } from "three";
import { Capsule } from "three/addons/math/Capsule.js";
import { ConvexHull } from "three/addons/math/ConvexHull.js";
import { OBB } from "three/addons/math/OBB.js";
import { rank } from "./exact.mjs";
import { upright } from "./held.mjs";

const vector = (p) => (p.length === 2 ? new Vector2(...p) : new Vector3(...p));
const box = ({ min, max }) => new (min.length === 2 ? Box2 : Box3)(vector(min), vector(max));
const ball = ({ center, radius }) => new Sphere(vector(center), radius);
const spatial = ({ center }) => center.length === 3;
const turned = (obb) => {
  const held = upright(obb);
  return held && new OBB(vector(held.center), vector(held.half), new Matrix3());
};

/** Its rays have a direction of length 1, by its documentation: others are not asked. */
const ray = ({ origin, direction }) =>
  origin.length === 3 && Math.hypot(...direction) === 1 && direction.filter((x) => x !== 0).length === 1
    ? new Ray(vector(origin), vector(direction))
    : undefined;
const hit = (found) => (found === null ? { relation: "none" } : { relation: "hit" });
const nearest = (p, found) => {
  const square = found.distanceToSquared(p);
  return { point: found.toArray(), squared_distance: square, distance: Math.sqrt(square) };
};

/** Positions as doubles, which a geometry takes as well. */
const mesh = ({ vertices, faces }) => {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float64Array(vertices.flat()), 3));
  geometry.setIndex(faces.flat());
  return new Mesh(geometry, new MeshBasicMaterial({ side: DoubleSide }));
};

/** Nothing is documented of touching. ConvexHull gives faces: of flat input it is not asked. Sphere.setFromPoints is
 * around the center of the box. */
export default () => ({
  boundary: "unspecified",
  sphere_sphere: ({ a, b }) => (spatial(a) ? ball(a).intersectsSphere(ball(b)) : undefined),
  aabb_aabb: ({ a, b }) => box(a).intersectsBox(box(b)),
  sphere_aabb: ({ sphere, aabb }) => (spatial(sphere) ? box(aabb).intersectsSphere(ball(sphere)) : undefined),
  aabb_of_points: ({ points }) => {
    const found = new (points[0].length === 2 ? Box2 : Box3)().setFromPoints(points.map(vector));
    return { aabb: { min: found.min.toArray(), max: found.max.toArray() } };
  },
  closest_point_on_aabb: ({ point, aabb }) => ({
    point: box(aabb).clampPoint(vector(point), vector(point)).toArray(),
  }),
  bounding_sphere: ({ points, method }) => {
    if (method !== "box") return undefined;
    const { center, radius } = new Sphere().setFromPoints(points.map(vector));
    return { sphere: { center: center.toArray(), radius } };
  },
  obb_obb: ({ a, b }) => {
    const first = turned(a), second = turned(b);
    return first && second && first.intersectsOBB(second);
  },
  aabb_obb: ({ aabb, obb }) => turned(obb)?.intersectsBox3(box(aabb)),
  sphere_obb: ({ sphere, obb }) => turned(obb)?.intersectsSphere(ball(sphere)),
  closest_point_on_obb: ({ point, obb }) => {
    const p = vector(point), found = turned(obb)?.clampPoint(p, new Vector3());
    return found && nearest(p, found);
  },
  capsule_aabb: ({ capsule: { segment: [a, b], radius }, aabb }) =>
    new Capsule(vector(a), vector(b), radius).intersectsBox(box(aabb)),
  ray_obb: ({ ray: cast, obb }) => {
    const from = ray(cast), held = from && turned(obb);
    return held && hit(held.intersectRay(from, new Vector3()));
  },
  ray_mesh: ({ ray: cast, mesh: faces }) => {
    const from = ray(cast);
    return from && new Raycaster(from.origin, from.direction).intersectObject(mesh(faces)).length > 0;
  },
  ray_triangle: ({ ray: cast, triangle: [a, b, c] }) => {
    const from = ray(cast);
    if (!from) return undefined;
    const found = from.intersectTriangle(vector(a), vector(b), vector(c), false, new Vector3());
    return found === null ? { relation: "none" } : { relation: "point", point: found.toArray() };
  },
  ray_aabb: ({ ray: cast, aabb }) => {
    const from = ray(cast);
    return from && hit(from.intersectBox(box(aabb), new Vector3()));
  },
  ray_sphere: ({ ray: cast, sphere }) => {
    const from = ray(cast);
    return from && hit(from.intersectSphere(ball(sphere), new Vector3()));
  },
  closest_point_on_segment: ({ point, segment: [a, b] }) => {
    if (point.length !== 3) return undefined;
    const p = vector(point);
    return nearest(p, new Line3(vector(a), vector(b)).closestPointToPoint(p, true, new Vector3()));
  },
  closest_point_on_triangle: ({ point, triangle: [a, b, c] }) => {
    const p = vector(point);
    return nearest(p, new Triangle(vector(a), vector(b), vector(c)).closestPointToPoint(p, new Vector3()));
  },
  convex_hull: ({ points }) => {
    if (rank(points) < 3) return undefined;
    const list = points.map(vector), places = new Map(list.map((p, i) => [p, i]));
    const { faces } = new ConvexHull().setFromPoints(list);
    const corner = (face, k) => places.get(face.getEdge(k).head().point);
    return { dimension: 3, faces: faces.map((face) => [0, 1, 2].map((k) => corner(face, k))) };
  },
});
