// SPDX-License-Identifier: Apache-2.0
// three-mesh-bvh: triangles, oriented boxes, surfaces, rays, points of solids by a ray, and its tree over objects. Its
// trees hold single precision.
import { Box3, BufferAttribute, BufferGeometry, DoubleSide, Matrix4, Mesh, Ray, Vector3 } from "three";
import { ExtendedTriangle, MeshBVH, ObjectBVH, OrientedBox } from "three-mesh-bvh";
import { upright } from "./held.mjs";
import { has_ray, replies } from "./programs.mjs";

const vector = (p) => new Vector3(...p);
const triangle = (corners) => new ExtendedTriangle(...corners.map(vector));
const turned = (obb) => {
  const held = upright(obb);
  if (!held) return undefined;
  const box = new OrientedBox(vector(held.half).negate(), vector(held.half), new Matrix4().setPosition(...held.center));
  box.needsUpdate = true;
  return box;
};
const surface = ({ vertices, faces }) => {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(vertices.flat()), 3));
  geometry.setIndex(faces.flat());
  return geometry;
};

/** ObjectBVH, of objects with two vertices each, the corners of the box; made anew for each query. */
class Tree {
  boxes = [];
  insert(box) {
    return this.boxes.push(box) - 1;
  }
  move(index, box) {
    this.boxes[index] = box;
  }
  remove(index) {
    this.boxes[index] = undefined;
  }
  there() {
    return this.boxes.flatMap((box, index) => (box ? [index] : []));
  }
  met(queries) {
    const objects = this.there().map((index) => {
      const { min, max } = this.boxes[index], geometry = new BufferGeometry();
      geometry.setAttribute("position", new BufferAttribute(new Float32Array([...min, ...max]), 3));
      const object = new Mesh(geometry);
      object.userData.index = index;
      return object;
    });
    if (objects.length === 0) return queries.map(() => []);
    const tree = new ObjectBVH(objects);
    return queries.map(({ min, max }) => {
      const query = new Box3(vector(min), vector(max)), found = [];
      tree.shapecast({
        intersectsBounds: (box) => query.intersectsBox(box),
        intersectsObject: (object) => {
          found.push(object.userData.index);
          return false;
        },
      });
      return found;
    });
  }
  in_box(box) {
    return this.met([box])[0];
  }
  pairs() {
    const there = this.there();
    const met = this.met(there.map((index) => this.boxes[index]));
    return met.flatMap((others, place) => others.map((j) => [there[place], j])).filter(([i, j]) => i < j);
  }
}

/** Whether the box of one surface lies in that of the other: then the solids may meet though the surfaces do not. */
const one_within = (a, b) => {
  const [p, q] = [a, b].map(({ vertices }) => new Box3().setFromPoints(vertices.map(vector)));
  return p.containsBox(q) || q.containsBox(p);
};
const surfaces_meet = (a, b) => new MeshBVH(surface(a)).intersectsGeometry(surface(b), new Matrix4());

/** Nothing is documented of touching. A point is inside if the first face that a ray hits is seen from behind: that is
 * how people ask, not a function of its own. Meshes are surfaces: no answer where one may lie within the other. */
export default () => ({
  boundary: "unspecified",
  number: "binary32",
  triangle_triangle: ({ a, b }) => triangle(a).intersectsTriangle(triangle(b), null, true),
  triangle_obb: ({ triangle: corners, obb }) => turned(obb)?.intersectsTriangle(triangle(corners)),
  aabb_obb: ({ aabb: { min, max }, obb }) => turned(obb)?.intersectsBox(new Box3(vector(min), vector(max))),
  // Rays of three.js have a direction of length 1: only axes are asked.
  ray_mesh: ({ ray: { origin, direction }, mesh }) => {
    if (Math.hypot(...direction) !== 1 || direction.filter((x) => x !== 0).length !== 1) return undefined;
    if (mesh.faces.length === 0) return false;
    return new MeshBVH(surface(mesh)).raycastFirst(new Ray(vector(origin), vector(direction)), DoubleSide) !== null;
  },
  point_in_polyhedron: ({ mesh, point }) => {
    const ray = new Ray(vector(point), new Vector3(1, 0, 0));
    const hit = new MeshBVH(surface(mesh)).raycastFirst(ray, DoubleSide);
    return Boolean(hit) && hit.face.normal.dot(ray.direction) > 0;
  },
  polyhedron_polyhedron: ({ a, b }) => surfaces_meet(a, b) || (one_within(a, b) ? undefined : false),
  broad_phase: (program) => (has_ray(program) ? undefined : replies(new Tree(), program)),
});
