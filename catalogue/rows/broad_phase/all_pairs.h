// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "catalogue/families/box_draws.h"
#include "catalogue/families/list_draws.h"
#include "catalogue/families/program_draws.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/broad_phase/all_pairs.h"
#include "oracle/broad_phase/all_pairs.h"
#include "oracle/volumes/aabb_aabb.h"
#include "oracle/volumes/sphere_sphere.h"
#include "reference/broad_phase/all_pairs.h"
#include "robust/broad_phase/all_pairs.h"

namespace touchstone::catalogue::rows {

struct all_pairs : signatures::all_pairs {
  TOUCHSTONE_STAGED_MODULES(all_pairs)
  using decision = NoDecision;

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "broad_phase",
                                     .pages = "55-56",
                                     .question = "Which of these balls, or boxes, meet?",
                                     .kind = Kind::covering,
                                     .fields = {"spheres"},
                                     .other_fields = {{"boxes"}},
                                     .answer = "pairs",
                                     .margin_degree = 2,
                                     .time = {.robust = Growth::linearithmic,
                                              .oracle = Growth::quadratic,
                                              .ask = Growth::quadratic,
                                              .reference = Growth::quadratic},
                                     .list_length = 2};

  static void hard_cases(HardCases<Question>& add) {
    add("grid_of_spheres", [](DrawStream& c) -> Question {
      return list_of<Sphere3d>(c, [](DrawStream& d) {
        return Sphere3d{{small_integer(d, 4), small_integer(d, 4), small_integer(d, 4)}, up_to(d, 3)};
      });
    });
    add("grid_of_boxes", [](DrawStream& c) -> Question { return list_of<Aabb3d>(c, small_box); });
    add("tangent_chain", [](DrawStream& c) -> Question {
      static constexpr std::array<std::array<double, 4>, 6> steps{
          {{3, 4, 0, 5}, {1, 2, 2, 3}, {2, 3, 6, 7}, {4, 4, 7, 9}, {2, 10, 11, 15}, {5, 12, 0, 13}}};
      Spheres chain{{{0, 0, 0}, 1}};
      while (chain.size() < 12 && c.below(5) != 0) {
        const auto [x, y, z, length] = steps[c.below(6)];
        const Sphere3d& last = chain.back();
        chain.push_back({{last.center.x + x, last.center.y + y, last.center.z + z}, length - last.radius});
        if (chain.back().radius < 0) chain.pop_back();
      }
      return std::tuple(chain);
    });
    add("touching_boxes", [](DrawStream& c) -> Question {
      const double low = integer(c, 20);
      Boxes row{{{low, 0, 0}, {low + 1, 1, 1}}};
      while (row.size() < 12 && c.below(5) != 0) {
        const Point3d corner = row.back().max;
        const double width = up_to(c, 3), y = up_to(c, 2);
        row.push_back({{corner.x, y, 0}, {corner.x + width, y + 1, 1}});
      }
      return std::tuple(row);
    });
    add("coincident", [](DrawStream& c) -> Question {
      const double x = integer(c, 30), r = up_to(c, 2);
      const Sphere3d one{{x, -x, 0}, r};
      Spheres same(1 + c.below(6), one);
      if (c.coin()) same.push_back({{x, -x, 2 * r}, r});
      return std::tuple(same);
    });
    add("one_over_all", [](DrawStream& c) -> Question {
      Question question = list_of<Sphere3d>(c, [](DrawStream& d) {
        return Sphere3d{{integer(d, 20), integer(d, 20), 0}, up_to(d, 1)};
      });
      std::get<0>(std::get<0>(question)).push_back({{0, 0, 0}, c.coin() ? 0x1p60 : 0x1p19});
      return question;
    });
    add("subnormal_radii", [](DrawStream& c) -> Question {
      const auto least = [](DrawStream& d) { return std::ldexp(up_to(d, 5), -1074); };
      return list_of<Sphere3d>(c, [&](DrawStream& d) {
        return Sphere3d{{std::ldexp(0x1p53 + 2 * up_to(d, 8), -1074), 0, least(d)}, least(d)};
      });
    });
    add("much_rounded", [](DrawStream& c) -> Question {
      // One position and one radius just above a power of two, the others far smaller: differences and sums round
      // by all they may.
      const auto large = [&c] { return 1 + up_to(c, 2) * 0x1p-52; };
      const auto small = [&c] { return up_to(c, 255) * 0x1p-60; };
      const double x = large(), r = large(), y = small(), s = small();
      const int e = integer_in(c, -300, 300);
      Spheres two{{{std::ldexp(x, e), 0, 0}, std::ldexp(s, e)},
                  {{std::ldexp(either_sign(c) * y, e), 0, 0}, std::ldexp(r, e)}};
      if (c.coin()) std::swap(two[0], two[1]);
      return std::tuple(two);
    });
    add("rounded_tangent", [](DrawStream& c) -> Question {
      const Point3d p = ordinary_point_in_space(c), q = ordinary_point_in_space(c);
      const Vector3d v = q - p;
      const double distance = std::sqrt(dot(v, v)), r = distance * up_to(c, 8) / 8;
      return std::tuple(Spheres{{p, r}, {q, std::fabs(moved_by_ulps(distance - r, integer_in(c, -3, 3)))}});
    });
    add("few", [](DrawStream& c) -> Question {
      const Sphere3d one{{integer(c, 8), 0, 0}, 1};
      const std::size_t count = c.below(3);
      if (c.coin()) return std::tuple(Boxes(count, lattice_box(c)));
      return std::tuple(Spheres(count, one));
    });
    add("typed_touch", [](DrawStream& c) -> Question {
      // As typed, in tenths, each touches the next; as doubles they are a hair apart, or overlap.
      static constexpr std::array<std::array<int, 4>, 6> steps{
          {{4, -1, 8, 9}, {3, 4, 0, 5}, {-1, 2, 2, 3}, {2, 3, -6, 7}, {4, -4, 7, 9}, {0, -3, -4, 5}}};
      int x = static_cast<int>(small_integer(c)), y = static_cast<int>(small_integer(c)), z = 0, r = 3;
      Spheres chain{{{x / 10.0, y / 10.0, z / 10.0}, r / 10.0}};
      for (std::uint64_t more = 1 + c.below(6); more > 0; --more) {
        const auto [dx, dy, dz, length] = steps[c.below(6)];
        const int k = integer_in(c, 1, 4);
        if (k * length < r) continue;
        x += k * dx, y += k * dy, z += k * dz, r = k * length - r;
        chain.push_back({{x / 10.0, y / 10.0, z / 10.0}, r / 10.0});
      }
      return std::tuple(shuffled(chain, c));
    });
    add.unscaled("many", [](DrawStream& c) -> Question {
      // In a row, in any order: none meets more than its neighbours. The truth asks every pair: seldom so many.
      const std::size_t most = c.coin() ? 300 : 80;
      double x = 0;
      const auto box = [&x](DrawStream& d) {
        const double from = x + up_to(d, 1), y = up_to(d, 1);
        x = from + 2;
        return Aabb3d{{from, y, 0}, {x, y + 1, 2}};
      };
      const Boxes row = long_list(c, box, most);
      if (c.coin()) return std::tuple(shuffled(row, c));
      Spheres balls;
      for (const Aabb3d& box : row) balls.push_back({{box.min.x + 1, box.min.y, 0}, 1});
      return std::tuple(shuffled(balls, c));
    });
    add.unscaled("stacked", [](DrawStream& c) -> Question {
      // Along y or z most begin where the one below ends, in any order: nodes of a tree touch there.
      const bool along_y = !c.coin();
      double top = 0;
      const auto box = [&](DrawStream& d) {
        const double low = top + static_cast<double>(d.below(8) / 7), x = up_to(d, 1);
        top = low + one_to(d, 3);
        return along_y ? Aabb3d{{x, low, 0}, {x + 1, top, 1}} : Aabb3d{{x, 0, low}, {x + 1, 1, top}};
      };
      Boxes tower;
      for (std::uint64_t left = 12 + c.below(8); left > 0; --left) tower.push_back(box(c));
      return std::tuple(shuffled(tower, c));
    });
    add.unscaled("crossed", [](DrawStream& c) -> Question {
      // Long along x or along y, which makes two classes of boxes; among them one that is large, and many that touch.
      Boxes sticks;
      for (std::uint64_t left = 20 + c.below(5); left > 0; --left) {
        const double x = up_to(c, 8), y = up_to(c, 8), z = up_to(c, 20), height = static_cast<double>(c.below(8) / 7);
        const bool along_x = left % 2 == 0;
        sticks.push_back({{x, y, z}, {x + (along_x ? 24 : 1), y + (along_x ? 1 : 24), z + height}});
      }
      if (c.below(4) == 0) sticks.back().max.z += 40;
      return std::tuple(shuffled(sticks, c));
    });
  }

  static void repair(Question& question) {
    if (auto* balls = std::get_if<0>(&question)) {
      for (Sphere3d& ball : std::get<0>(*balls)) ball.radius = std::fabs(ball.radius);
    } else {
      for (Aabb3d& box : std::get<0>(std::get<1>(question))) put_in_order(box);
    }
  }

  /// Two balls that touch: moves the radius of one and the height of the other.
  static Question map_centre() { return std::tuple(Spheres{{{0, 0, 0}, 2}, {{3, 4, 0}, 3}}); }
  static std::pair<std::size_t, std::size_t> map_axes() { return {3, 5}; }

  using Pairs = std::vector<IndexPair>;
  /// Solids that only touch are no pair.
  static std::optional<Pairs> as_open_sets(const Pairs& truth, const Question& question) {
    Pairs open = truth;
    std::erase_if(open, [&](const IndexPair& pair) { return touching(pair, question); });
    if (open.size() == truth.size()) return std::nullopt;
    return open;
  }

  static Hooks<all_pairs> hooks() {
    return {.as_open_sets = as_open_sets,
            .repair = repair,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .laws = {.maps = Laws::Maps::axes, .scales = true}};
  }

 private:
  /// One after another ("one more?"), so that the draws of one can be cut out and leave the others as they are.
  template <class Shape, class Draw>
  static Question list_of(DrawStream& c, const Draw& draw) {
    std::vector<Shape> list;
    while (list.size() < 24 && c.below(6) != 0) list.push_back(draw(c));
    return std::tuple(list);
  }

  static bool touching(const IndexPair& pair, const Question& question) {
    if (const auto* asked = std::get_if<std::tuple<Spheres>>(&question)) {
      const Spheres& list = std::get<0>(*asked);
      return ::touchstone::oracle::sphere_sphere(list[pair.i], list[pair.j]).answer == Contact::touching;
    }
    const Boxes& list = std::get<0>(std::get<std::tuple<Boxes>>(question));
    return ::touchstone::oracle::aabb_aabb(list[pair.i], list[pair.j]).answer == Contact::touching;
  }
};

}  // namespace touchstone::catalogue::rows
