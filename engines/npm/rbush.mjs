// SPDX-License-Identifier: Apache-2.0
// rbush: an R-tree of rectangles. Programs in which one axis decides nothing, without rays.
import RBush from "rbush";
import { deciding_axes, has_ray, replies } from "./programs.mjs";

class Tree {
  constructor([x, y]) {
    [this.x, this.y, this.tree, this.items] = [x, y, new RBush(4), []];
  }
  rectangle({ min, max }) {
    return { minX: min[this.x], minY: min[this.y], maxX: max[this.x], maxY: max[this.y] };
  }
  put(index, box) {
    this.items[index] = { ...this.rectangle(box), index };
    this.tree.insert(this.items[index]);
    return index;
  }
  insert(box) {
    return this.put(this.items.length, box);
  }
  move(index, box) {
    this.remove(index);
    this.put(index, box);
  }
  remove(index) {
    this.tree.remove(this.items[index]);
  }
  in_box(box) {
    return this.tree.search(this.rectangle(box)).map(({ index }) => index);
  }
  pairs() {
    const with_others = (item) => this.tree.search(item).map(({ index }) => [item.index, index]);
    return this.tree.all().flatMap(with_others).filter(([i, j]) => i < j);
  }
}

export default () => ({
  pairs: "exact",
  broad_phase: (program) => {
    const axes = has_ray(program) ? undefined : deciding_axes(program);
    return axes && replies(new Tree(axes), program);
  },
});
