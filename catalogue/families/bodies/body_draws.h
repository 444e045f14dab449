// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "catalogue/families/bodies/impact_draws.h"
#include "catalogue/families/hard_case.h"
#include "catalogue/families/list_draws.h"

/// Lists of bodies, drawn from a draw stream.
namespace touchstone::catalogue {

using Bodies = std::vector<Bodyd>;

/// One after another ("one more?"), so that the draws of one can be cut out and leave the others as they are.
template <class Draw>
Bodies drawn_bodies(DrawStream& c, const Draw& draw) {
  Bodies list;
  while (list.size() < 12 && c.below(6) != 0) list.push_back(draw(c));
  return list;
}

inline Bodyd lattice_body(DrawStream& c) { return {lattice_mass(c), lattice_velocity(c, 20)}; }
inline Bodies lattice_bodies(DrawStream& c) { return drawn_bodies(c, lattice_body); }

/// Each of which counts.
inline Bodies many_bodies(DrawStream& c) { return long_list(c, lattice_body); }

/// In pairs of opposite momentum, and perhaps one that is lighter by far.
inline Bodies cancelling_bodies(DrawStream& c) {
  Bodies list;
  while (list.size() < 8 && c.below(4) != 0) {
    const Vector3d v = ordinary_vector(c);
    const int k = integer_in(c, -20, 19);
    list.push_back({1, v}), list.push_back({std::ldexp(1, k), -std::ldexp(1, -k) * v});
  }
  if (c.coin()) list.push_back({std::ldexp(1, -integer_in(c, 0, 119)), ordinary_vector(c)});
  return list;
}

/// Heavy and slow next to light and fast.
inline Bodies far_apart_bodies(DrawStream& c) {
  return drawn_bodies(c, [](DrawStream& d) {
    const int k = integer_in(d, -500, 500), l = integer_in(d, -500, 500);
    const double m = 1 + std::fabs(ordinary(d));
    return Bodyd{std::ldexp(m, k), std::ldexp(1, l) * ordinary_vector(d)};
  });
}

/// Full digits where products underflow in part, or overflow.
inline Bodies bodies_at_the_end(DrawStream& c) {
  return drawn_bodies(c, [](DrawStream& d) {
    const double m = 1 + std::fabs(ordinary(d));
    const int k = integer_in(d, 0, 59);
    return Bodyd{std::ldexp(m, d.one_in(4) ? 500 + k / 4 : -520 - k), at_the_end_of_products(d)};
  });
}

inline Bodies bodies_at_end_of_range(DrawStream& c) {
  return drawn_bodies(c, [](DrawStream& d) {
    const double m = std::ldexp(lattice_mass(d), -4);
    return Bodyd{m, at_the_end_of_range(d)};
  });
}

/// A mass of 0 or less, somewhere.
inline Bodies bodies_without_a_mass(DrawStream& c) {
  Bodies list = lattice_bodies(c);
  const double mass = c.coin() ? -0x1p-1074 : zero(c);
  list.push_back({mass, lattice_velocity(c, 4)});
  while (list.size() < 12 && c.coin()) list.push_back(lattice_body(c));
  return list;
}

template <auto draw>
std::tuple<Bodies> asked_of_bodies(DrawStream& c) {
  return {draw(c)};
}
/// The hard cases of a sum over bodies; `beside_a_tie` is the operation's own.
template <auto beside_a_tie>
void sums_of_bodies(HardCases<std::tuple<Bodies>>& add) {
  add("on_lattice", asked_of_bodies<lattice_bodies>);
  add("cancelling", asked_of_bodies<cancelling_bodies>);
  add("far_apart", asked_of_bodies<far_apart_bodies>);
  add("products_at_the_end", asked_of_bodies<bodies_at_the_end>);
  add("at_end_of_range", asked_of_bodies<bodies_at_end_of_range>);
  add("beside_a_tie", asked_of_bodies<beside_a_tie>);
  add("without_a_mass", asked_of_bodies<bodies_without_a_mass>);
  add.unscaled("many_bodies", asked_of_bodies<many_bodies>);
}

inline void scale_velocities(std::tuple<Bodies>& question, int k) {
  for (auto& [mass, v] : std::get<0>(question)) lengthen(v, k);
}
inline void repair_masses(std::tuple<Bodies>& question) {
  for (Bodyd& body : std::get<0>(question)) make_positive(body.mass);
}

}  // namespace touchstone::catalogue
