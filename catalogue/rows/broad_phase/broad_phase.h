// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "catalogue/draw/searches.h"
#include "catalogue/families/searching_draws.h"
#include "catalogue/operation/digits.h"
#include "catalogue/operation/row.h"
#include "catalogue/signatures/broad_phase/broad_phase.h"
#include "oracle/broad_phase/broad_phase.h"
#include "oracle/exact/shapes/queries_of_boxes.h"
#include "oracle/volumes/aabb_aabb.h"
#include "reference/broad_phase/broad_phase.h"
#include "robust/broad_phase/broad_phase.h"

namespace touchstone::catalogue::rows {

struct broad_phase : signatures::broad_phase {
  TOUCHSTONE_MODULES(broad_phase)
  using decision = NoDecision;

  static constexpr Metadata metadata{.name = name,
                                     .chapter = "broad_phase",
                                     .pages = "45-47, 55-56",
                                     .question =
                                         "Which of these boxes meet each other, a box, a point or a ray, while "
                                         "some come, move and go?",
                                     .kind = Kind::covering,
                                     .fields = {"boxes", "commands"},
                                     .answer = "replies",
                                     .margin_degree = 2,
                                     .cost = 8,
                                     .time = grows(Growth::quadratic),
                                     .list_length = 2,
                                     .longest_vector = 6000};

  /// With a structure, which in exact arithmetic is made anew for each query: that is its cost.
  static constexpr Time by_structure{.robust = Growth::quadratic,
                                     .oracle = Growth::quadratic,
                                     .ask = Growth::quadratic,
                                     .reference = Growth::quadratic_log};

  static void hard_cases(HardCases<Question>& add) {
    add("small_grid", [](DrawStream& c) -> Question { return any_program(c, small_box, 6, 12); });
    add("lattice_that_touches", [](DrawStream& c) -> Question { return any_program(c, cell, 12, 12); });
    add("beside_by_ulps", [](DrawStream& c) -> Question {
      return any_program(
          c,
          [](DrawStream& d) {
            const auto end = [&d] { return 1 + up_to(d, 3) * 0x1p-52; };
            Aabb3d box{{end(), 0, 0}, {end(), 1, 1}};
            if (d.coin()) std::swap(box.min.x, box.min.y), std::swap(box.max.x, box.max.y);
            put_in_order(box);
            return box;
          },
          6, 8);
    });
    add("flat_and_zero", [](DrawStream& c) -> Question {
      const auto end = [](DrawStream& d) { return std::array{0.0, -0.0, 0x1p-1074, -0x1p-1074}[d.below(4)]; };
      return any_program(
          c, [&end](DrawStream& d) { return box_of(d, end); }, 6, 8);
    });
    add("to_the_ends", [](DrawStream& c) -> Question {
      // Planes and halves of space, as boxes that reach to the greatest number.
      return any_program(
          c,
          [](DrawStream& d) {
            Aabb3d box = box_from_to(-greatest_number, greatest_number);
            double Point3d::*const axis = std::array{&Point3d::x, &Point3d::y, &Point3d::z}[d.below(3)];
            const double at = small_integer(d, 2);
            if (!d.coin()) box.min.*axis = at;
            if (!d.coin()) box.max.*axis = box.min.*axis == at ? at : greatest_number;
            return box;
          },
          4, 8);
    });
    add("there_and_back", [](DrawStream& c) -> Question {
      Programming p(c);
      p.start_with(2 + c.below(3), cell);
      const auto any = [&c] { return cell(c); };
      while (c.below(4) != 0) {
        p.any_query(any);
        p.move(shifted(cell(c), 100, 0, 0));
        p.any_query(any);
        p.move(cell(c));
      }
      p.ask();
      return p.program();
    });
    add("first_ones_removed", [](DrawStream& c) -> Question {
      // Places in the list of those that are there are no indices any more.
      Programming p(c);
      p.start_with(2 + c.below(6), small_box);
      for (std::size_t left = 1 + c.below(3); left > 0; --left) p.remove();
      p.ask();
      for (std::size_t left = c.below(3); left > 0; --left) p.insert(small_box(c));
      p.ask();
      return p.program();
    });
    add("all_removed", [](DrawStream& c) -> Question {
      Programming p(c);
      p.start_with(c.below(4), cell);
      while (!p.there().empty()) p.remove();
      p.ask();
      for (std::size_t left = c.below(4); left > 0; --left) p.insert(cell(c));
      p.ask();
      return p.program();
    });
    add("many_moves", [](DrawStream& c) -> Question {
      // One body goes farther and farther, and others stay.
      Programming p(c);
      p.start_with(1 + c.below(4), cell);
      const double step = one_to(c, 3);
      double at = 0;
      for (std::size_t left = 4 + c.below(28); left > 0; --left) {
        p.move(shifted(cell(c), at += step, 0, 0));
        if (c.below(4) == 1) p.ask_in({{at - 1, 0, 0}, {at + 1, 1, 1}});
      }
      p.ask_along({{0, 0, 0}, {1, 0, 0}});
      p.ask();
      return p.program();
    });
    add("on_one_plane", [](DrawStream& c) -> Question {
      const double height = small_integer(c);
      const auto flat = [height](DrawStream& d) {
        Aabb3d box = small_box(d);
        box.min.z = box.max.z = height;
        return box;
      };
      return any_program(c, flat, 8, 8);
    });
    add("one_over_all", [](DrawStream& c) -> Question {
      Programming p(c);
      const auto any = [&c] { return cell(c); };
      const double end = c.coin() ? greatest_number : 0x1p60;
      p.start_with(box_from_to(-end, end));
      for (std::size_t left = c.below(8); left > 0; --left) p.start_with(cell(c));
      p.any_query(any);
      p.move(cell(c));
      p.any_query(any);
      p.ask();
      return p.program();
    });
    add("duplicates", [](DrawStream& c) -> Question {
      const Aabb3d one = small_box(c);
      return any_program(
          c, [&one](DrawStream& d) { return d.one_in(4) ? small_box(d) : one; }, 6, 8);
    });
    add("along_faces", [](DrawStream& c) -> Question {
      // Along lines of the lattice: through corners, along edges and faces, or past all of them.
      Programming p(c);
      for (std::size_t left = 1 + c.below(8); left > 0; --left) p.start_with(cell(c));
      for (std::size_t left = 1 + c.below(3); left > 0; --left) {
        const auto at = [&c] { return up_to(c, 5) - 1; };
        const auto step = [&c] { return std::array{0.0, 1.0, -0.0, -1.0}[c.below(4)]; };
        p.ask_along(repaired({{at(), at(), at()}, {step(), step(), step()}}));
      }
      return p.program();
    });
    add("met_at_once", [](DrawStream& c) -> Question {
      // Boxes that begin where the ray is at an integer t, on an axis each; between them, perhaps, some others.
      Programming p(c);
      const Point3d o = lattice_point_of_box(c, 6);
      const auto speed = [&c] {
        const double size = one_to(c, 7);
        return either_sign(c) * size;
      };
      const Vector3d v{speed(), speed(), speed()};
      for (std::size_t left = 2 + c.below(6); left > 0; --left) {
        const double t = up_to(c, 2), more = 8 + up_to(c, 2);
        Aabb3d box{o + t * v, o + t * v};
        double Point3d::*const axis = std::array{&Point3d::x, &Point3d::y, &Point3d::z}[c.below(3)];
        for (double Point3d::*other : {&Point3d::x, &Point3d::y, &Point3d::z})
          if (other != axis) box.min.*other -= more, box.max.*other += more;
        const double by = axis == &Point3d::x ? v.x : axis == &Point3d::y ? v.y : v.z;
        // In two steps: g++ 12 writes into a copy where the conditional is written before ".*" itself.
        Point3d& far_corner = by > 0 ? box.max : box.min;
        far_corner.*axis += by > 0 ? more : -more;
        p.start_with(box);
      }
      p.ask_along({o, v});
      return p.program();
    });
    add("reciprocals", [](DrawStream& c) -> Question {
      // Quotients beyond the range or below it, and products of 1e30.
      static constexpr std::array sizes{1.0, 1e30, 1e-30, 0x1p-1074, 0x1p-1022, 0x1p1000, greatest_number};
      const auto number = [](DrawStream& d) {
        const double size = sizes[d.below(sizes.size())];
        return size * small_integer(d, 2);
      };
      Programming p(c);
      for (std::size_t left = 1 + c.below(4); left > 0; --left) p.start_with(box_of(c, number));
      for (std::size_t left = 1 + c.below(2); left > 0; --left)
        p.ask_along(repaired({{number(c), number(c), number(c)}, {number(c), number(c), number(c)}}));
      return p.program();
    });
    add.unscaled("many_bodies", [](DrawStream& c) -> Question { return any_program(c, wide_box, 80, 4); });
    add.unscaled("long_program", [](DrawStream& c) -> Question { return any_program(c, small_box, 4, 80); });
    add.unscaled("many_answers", many_answers);
    add.unscaled("met_nearly_at_once", met_nearly_at_once);
    add("perhaps_not_there", [](DrawStream& c) -> Question {
      // An index beyond all others, of a removed body, or a valid one.
      Question question = any_program(c, small_box, 4, 6);
      auto& [boxes, commands] = question;
      const auto body = static_cast<Index>(c.below(6));
      const auto place = commands.begin() + static_cast<std::ptrdiff_t>(c.below(commands.size()));
      if (c.coin()) commands.insert(place, Remove{body});
      else commands.insert(place, Moved{body, small_box(c)});
      return question;
    });
  }

  /// Two boxes that touch at a corner: moves the one's.
  static Question map_centre() { return {{{{0, 0, 0}, {1, 1, 1}}, {{1, 1, 1}, {2, 2, 2}}}, {Ask{Query::pairs}}}; }
  static std::pair<std::size_t, std::size_t> map_axes() { return {3, 4}; }

  /// Without what only touches.
  static std::optional<Replies> as_open_sets(const Replies& truth, const Question& question) {
    Replies open = truth;
    auto reply = open.begin();
    each_query(question, [&](const std::vector<std::optional<Aabb3d>>& boxes, const Commandd& query) {
      if (auto* pairs = std::get_if<PairsReply>(&*reply)) {
        std::erase_if(pairs->pairs, [&](const IndexPair& pair) { return touching(*boxes[pair.i], *boxes[pair.j]); });
      } else if (auto* met = std::get_if<BodiesReply>(&*reply)) {
        std::erase_if(met->bodies, [&](Index body) { return only_touches(query, *boxes[body]); });
      } else {
        std::erase_if(std::get<RayReply>(*reply).in_order,
                      [&](Index body) { return only_touches(query, *boxes[body]); });
      }
      ++reply;
    });
    if (open == truth) return std::nullopt;
    return open;
  }

  /// The bodies that are there at each query.
  static std::vector<std::uint64_t> places(const Question& question) {
    std::vector<std::uint64_t> there;
    each_query(question, [&](const std::vector<std::optional<Aabb3d>>& boxes, const Commandd&) {
      there.push_back(static_cast<std::uint64_t>(
          std::count_if(boxes.begin(), boxes.end(), [](const auto& box) { return box.has_value(); })));
    });
    return there;
  }

  /// The bodies that are there at the last query, by their indices, that query, and which of them its reply names.
  static void draw(Drawing& drawing, const Question& question, const Replies& truth) {
    const auto [bodies, query] = at_last_query(question);
    if (query) draw_bodies(drawing, bodies, *query, truth.back());
    else draw_bodies(drawing, bodies);
    drawing.notes.push_back("the bodies at the last query, after " + std::to_string(std::get<1>(question).size()) +
                            " commands");
  }

  /// All programs of up to four commands over three intervals of a small grid; a query is the fifth. Some commands are
  /// of bodies that are not there.
  static std::uint64_t domain_count(int size) {
    const std::uint64_t n = intervals(size);
    const std::uint64_t commands = n + 3 * n + 3 + 1;
    return n * n * n * commands * commands * commands * commands;
  }
  static Question domain_at(int size, std::uint64_t index) {
    const std::uint64_t n = intervals(size);
    Digits digits(size, index);
    const auto interval = [size](std::uint64_t number) {
      int low = 0;
      for (; number >= static_cast<std::uint64_t>(size - low); ++low) number -= static_cast<std::uint64_t>(size - low);
      return Aabb3d{{static_cast<double>(low), 0, 0}, {low + static_cast<double>(number), 0, 0}};
    };
    Question question;
    auto& [boxes, commands] = question;
    while (boxes.size() < 3) boxes.push_back(interval(digits.next(n)));
    while (commands.size() < 4) {
      const std::uint64_t digit = digits.next(4 * n + 4);
      if (digit < n) commands.emplace_back(Insertd{interval(digit)});
      else if (digit < 4 * n) commands.emplace_back(Moved{static_cast<Index>((digit - n) / n), interval(digit % n)});
      else if (digit < 4 * n + 3) commands.emplace_back(Remove{static_cast<Index>(digit - 4 * n)});
      else commands.emplace_back(Ask{Query::pairs});
    }
    commands.emplace_back(Ask{Query::pairs});
    return question;
  }

  static Hooks<broad_phase> hooks() {
    return {.as_open_sets = as_open_sets,
            .repair = repair_program,
            .places = places,
            .map_centre = map_centre,
            .map_axes = map_axes,
            .draw = draw,
            .domain_count = domain_count,
            .domain_at = domain_at,
            .laws = {.maps = Laws::Maps::axes, .scales = true}};
  }

 protected:
  /// Draws the search of a structure as well.
  template <class Structure>
  static void draw_in(Drawing& drawing, const StructureWords& words, const Question& question, const Replies& truth) {
    const auto [bodies, query] = at_last_query(question);
    if (!query) return draw(drawing, question, truth);
    draw_in_structure<Structure>(drawing, words, bodies, *query, truth.back());
  }
  static Hooks<broad_phase> drawn_by(void (*draw)(Drawing&, const Question&, const Replies&)) {
    Hooks<broad_phase> own = hooks();
    own.draw = draw;
    return own;
  }

 private:
  static constexpr double greatest_number = std::numeric_limits<double>::max();
  static Aabb3d box_from_to(double min, double max) { return {{min, min, min}, {max, max, max}}; }

  /// The bodies that are there at the last query, and it; where nothing is asked, at the end.
  static std::pair<::touchstone::reference::IndexedBoxes<double>, std::optional<Commandd>> at_last_query(
      const Question& question) {
    using Boxes = std::vector<std::optional<Aabb3d>>;
    std::optional<Commandd> last;
    Boxes there;
    const Boxes at_end = each_query(question, [&](const Boxes& boxes, const Commandd& query) {
      there = boxes;
      last = query;
    });
    if (!last) there = at_end;
    ::touchstone::reference::IndexedBoxes<double> bodies;
    for (Index i = 0; i < there.size(); ++i)
      if (there[i]) bodies.push_back({i, *there[i]});
    return {bodies, last};
  }

  static std::uint64_t intervals(int size) {
    const auto n = static_cast<std::uint64_t>(size);
    return n * (n + 1) / 2;
  }

  static bool touching(const Aabb3d& a, const Aabb3d& b) {
    return ::touchstone::oracle::aabb_aabb(a, b).answer == Contact::touching;
  }
  /// True if a body that the query meets only touches it.
  static bool only_touches(const Commandd& query, const Aabb3d& body) {
    using ::touchstone::oracle::exact, ::touchstone::oracle::in_interior;
    if (const auto* box = std::get_if<InBoxd>(&query)) return touching(box->box, body);
    if (const auto* at = std::get_if<AtPointd>(&query)) return !in_interior(exact(at->point), exact(body));
    return !in_interior(exact(std::get<AlongRayd>(query).ray), exact(body));
  }
};

}  // namespace touchstone::catalogue::rows
