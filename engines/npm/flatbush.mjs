// SPDX-License-Identifier: Apache-2.0
// flatbush: a packed tree of rectangles, which stays as it is: made anew for each query.
import Flatbush from "flatbush";
import { deciding_axes, has_ray, replies } from "./programs.mjs";

class Tree {
  constructor([x, y]) {
    [this.x, this.y, this.boxes] = [x, y, []];
  }
  sides({ min, max }) {
    return [min[this.x], min[this.y], max[this.x], max[this.y]];
  }
  insert(box) {
    return this.boxes.push(box) - 1;
  }
  move(index, box) {
    this.boxes[index] = box;
  }
  remove(index) {
    this.boxes[index] = undefined;
  }
  /** What meets each of these boxes, by indices. It takes no empty list, by its documentation. */
  met(queries) {
    const there = this.boxes.flatMap((box, index) => (box ? [index] : []));
    if (there.length === 0) return queries.map(() => []);
    const tree = new Flatbush(there.length, 4);
    for (const index of there) tree.add(...this.sides(this.boxes[index]));
    tree.finish();
    return queries.map((box) => tree.search(...this.sides(box)).map((place) => there[place]));
  }
  in_box(box) {
    return this.met([box])[0];
  }
  pairs() {
    const there = this.boxes.flatMap((box, index) => (box ? [index] : []));
    const met = this.met(there.map((index) => this.boxes[index]));
    return met.flatMap((others, place) => others.map((j) => [there[place], j])).filter(([i, j]) => i < j);
  }
}

export default () => ({
  pairs: "exact",
  broad_phase: (program) => {
    const axes = has_ray(program) ? undefined : deciding_axes(program);
    return axes && replies(new Tree(axes), program);
  },
});
