// SPDX-License-Identifier: Apache-2.0
// Audits packages from npm: node engine.mjs NAME, a name of `packages` below.
import { createRequire } from "node:module";
import { createInterface } from "node:readline";
import { of_the_same_area, simple } from "./exact.mjs";

console.log = console.error;  // what a package prints is no answer
const require = createRequire(import.meta.url);
const name = process.argv[2];

/** Where a number's sign lies, for packages that answer with a signed area. */
const side = (left) => ({ side: left > 0 ? "left" : left < 0 ? "right" : "on" });

const geojson = (...rings) => ({ type: "Polygon", coordinates: rings.map((ring) => [...ring, ring[0]]) });
const region = ({ outer, holes }) => geojson(outer, ...holes);

/** A package with a file of its own. */
const from = (file) => async () => (await import(file)).default();

/** What each has: its operations, which answer undefined where the documentation excludes the input; `boundary`, if it
 * is not closed; `number`, if it is not binary64. */
const packages = {
  "robust-segment-intersect": () => {
    const intersect = require("robust-segment-intersect");
    return { segment_segment: ({ a, b }) => intersect(a[0], a[1], b[0], b[1]) };
  },
  // Negative for a positively oriented (counter-clockwise) triple.
  "robust-orientation": () => {
    const orient = require("robust-orientation");
    return { orientation: ({ p0, p1, p }) => side(-orient[3](p0, p1, p)) };
  },
  // Positive for counter-clockwise where y points down, so negative where it points up.
  "robust-predicates": () => {
    const { orient2d } = require("robust-predicates");
    return { orientation: ({ p0, p1, p }) => side(-orient2d(...p0, ...p1, ...p)) };
  },
  // Documented: true or false, by a ray, not numerically robust. Nothing is said of points on an edge.
  "point-in-polygon": () => {
    const inside = require("point-in-polygon");
    return { boundary: "unspecified", point_in_polygon: ({ polygon, point }) => inside(point, polygon) };
  },
  // Documented for simple polygons: -1 inside, 0 on the boundary, 1 outside.
  "robust-point-in-polygon": () => {
    const locate = require("robust-point-in-polygon");
    const words = ["inside", "boundary", "outside"];
    const answer = (ring, point) => ({ location: words[locate(ring, point) + 1] });
    return { point_in_polygon: ({ polygon, point }) => (simple(polygon) ? answer(polygon, point) : undefined) };
  },
  // The last position of a GeoJSON ring is its first.
  "@turf/boolean-point-in-polygon": () => {
    const { booleanPointInPolygon } = require("@turf/boolean-point-in-polygon");
    const within = (point, solid, ignoreBoundary) => booleanPointInPolygon(point, solid, { ignoreBoundary });
    const locate = (point, solid) => ({
      location: within(point, solid, true) ? "inside" : within(point, solid, false) ? "boundary" : "outside",
    });
    return {
      point_in_polygon: ({ polygon, point }) => locate(point, geojson(polygon)),
      point_in_region: ({ region: solid, point }) => locate(point, region(solid)),
    };
  },
  "@turf/boolean-touches": () => {
    const { booleanDisjoint } = require("@turf/boolean-disjoint");
    const { booleanTouches } = require("@turf/boolean-touches");
    const contact = (a, b) => (booleanDisjoint(a, b) ? "disjoint" : booleanTouches(a, b) ? "touching" : "overlapping");
    return {
      polygon_polygon: ({ a, b }) => ({ contact: contact(geojson(a), geojson(b)) }),
      region_region: ({ a, b }) => ({ contact: contact(region(a), region(b)) }),
    };
  },
  // A flat list of corners, counter-clockwise where y points up. Documented as not conforming: a vertex may lie inside
  // an edge of a triangle, so an answer of fewer triangles that has the polygon's area is not judged.
  earcut: async () => {
    const { default: earcut } = await import("earcut");
    const threes = (list) => Array.from({ length: list.length / 3 }, (_, i) => list.slice(3 * i, 3 * i + 3));
    return {
      triangulate_polygon: ({ polygon }) => {
        const triangles = threes(earcut(polygon.flat()));
        const conforming = triangles.length === polygon.length - 2 || !of_the_same_area(polygon, triangles);
        return conforming ? { triangles } : undefined;
      },
    };
  },
  // Documented: null, Cross or Coplanar; nothing of touching.
  "fast-triangle-triangle-intersection": async () => {
    const { trianglesIntersect } = await import("fast-triangle-triangle-intersection/build/index.esm.js");
    const { Triangle, Vector3 } = await import("three");
    const triangle = (corners) => new Triangle(...corners.map((p) => new Vector3(...p)));
    return {
      boundary: "unspecified",
      triangle_triangle: ({ a, b }) => trianglesIntersect(triangle(a), triangle(b)) !== null,
    };
  },
  three: from("./three.mjs"),
  "three-mesh-bvh": from("./three_mesh_bvh.mjs"),
  "manifold-3d": from("./manifold.mjs"),
  rbush: from("./rbush.mjs"),
  flatbush: from("./flatbush.mjs"),
  quickhull3d: from("./quickhull3d.mjs"),
  planck: from("./planck.mjs"),
  "matter-js": from("./matter.mjs"),
  "cannon-es": from("./cannon.mjs"),
  "@dimforge/rapier3d-compat": from("./rapier3d.mjs"),
};

if (!(name in packages)) {
  console.error(`usage: node engine.mjs ${Object.keys(packages).join(" | ")}`);
  process.exit(2);
}
const { boundary = "closed", number = "binary64", pairs = "conservative", ...operations } = await packages[name]();
const version = require("./package.json").dependencies[name];
const word = (number) => (Number.isNaN(number) ? "nan" : number > 0 ? "inf" : "-inf");
const told = (_, value) => (typeof value === "number" && !Number.isFinite(value) ? word(value) : value);
const say = (line) => process.stdout.write(JSON.stringify(line, told) + "\n");

let greeted = false;
for await (const line of createInterface({ input: process.stdin })) {
  if (!greeted) {
    greeted = true;
    say({ engine: `${name} ${version}`, ops: Object.keys(operations), number, boundary, tolerance: 0, pairs });
    continue;
  }
  const { id, op, input } = JSON.parse(line);
  try {
    const answer = operations[op]?.(input);
    say(answer === undefined ? { id, unsupported: true } : { id, answer });
  } catch (error) {
    say({ id, error: String(error) });
    if (error instanceof WebAssembly.RuntimeError) process.exit(1);  // nothing can be asked after that
  }
}
