// SPDX-License-Identifier: Apache-2.0
#include "catalogue/families/rings.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "catalogue/families/list_draws.h"
#include "catalogue/families/plane_draws.h"
#include "oracle/rings/simple.h"

namespace touchstone::catalogue {
namespace {

/// Directions of the upper half plane in counter-clockwise order; their opposites are the lower half.
constexpr std::array<Vector2d, 12> half{
    {{1, 0}, {5, 1}, {2, 1}, {1, 1}, {1, 2}, {1, 7}, {0, 1}, {-1, 5}, {-1, 2}, {-1, 1}, {-3, 1}, {-9, 1}}};

Vector2d direction(std::size_t k) {
  const Vector2d& v = half[k % half.size()];
  return k / half.size() % 2 == 0 ? v : Vector2d{-v.x, -v.y};
}

/// 1 where the stream is simple, up to 2^20 elsewhere.
double size(DrawStream& draws) {
  const double n = std::fabs(integer(draws, 20));
  return n == 0 ? 1 : n;
}

Polygon2d moved(Polygon2d ring, const Vector2d& by) {
  for (Point2d& p : ring.vertices) p = p + by;
  return ring;
}

Vector2d small_vector(DrawStream& draws) { return {integer(draws, 24), integer(draws, 24)}; }

}  // namespace

Polygon2d convex_ring(DrawStream& draws) {
  std::array<double, half.size()> times{};
  times[0] = size(draws), times[6] = size(draws);
  for (std::uint64_t more = draws.below(6); more > 0; --more) times[draws.below(half.size())] = size(draws);
  Polygon2d ring;
  Point2d p{0, 0};
  for (std::size_t k = 0; k < 2 * half.size(); ++k) {
    if (times[k % half.size()] == 0) continue;
    ring.vertices.push_back(p);
    p = p + times[k % half.size()] * direction(k);
  }
  for (std::uint64_t fewer = draws.below(3); fewer > 0 && ring.size() > 3; --fewer) {
    ring.vertices.erase(ring.vertices.begin() + static_cast<std::ptrdiff_t>(draws.below(ring.size())));
  }
  return moved(ring, small_vector(draws));
}

Polygon2d long_convex_ring(DrawStream& draws) {
  double slope = 0;
  std::vector<Vector2d> edges = long_list(draws, [&slope](DrawStream& c) {
    const double x = one_to(c, 4);
    slope += one_to(c, 2);
    return Vector2d{x, slope * x};
  });
  if (edges.size() < 2) edges.push_back({1, slope + 1});
  Polygon2d ring;
  Point2d p{0, 0};
  for (const Vector2d& edge : edges) ring.vertices.push_back(p), p = p + edge;
  if (draws.coin() || edges.size() > 16) {  // back by one edge
    ring.vertices.push_back(p);
    return ring;
  }
  for (const Vector2d& edge : edges) ring.vertices.push_back(p), p = p + -1.0 * edge;
  return ring;
}

Polygon2d star_ring(DrawStream& draws) {
  Polygon2d ring;
  // Four directions a quarter turn apart or less are always there, so that no step is half a turn.
  for (std::size_t k = 0; k < 2 * half.size(); ++k) {
    if (k % 6 != 0 && draws.below(3) != 2) continue;
    const Vector2d v = size(draws) * direction(k);
    ring.vertices.push_back({v.x, v.y});
  }
  return moved(ring, small_vector(draws));
}

Polygon2d comb_ring(DrawStream& draws) {
  Polygon2d ring;
  const std::uint64_t teeth = 1 + draws.below(6);
  double x = 0;
  for (std::uint64_t i = 0; i < teeth; ++i) {
    const double width = size(draws), height = size(draws);
    ring.vertices.insert(ring.vertices.end(), {{x, 0}, {x + width, height}});
    x += width + 1;
  }
  ring.vertices.insert(ring.vertices.end(), {{x, 0}, {x, -size(draws)}, {0, -1}});
  std::reverse(ring.vertices.begin(), ring.vertices.end());
  return moved(ring, small_vector(draws));
}

Polygon2d simple_ring(DrawStream& draws) {
  switch (draws.below(4)) {
    case 0: return convex_ring(draws);
    case 3: return comb_ring(draws);
    default: return star_ring(draws);
  }
}

Polygon2d turned(Polygon2d ring, DrawStream& draws) {
  const auto first = static_cast<std::ptrdiff_t>(draws.below(ring.size()));
  std::rotate(ring.vertices.begin(), ring.vertices.begin() + first, ring.vertices.end());
  if (draws.coin()) std::reverse(ring.vertices.begin(), ring.vertices.end());
  return ring;
}

Polygon2d with_flat_vertex(Polygon2d ring, DrawStream& draws) {
  const std::size_t i = draws.below(ring.size());
  const Point2d p = ring[i], q = ring.next(i);
  ring.vertices.insert(ring.vertices.begin() + static_cast<std::ptrdiff_t>(i + 1),
                       {std::trunc(p.x / 2 + q.x / 2), std::trunc(p.y / 2 + q.y / 2)});
  return ring;
}

Polygon2d with_flat_runs(Polygon2d ring, DrawStream& draws) {
  const auto fewest = static_cast<int>(3 - draws.below(3));
  Polygon2d fine;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const int parts = fewest + integer_in(draws, 0, 1);
    const Vector2d step = 12.0 / parts * (ring.next(i) - ring[i]);
    for (int part = 0; part < parts; ++part) {
      fine.vertices.push_back({12 * ring[i].x + part * step.x, 12 * ring[i].y + part * step.y});
    }
  }
  return fine;
}

/// n times 0.1, added up as loops do.
static double steps(double n) {
  constexpr double most = 100;
  if (std::fabs(n) > most) return 0.1 * n;
  double sum = 0;
  for (double left = std::fabs(n); left > 0; --left) sum += 0.1;
  return std::copysign(sum, n);
}

void compute(std::vector<Point2d>& points, DrawStream& draws) {
  static constexpr std::array<Vector2d, 4> turns{
      {{3.0 / 5, 4.0 / 5}, {12.0 / 13, 5.0 / 13}, {8.0 / 17, 15.0 / 17}, {0.1, 0.3}}};
  const std::uint64_t choice = draws.below(3);
  const Vector2d turn = turns[draws.below(turns.size())];
  for (Point2d& p : points) {
    if (choice == 0) p = {p.x / 10, p.y / 10};
    else if (choice == 1) p = {steps(p.x), steps(p.y)};
    else p = {turn.x * p.x - turn.y * p.y, turn.y * p.x + turn.x * p.y};
  }
}

Polygon2d with_repeated_vertex(Polygon2d ring, DrawStream& draws) {
  const std::size_t i = draws.below(ring.size());
  ring.vertices.insert(ring.vertices.begin() + static_cast<std::ptrdiff_t>(i), Point2d(ring[i]));
  return ring;
}

Polygon2d with_spike(Polygon2d ring, DrawStream& draws) {
  const std::size_t i = draws.below(ring.size());
  const Point2d p = ring[i];
  const double x = size(draws), y = integer(draws, 20);
  ring.vertices.insert(ring.vertices.begin() + static_cast<std::ptrdiff_t>(i + 1), {{p.x + x, p.y + y}, p});
  return ring;
}

Polygon2d closed(Polygon2d ring, DrawStream& draws) {
  const std::uint64_t kind = draws.below(10);
  if (kind == 9) ring.vertices.resize(2);
  const bool from_zero = kind >= 5 && kind < 8;
  if (from_zero) ring = moved(ring, {-ring[0].x, -ring[0].y});
  const Point2d first = ring[0];
  ring.vertices.push_back(from_zero ? Point2d{-0.0, zero(draws)} : first);
  if (kind == 8) ring.vertices.push_back(first);
  return ring;
}

Point2d on_line_of_an_edge(const Polygon2d& ring, DrawStream& draws) {
  const std::size_t i = draws.below(ring.size());
  return along(ring[i], small_integer(draws), ring.next(i) - ring[i]);
}

std::tuple<Polygon2d, Point2d> needle_and_point(DrawStream& draws) {
  const Point2d a = lattice_point(draws);
  const Vector2d v = lattice_direction(draws, 40);
  const double width = small_integer(draws, 1);
  return {turned({{a, along(a, 4, v), {a.x + width, a.y + 1}}}, draws), nudged(along(a, up_to(draws, 4), v), draws)};
}

Polygon2d nearly_flat_ring(DrawStream& draws) {
  const Point2d p = lattice_point(draws, 40);
  const double x = std::fabs(integer(draws, 40)) + 1, y = integer(draws, 40), off = small_integer(draws, 1);
  return turned({{p, {p.x + x, p.y + y}, {p.x + 2 * x, p.y + 2 * y + off}, {p.x + x, p.y + 0x1p42}}}, draws);
}

Polygon2d typed_flat_ring(DrawStream& draws) {
  const double x = typed(draws), y = typed(draws), far = typed(draws);
  return turned({{{0, 0}, {x, y}, {2 * x, 2 * y}, {3 * x, 3 * y}, {far, -far}}}, draws);
}

Point2d on_an_edge(const Polygon2d& ring, DrawStream& draws) {
  const std::size_t i = draws.below(ring.size());
  return ring[i] + up_to(draws, 8) / 8 * (ring.next(i) - ring[i]);
}

Point2d nudged(const Point2d& p, DrawStream& draws) {
  return {p.x + small_integer(draws, 2), p.y + small_integer(draws, 2)};
}

std::tuple<Polygon2d, Point2d> beside_least_edge(DrawStream& draws) {
  const auto high = [](double y) { return std::ldexp(y, -1028); };  // 64: the least normal number
  const double x = up_to(draws, 64) / 16, y = 16 * x + small_integer(draws, 4);
  const double top = static_cast<double>(65 + draws.below(1 << 13));
  return {turned({{{0, 0}, {4, high(64)}, {draws.coin() ? 0.0 : -3.0, high(top)}}}, draws), {x, high(y)}};
}

void untangle(Polygon2d& ring) {
  if (ring.size() < 3) return;
  for (int turns = 0; turns < 60; ++turns) {
    const auto defect = oracle::ring_defect(oracle::IntegerRing(ring));
    if (!defect || defect->first == defect->second) return;
    std::reverse(ring.vertices.begin() + static_cast<std::ptrdiff_t>(defect->first + 1),
                 ring.vertices.begin() + static_cast<std::ptrdiff_t>(defect->second + 1));
  }
}

}  // namespace touchstone::catalogue
