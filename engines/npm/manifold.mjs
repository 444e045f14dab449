// SPDX-License-Identifier: Apache-2.0
// manifold-3d: whether the intersection of two solids is empty. Solids whose edges are of two faces each, of one part by
// its own count, not turned inside out, and that it takes.
import Module from "manifold-3d";

const library = await Module();
library.setup();

function of_two_faces(faces) {
  const count = new Map();
  for (const face of faces) {
    for (const k of [0, 1, 2]) {
      const edge = [face[k], face[(k + 1) % 3]].sort((i, j) => i - j).join();
      count.set(edge, (count.get(edge) ?? 0) + 1);
    }
  }
  return [...count.values()].every((n) => n === 2);
}

function solid({ vertices, faces }) {
  if (!of_two_faces(faces)) return undefined;
  const mesh = new library.Mesh({
    numProp: 3,
    vertProperties: new Float32Array(vertices.flat()),
    triVerts: new Uint32Array(faces.flat()),
  });
  let made;
  try {
    made = new library.Manifold(mesh);
  } catch {
    return undefined;  // by its documentation, where the mesh is no manifold
  }
  const parts = made.decompose();
  const one = parts.length === 1 && made.volume() > 0;
  for (const part of parts) part.delete();
  if (one) return made;
  made.delete();
  return undefined;
}

/** Solids that only touch have an empty intersection or none, nothing is documented of it. */
export default () => ({
  boundary: "unspecified",
  number: "binary32",
  polyhedron_polyhedron: ({ a, b }) => {
    const first = solid(a), second = solid(b);
    const common = first && second && first.intersect(second);
    const meet = common && !common.isEmpty();
    for (const made of [first, second, common]) made?.delete();
    return meet;
  },
});
