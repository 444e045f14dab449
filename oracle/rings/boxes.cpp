// SPDX-License-Identifier: Apache-2.0
#include "oracle/rings/boxes.h"

#include <bit>

namespace touchstone::oracle {
namespace {

const Integer* lesser(const Integer& a, const Integer& b) { return b < a ? &b : &a; }
const Integer* greater(const Integer& a, const Integer& b) { return a < b ? &b : &a; }

/// The distance of a number from an interval.
Integer outside(const Integer& number, const Integer& low, const Integer& high) {
  return number < low ? Integer(low - number) : number > high ? Integer(number - high) : Integer(0);
}

}  // namespace

Boxes::Boxes(const std::vector<Segment2<Integer>>& edges) : edges_(edges), boxes_(2 * std::bit_ceil(edges.size()) - 1) {
  build(0, 0, edges.size());
}

Boxes::Box Boxes::box_of(const Segment2<Integer>& edge) {
  return {lesser(edge.a.x, edge.b.x), greater(edge.a.x, edge.b.x), lesser(edge.a.y, edge.b.y),
          greater(edge.a.y, edge.b.y)};
}

void Boxes::build(std::size_t node, std::size_t first, std::size_t last) {
  if (last - first == 1) {
    boxes_[node] = box_of(edges_[first]);
    return;
  }
  build(2 * node + 1, first, middle(first, last));
  build(2 * node + 2, middle(first, last), last);
  const Box &a = boxes_[2 * node + 1], &b = boxes_[2 * node + 2];
  boxes_[node] = {lesser(*a.left, *b.left), greater(*a.right, *b.right), lesser(*a.bottom, *b.bottom),
                  greater(*a.top, *b.top)};
}

Integer Boxes::squared_distance_of(std::size_t node, const Point2<Integer>& p) const {
  const Box& box = boxes_[node];
  const Integer x = outside(p.x, *box.left, *box.right), y = outside(p.y, *box.bottom, *box.top);
  return Integer(x * x + y * y);
}

}  // namespace touchstone::oracle
