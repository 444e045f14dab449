// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <bit>
#include <cmath>

#include "catalogue/families/draw_stream.h"
#include "catalogue/judge/environment.h"
#include "geometry/invalid_input.h"
#include "proptests/property.h"
#include "robust/lines/explicit_line.h"
#include "robust/lines/line_line.h"
#include "robust/lines/orientation.h"
#include "robust/lines/point_on_segment.h"
#include "robust/lines/ray_segment.h"
#include "robust/lines/segment_segment.h"

// Decisions about small integers, asked again with one axis stretched to one end of the range of the doubles and the
// other to any end: no decision changes, whatever the environment does to subnormal numbers. What it takes away from a
// factor near the least normal number, a huge other factor makes visible; only the guards of the filters keep that out.
namespace touchstone::proptests::stretched_tests {
namespace {

using catalogue::DrawStream, catalogue::environment_count, catalogue::environment_name, catalogue::in_environment;

/// Powers of two for the numbers along x and along y.
struct Stretch {
  int x, y;
};
constexpr Stretch stretches[] = {{1000, -1024}, {-1024, 1000}, {600, -1040}, {-1040, 600}, {330, -1030},
                                 {-1030, 330},  {140, -1024},  {-1024, 140}, {1010, 1010}, {-1060, -1060}};

/// `ask(numbers)` takes numbers along x and y in turn and returns a decision.
template <std::size_t N, class Ask>
int changed_decisions(const char* name, const Ask& ask) {
  const auto cases = static_cast<std::uint64_t>(scaled(4000));
  int changed = 0;
  for (std::uint64_t i = 0; i < cases; ++i) {
    DrawStream draws = DrawStream::seeded(catalogue::seed_of(1, name, i));
    std::array<double, N> small;
    for (double& number : small) number = static_cast<double>(draws.below(17)) - 8;
    const int expected = ask(small);
    const Stretch by = stretches[draws.below(std::size(stretches))];
    std::array<double, N> stretched = small;
    for (std::size_t k = 0; k < N; ++k) stretched[k] = std::ldexp(small[k], k % 2 == 0 ? by.x : by.y);
    for (std::size_t environment = 0; environment < environment_count; ++environment) {
      if (in_environment(environment, stretched, ask) == expected) continue;
      if (changed++ == 0) UNSCOPED_INFO(name << ": case " << i << ", " << environment_name(environment));
    }
  }
  return changed;
}

template <class Relation>
int both(Relation alone, Relation answered) {
  return alone == answered ? static_cast<int>(alone) : -1;
}

}  // namespace

TEST_CASE("stretched: the side of a line and what lies on a segment") {
  CHECK(changed_decisions<6>("stretched side", [](const auto& n) {
          return static_cast<int>(robust::orientation({n[0], n[1]}, {n[2], n[3]}, {n[4], n[5]}));
        }) == 0);
  CHECK(changed_decisions<6>("stretched point", [](const auto& n) {
          const Point2d p{n[0], n[1]};
          const Segment2d s{{n[2], n[3]}, {n[4], n[5]}};
          return both(robust::point_on_segment_relation(p, s), robust::point_on_segment(p, s).relation);
        }) == 0);
}

TEST_CASE("stretched: a huge vector and one of the least, in any directions") {
  int changed = 0;
  for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(scaled(4000)); ++i) {
    DrawStream draws = DrawStream::seeded(catalogue::seed_of(1, "stretched vectors", i));
    std::array<double, 4> n;
    for (double& number : n) number = static_cast<double>(draws.below(17)) - 8;
    const auto ask = [](const std::array<double, 4>& q) {
      return static_cast<int>(robust::orientation({0, 0}, {q[0], q[1]}, {q[2], q[3]}));
    };
    const int expected = ask(n);
    const Stretch by = stretches[draws.below(std::size(stretches))];  // the one vector and the other
    const std::array<double, 4> stretched{std::ldexp(n[0], by.x), std::ldexp(n[1], by.x), std::ldexp(n[2], by.y),
                                          std::ldexp(n[3], by.y)};
    for (std::size_t environment = 0; environment < environment_count; ++environment)
      changed += in_environment(environment, stretched, ask) != expected;
  }
  CHECK(changed == 0);
}

TEST_CASE("stretched: how segments, and a ray and a segment, meet") {
  CHECK(changed_decisions<8>("stretched segments", [](const auto& n) {
          const Segment2d a{{n[0], n[1]}, {n[2], n[3]}}, b{{n[4], n[5]}, {n[6], n[7]}};
          return both(robust::segment_segment_relation(a, b), robust::segment_segment(a, b).relation);
        }) == 0);
  CHECK(changed_decisions<8>("stretched ray", [](const auto& n) {
          if (std::bit_cast<std::uint64_t>(n[2]) << 1 == 0 && std::bit_cast<std::uint64_t>(n[3]) << 1 == 0) return 0;
          const Ray2d ray{{n[0], n[1]}, {n[2], n[3]}};
          const Segment2d s{{n[4], n[5]}, {n[6], n[7]}};
          return both(robust::ray_segment_relation(ray, s), robust::ray_segment(ray, s).relation);
        }) == 0);
}

TEST_CASE("stretched: how lines meet") {
  CHECK(changed_decisions<8>("stretched lines", [](const auto& n) {
          const Line2d a{{n[0], n[1]}, {n[2], n[3]}}, b{{n[4], n[5]}, {n[6], n[7]}};
          try {
            return both(robust::line_line_relation(a, b), robust::line_line(a, b).relation);
          } catch (const InvalidInput&) {
            return -3;
          }
        }) == 0);
}

TEST_CASE("stretched: above or below a line, where the slope outweighs what is taken from x") {
  // x times 2^k, m times 2^l, y and b times 2^(k + l).
  int changed = 0;
  for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(scaled(4000)); ++i) {
    DrawStream draws = DrawStream::seeded(catalogue::seed_of(1, "stretched height", i));
    std::array<double, 4> n;
    for (double& number : n) number = static_cast<double>(draws.below(17)) - 8;
    const auto ask = [](const std::array<double, 4>& q) {
      return static_cast<int>(robust::explicit_line(q[0], q[1], {q[2], q[3]}));
    };
    const int expected = ask(n);
    const Stretch by = stretches[draws.below(8)];  // x and m
    const std::array<double, 4> stretched{std::ldexp(n[0], by.y), std::ldexp(n[1], by.x + by.y), std::ldexp(n[2], by.x),
                                          std::ldexp(n[3], by.x + by.y)};
    for (std::size_t environment = 0; environment < environment_count; ++environment)
      changed += in_environment(environment, stretched, ask) != expected;
  }
  CHECK(changed == 0);
}

}  // namespace touchstone::proptests::stretched_tests
