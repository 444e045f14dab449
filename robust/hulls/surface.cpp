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

std::int32_t Surface::facet_of(std::int32_t a, std::int32_t b, std::int32_t c) {
  auto f = static_cast<std::int32_t>(facets.size());
  if (free_.empty()) {
    facets.emplace_back();
    marks_.push_back(0);
  } else {
    f = free_.back();
    free_.pop_back();
  }
  Facet& made = facet(f);
  made.corner[0] = a, made.corner[1] = b, made.corner[2] = c;
  made.above = -1;
  sides.span(made, point(a), point(b), point(c));
  return f;
}

/// The farthest point stays the first of the list.
void Surface::keep(std::int32_t q, std::int32_t f, double height, std::size_t slot) {
  Facet& of = facet(f);
  ++kept_[slot];
  if (of.above < 0 || height > farthest_[slot]) {
    point(q).next = of.above;
    of.above = q;
    farthest_[slot] = height;
  } else {
    point(q).next = point(of.above).next;
    point(of.above).next = q;
  }
}

void Surface::wait(std::int32_t f, std::size_t slot) {
  if (kept_[slot] > long_list) queue_.push_back(f);
  else if (kept_[slot] > 0) stack_.push_back(f);
}

/// The search for the next point's facet starts at the last one's: neighbours in the list are often neighbours in
/// space.
void Surface::hand_out_loose() {
  const std::size_t count = fresh_.size();
  open_slots(count);
  std::size_t slot = 0;
  double height = 0;
  for (const std::int32_t q : loose_) {
    for (std::size_t tried = 0; tried < count; ++tried, slot = slot + 1 == count ? 0 : slot + 1) {
      if (side(facet(fresh_[slot]), point(q), height) <= 0) continue;
      keep(q, fresh_[slot], height, slot);
      break;
    }
  }
  for (std::size_t i = 0; i < count; ++i) wait(fresh_[i], i);
}

/// Collects the facets below p, from facet f on: they go into seen_, their points into loose_, the edges around them
/// into rim_.
void Surface::see_from(std::int32_t f, const FramePoint& p) {
  ++stamp_;
  seen_.assign(1, f), rim_.clear(), loose_.clear();
  marks_[static_cast<std::size_t>(f)] = stamp_;
  double height = 0;
  for (std::size_t next = 0; next < seen_.size(); ++next) {
    const Facet& seen = facet(seen_[next]);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int32_t g = seen.beyond[i];
      std::int32_t& mark = marks_[static_cast<std::size_t>(g)];
      if (mark == stamp_) continue;
      if (mark != -stamp_) {
        if (side(facet(g), p, height) > 0) {
          mark = stamp_;
          seen_.push_back(g);
          continue;
        }
        mark = -stamp_;
      }
      rim_.push_back({seen.corner[i], seen.corner[next_corner(i)], g});
    }
    for (std::int32_t q = seen.above; q >= 0; q = point(q).next) {
      if (q != facet(f).above) loose_.push_back(q);
    }
  }
}

void Surface::add_farthest_of(std::int32_t f) {
  const std::int32_t p = facet(f).above;
  see_from(f, FramePoint(point(p)));
  for (const std::int32_t g : seen_) {
    facet(g).corner[0] = facet(g).above = -1;
    free_.push_back(g);
  }
  fresh_.clear();
  for (const Edge& edge : rim_) {
    const std::int32_t made = facet_of(edge.from, edge.to, p);
    fresh_.push_back(made);
    facet(made).beyond[0] = edge.beyond;
    Facet& outer = facet(edge.beyond);
    for (std::size_t i = 0; i < 3; ++i) {
      if (outer.corner[i] == edge.to && outer.corner[next_corner(i)] == edge.from) outer.beyond[i] = made;
    }
    point(edge.from).next = made;  // corners are no longer in any list
  }
  for (const std::int32_t made : fresh_) {
    const std::int32_t after = point(facet(made).corner[1]).next;
    facet(made).beyond[1] = after;
    facet(after).beyond[2] = made;
  }
  hand_out_loose();
}

void Surface::grow() {
  for (std::size_t next = 0;;) {
    std::int32_t f = -1;
    if (next < queue_.size()) {
      f = queue_[next++];
    } else if (!stack_.empty()) {
      f = stack_.back();
      stack_.pop_back();
    } else {
      return queue_.clear();
    }
    if (facet(f).alive() && facet(f).above >= 0) add_farthest_of(f);
  }
}

std::optional<std::vector<FramePoint>> Surface::start() {
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
  if (side(plane, point(d), height) == 0) {
    for (d = 0; d < count && side(plane, point(d), height) == 0; ++d) {
    }
    if (d == count) return std::vector{pa, pb, point(c)};
  }
  if (side(plane, point(d), height) > 0) std::swap(b, c);
  fresh_ = {facet_of(a, b, c), facet_of(b, a, d), facet_of(c, b, d), facet_of(a, c, d)};
  // Triangle 0 is a b c; the others stand on its edges, and their edges 1 and 2 go up to d and down again.
  for (std::size_t i = 0; i < 3; ++i) {
    facet(fresh_[0]).beyond[i] = fresh_[i + 1];
    Facet& wall = facet(fresh_[i + 1]);
    wall.beyond[0] = fresh_[0];
    wall.beyond[1] = fresh_[(i + 2) % 3 + 1];
    wall.beyond[2] = fresh_[(i + 1) % 3 + 1];
  }
  loose_.clear();
  for (std::int32_t i = 0; i < count; ++i) {
    if (i != a && i != b && i != c && i != d) loose_.push_back(i);
  }
  hand_out_loose();
  return std::nullopt;
}

}  // namespace touchstone::robust::hulls
