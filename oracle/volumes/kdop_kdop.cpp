// SPDX-License-Identifier: Apache-2.0
#include "oracle/volumes/kdop_kdop.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "geometry/validation.h"
#include "oracle/exact/numbers/decode.h"

namespace touchstone::oracle {
namespace {

/// A pair of slabs.
struct Meeting {
  Rational a_min, a_max, b_min, b_max;

  Rational least_difference() const {
    return std::min(
        {Rational(a_max - a_min), Rational(a_max - b_min), Rational(b_max - a_min), Rational(b_max - b_min)});
  }
  /// A value in the intersection; between them if it is empty.
  Rational middle() const { return Rational((std::max(a_min, b_min) + std::min(a_max, b_max)) / 2); }
};

template <class Number>
std::vector<Meeting> meetings(const Kdop3<Number>& a, const Kdop3<Number>& b) {
  validation::validate_all("a", a, "b", b);
  if (a.normals.size() != b.normals.size()) throw InvalidInput("b.normals", "the same normals as a");
  std::vector<Meeting> found;
  for (std::size_t i = 0; i < a.normals.size(); ++i) {
    const Vector3<Number>&n = a.normals[i], &m = b.normals[i];
    if (exact(n.x) != exact(m.x) || exact(n.y) != exact(m.y) || exact(n.z) != exact(m.z))
      throw InvalidInput("b.normals[" + std::to_string(i) + "]", "the same normal as in a");
    found.push_back({exact(a.slabs[i].min), exact(a.slabs[i].max), exact(b.slabs[i].min), exact(b.slabs[i].max)});
  }
  return found;
}

std::size_t deciding_kdop_kdop(const std::vector<Meeting>& all) {
  const auto least = std::min_element(all.begin(), all.end(), [](const Meeting& s, const Meeting& t) {
    return s.least_difference() < t.least_difference();
  });
  return static_cast<std::size_t>(least - all.begin());
}

Certificate certificate_kdop_kdop(const std::vector<Meeting>& all, std::size_t i, int sign) {
  const std::pair<std::string, std::vector<Rational>> slab{"slab", {Rational(i)}};
  if (sign < 0) return {"separating_slab", {slab, {"value", {all[i].middle()}}}};
  std::vector<Rational> values;
  for (const Meeting& each : all) values.push_back(each.middle());
  if (sign > 0) return {"common_values", {{"values", std::move(values)}}};
  return {"touching_slab", {slab, {"values", std::move(values)}}};
}

template <class Number>
Truth<Contact> truth_kdop_kdop(const Kdop3<Number>& a, const Kdop3<Number>& b) {
  std::vector<Meeting> all = meetings(a, b);
  const std::size_t i = deciding_kdop_kdop(all);
  const Rational least = all[i].least_difference();
  const int sign = sgn(least);
  return {sign < 0   ? Contact::disjoint
          : sign > 0 ? Contact::overlapping
                     : Contact::touching,
          Rational(abs(least)), [all = std::move(all), i, sign] { return certificate_kdop_kdop(all, i, sign); }};
}

}  // namespace

template <Exact Number>
Truth<Contact> kdop_kdop(const Kdop3<Number>& a, const Kdop3<Number>& b) {
  return truth_kdop_kdop(a, b);
}
template Truth<Contact> kdop_kdop(const Kdop3d&, const Kdop3d&);
template Truth<Contact> kdop_kdop(const Kdop3<Rational>&, const Kdop3<Rational>&);

}  // namespace touchstone::oracle
