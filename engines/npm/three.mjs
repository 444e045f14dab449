// SPDX-License-Identifier: Apache-2.0
// three.js: boxes, balls, oriented boxes and hulls of its math and its addons.
import { Box2, Box3, Line3, Matrix3, Ray, Sphere, Triangle, Vector2, Vector3 } from "three";
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
