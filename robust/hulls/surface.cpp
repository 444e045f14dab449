// SPDX-License-Identifier: Apache-2.0
#include "robust/hulls/surface.h"

#include <algorithm>

namespace touchstone::robust::hulls {
namespace {

std::size_t next_corner(std::size_t i) { return i == 2 ? 0 : i + 1; }

/// A facet with a longer list waits for its turn.
constexpr std::int32_t long_list = 512;

double squared(double x, double y, double z) { return x * x + y * y + z * z; }

}  // namespace

std::int32_t Surface::facet_of(Growth& own, std::int32_t a, std::int32_t b, std::int32_t c) {
  auto f = static_cast<std::int32_t>(facets.size());
  if (!own.free.empty()) {
    f = own.free.back();
    own.free.pop_back();
  } else if (own.next_free < own.end_of_free) {
    f = own.next_free++;
  } else {
    facets.emplace_back();
    marks_.push_back(0);
  }
  Facet& made = facet(f);
  made.corner[0] = a, made.corner[1] = b, made.corner[2] = c;
  made.above = -1;
  own.sides.span(made, point(a), point(b), point(c));
  return f;
}

/// The farthest point stays the first of the list.
void Surface::keep(Growth& own, std::int32_t q, std::int32_t f, double height, std::size_t slot) {
  Facet& of = facet(f);
  ++own.kept[slot];
  if (of.above < 0 || height > own.farthest[slot]) {
    point(q).next = of.above;
    of.above = q;
    own.farthest[slot] = height;
  } else {
    point(q).next = point(of.above).next;
    point(of.above).next = q;
  }
}

void Surface::wait(Growth& own, std::int32_t f, std::size_t slot) {
  if (own.kept[slot] > long_list) own.queue.push_back(f);
  else if (own.kept[slot] > 0) own.stack.push_back(f);
}

/// The search for the next point's facet starts at the last one's: neighbours in the list are often neighbours in
/// space.
void Surface::hand_out_loose(Growth& own) {
  const std::size_t count = own.fresh.size();
  open_slots(own, count);
  std::size_t slot = 0;
  double height = 0;
  for (const std::int32_t q : own.loose) {
    for (std::size_t tried = 0; tried < count; ++tried, slot = slot + 1 == count ? 0 : slot + 1) {
      if (side(own, facet(own.fresh[slot]), point(q), height) <= 0) continue;
      keep(own, q, own.fresh[slot], height, slot);
      break;
    }
  }
  for (std::size_t i = 0; i < count; ++i) wait(own, own.fresh[i], i);
}

/// Collects the facets below p, from facet f on: they go into own.seen, their points into own.loose, the edges around
/// them into own.rim. False if it meets a facet of another region.
bool Surface::see_from(Growth& own, std::int32_t f, const FramePoint& p) {
  ++own.stamp;
  own.seen.assign(1, f), own.rim.clear(), own.loose.clear();
  marks_[static_cast<std::size_t>(f)] = own.stamp;
  double height = 0;
  for (std::size_t next = 0; next < own.seen.size(); ++next) {
    const Facet& seen = facet(own.seen[next]);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int32_t g = seen.beyond[i];
      if (!belongs_to(own, g)) return false;
      std::int32_t& mark = marks_[static_cast<std::size_t>(g)];
      if (mark == own.stamp) continue;
      if (mark != -own.stamp) {
        if (side(own, facet(g), p, height) > 0) {
          mark = own.stamp;
          own.seen.push_back(g);
          continue;
        }
        mark = -own.stamp;
      }
      own.rim.push_back({seen.corner[i], seen.corner[next_corner(i)], g});
    }
    for (std::int32_t q = seen.above; q >= 0; q = point(q).next) {
      if (q != facet(f).above) own.loose.push_back(q);
    }
  }
  return true;
}

void Surface::add_farthest_of(Growth& own, std::int32_t f) {
  const std::int32_t p = facet(f).above;
  if (!see_from(own, f, FramePoint(point(p)))) return own.blocked.push_back(f);
  for (const std::int32_t g : own.seen) {
    facet(g).corner[0] = facet(g).above = -1;
    own.free.push_back(g);
  }
  own.fresh.clear();
  for (const Edge& edge : own.rim) {
    const std::int32_t made = facet_of(own, edge.from, edge.to, p);
    own.fresh.push_back(made);
    facet(made).beyond[0] = edge.beyond;
    Facet& outer = facet(edge.beyond);
    for (std::size_t i = 0; i < 3; ++i) {
      if (outer.corner[i] == edge.to && outer.corner[next_corner(i)] == edge.from) outer.beyond[i] = made;
    }
    first_edge(own, edge.from) = made;  // corners are no longer in any list
  }
  for (const std::int32_t made : own.fresh) {
    const std::int32_t after = first_edge(own, facet(made).corner[1]);
    facet(made).beyond[1] = after;
    facet(after).beyond[2] = made;
  }
  hand_out_loose(own);
}

void Surface::grow(Growth& own) {
  for (std::size_t next = 0;;) {
    std::int32_t f = -1;
    if (next < own.queue.size()) {
      f = own.queue[next++];
    } else if (!own.stack.empty()) {
      f = own.stack.back();
      own.stack.pop_back();
    } else {
      return own.queue.clear();
    }
    if (facet(f).alive() && facet(f).above >= 0) add_farthest_of(own, f);
  }
}

std::optional<std::vector<FramePoint>> Surface::start() {
  Growth& own = whole_;
  const auto count = static_cast<std::int32_t>(points.size());
  // The two points farthest apart on one axis.
  std::int32_t a = 0, b = 0;
  double most = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    std::int32_t low = 0, high = 0;
    for (std::int32_t i = 1; i < count; ++i) {
      if (point(i)[k] < point(low)[k]) low = i;
      if (point(i)[k] > point(high)[k]) high = i;
    }
    if (point(high)[k] - point(low)[k] > most) most = point(high)[k] - point(low)[k], a = low, b = high;
  }
  const FramePoint pa = point(a), pb = point(b);
  if (a == b) return std::vector{pa};
  // The one farthest from their line, up to rounding.
  std::int32_t c = a;
  most = -1;
  const double x = pb.x - pa.x, y = pb.y - pa.y, z = pb.z - pa.z;
  for (std::int32_t i = 0; i < count; ++i) {
    const double u = point(i).x - pa.x, v = point(i).y - pa.y, w = point(i).z - pa.z;
    const double size = squared(y * w - z * v, z * u - x * w, x * v - y * u);
    if (size > most) most = size, c = i;
  }
  if (sides.collinear(pa, pb, point(c))) {
    for (c = 0; c < count && sides.collinear(pa, pb, point(c)); ++c) {
    }
    if (c == count) return std::vector{pa, pb};
  }
  // And the one farthest from their plane.
  Facet plane{};
  plane.corner[0] = a, plane.corner[1] = b, plane.corner[2] = c;
  sides.span(plane, pa, pb, point(c));
  std::int32_t d = a;
  most = -1;
  for (std::int32_t i = 0; i < count; ++i) {
    const double size = std::fabs(plane.height(point(i)));
    if (size > most) most = size, d = i;
  }
  double height = 0;
  if (side(own, plane, point(d), height) == 0) {
    for (d = 0; d < count && side(own, plane, point(d), height) == 0; ++d) {
    }
    if (d == count) return std::vector{pa, pb, point(c)};
  }
  if (side(own, plane, point(d), height) > 0) std::swap(b, c);
  own.fresh = {facet_of(own, a, b, c), facet_of(own, b, a, d), facet_of(own, c, b, d), facet_of(own, a, c, d)};
  // Triangle 0 is a b c; the others stand on its edges, and their edges 1 and 2 go up to d and down again.
  for (std::size_t i = 0; i < 3; ++i) {
    facet(own.fresh[0]).beyond[i] = own.fresh[i + 1];
    Facet& wall = facet(own.fresh[i + 1]);
    wall.beyond[0] = own.fresh[0];
    wall.beyond[1] = own.fresh[(i + 2) % 3 + 1];
    wall.beyond[2] = own.fresh[(i + 1) % 3 + 1];
  }
  own.loose.clear();
  for (std::int32_t i = 0; i < count; ++i) {
    if (i != a && i != b && i != c && i != d) own.loose.push_back(i);
  }
  hand_out_loose(own);
  return std::nullopt;
}

}  // namespace touchstone::robust::hulls
