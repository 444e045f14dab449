// SPDX-License-Identifier: Apache-2.0
// quickhull3d: faces by index, normals to the outside. It throws on flat input, and is not judged then.
import { register } from "node:module";
import { rank } from "./exact.mjs";

/** Its files import each other without ".js", as programs that bundle them allow. */
const hook = 'export const resolve = (name, at, next) => next(name, at).catch(() => next(name + ".js", at));';

export default async () => {
  register(`data:text/javascript,${encodeURIComponent(hook)}`);
  const { default: quickhull } = await import("quickhull3d");
  return {
    convex_hull: ({ points }) => {
      try {
        return { dimension: 3, faces: quickhull(points) };
      } catch (error) {
        if (rank(points) < 3) return undefined;
        throw error;
      }
    },
  };
};
