// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/steps.h"
#include "proptests/space_laws.h"

/// Laws of motion, as identities over rationals.
namespace touchstone::proptests {

using Motion3 = Vector3<Rational>;

template <class R>
Motion3 exactly(const Vector3<R>& v) {
  if constexpr (std::is_same_v<R, Rational>) return v;
  else return {exact(v.x), exact(v.y), exact(v.z)};
}
inline bool same(const Motion3& v, const Motion3& w) { return v.x == w.x && v.y == w.y && v.z == w.z; }
inline Motion3 none() { return {Rational(0), Rational(0), Rational(0)}; }

/// The same question in rationals.
template <class Asked>
auto in_rationals(const Asked& asked) {
  return catalogue::converted<Rational>(asked, [](double number) { return exact(number); });
}

/// The property that `holds(ask, asked)` for the oracle, both over rationals: what rounding would break.
template <class Row, class Holds>
void exact_law(const std::string& sentence, const Holds& holds) {
  law_of<Row>(
      "oracle: " + sentence, [](const auto& asked) { return catalogue::ask_oracle<Row>(asked).answer; },
      [&](const auto& ask, const auto& asked) { return holds(ask, in_rationals(asked)); }, 3);
}

#define EXACT_LAW(...) TOUCHSTONE_LAW(exact_law, __COUNTER__, __VA_ARGS__)

/// Where the contracts of `response` bound the formula's error: every number is 0 or between 2^-100 and 2^100 in size.
template <class... Asked>
bool moderate(const Asked&... asked) {
  bool all = true;
  const auto look = [&all](const double& number) {
    const double size = std::fabs(number);
    all = all && (size == 0 || (size >= 0x1p-100 && size <= 0x1p100));
  };
  (catalogue::for_each_number(asked, look), ...);
  return all;
}

/// |vx nx| + |vy ny| + |vz nz| over n . n.
inline Rational condition(const Motion3& v, const Motion3& n) {
  return Rational((abs(v.x * n.x) + abs(v.y * n.y) + abs(v.z * n.z)) / dot(n, n));
}

/// Whether computed components differ from the exact ones by at most (along |n_i| + stays |v_i|) u.
inline bool within_bounds(const Vector3d& computed, const Motion3& truth, const Motion3& n, const Rational& along,
                          const Motion3& v, int stays) {
  const auto kept = [&](double found, const Rational& exactly, const Rational& n_i, const Rational& v_i) {
    return within(found, exactly, (along * abs(n_i) + stays * abs(v_i)) * unit());
  };
  return kept(computed.x, truth.x, n.x, v.x) && kept(computed.y, truth.y, n.y, v.y) &&
         kept(computed.z, truth.z, n.z, v.z);
}

/// The vector times 2^k, where that is exact.
inline std::optional<Vector3d> longer(const Vector3d& v, int k) {
  const Vector3d w = std::ldexp(1, k) * v, back{std::ldexp(w.x, -k), std::ldexp(w.y, -k), std::ldexp(w.z, -k)};
  if (!finite(w.x, w.y, w.z) || !equal(back, v)) return std::nullopt;
  return w;
}

/// Normals of the same plane: times powers of two, and opposite.
inline std::vector<Vector3d> same_plane(const Vector3d& n) {
  std::vector<Vector3d> found{{-n.x, -n.y, -n.z}};
  for (const int k : {1, -1, 60, -60, 700, -700})
    if (const auto stretched = longer(n, k)) found.push_back(*stretched);
  return found;
}

/// The normal's length and side do not matter; it is the question's part of that number.
template <std::size_t normal>
inline constexpr auto any_normal_of_the_plane = [](const auto& ask, const auto& asked) {
  const auto answer = ask(asked);
  const Vector3d& n = std::get<normal>(asked);
  const auto keeps = [&](const Vector3d& other) {
    auto question = asked;
    std::get<normal>(question) = other;
    return equal(ask(question), answer);
  };
  const auto normals = same_plane(n);
  return std::all_of(normals.begin(), normals.end(), keeps) && (!on_small_lattice(std::tuple(n)) || keeps(3.0 * n));
};

/// Whether components are those times 2^k, as far as rounding keeps its relative place.
template <class R>
bool scaled_vector(const Vector3<R>& v, const Vector3<R>& found, int k) {
  return scaled_number(v.x, found.x, k) && scaled_number(v.y, found.y, k) && scaled_number(v.z, found.z, k);
}

/// +0, as IEEE 754's sum of both zeros.
inline bool plus_zero(double x) { return x == 0 && !std::signbit(x); }

/// Whether the answer stays when all inverse masses of the first argument are in another unit.
template <class Asked, class Ask>
bool inverse_masses_have_any_unit(const Asked& asked, const Ask& ask) {
  for (const int k : {1, -30, 300}) {
    auto other = asked;
    bool held = true;
    for (auto& body : std::get<0>(other)) {
      const double w = std::ldexp(body.inverse_mass, k);
      held = held && finite(w) && std::ldexp(w, -k) == body.inverse_mass;
      body.inverse_mass = w;
    }
    if (held && !equal(ask(other), ask(asked))) return false;
  }
  return true;
}

/// Whether the answer stays when the normals of all walls, the second argument, are longer or shorter.
template <class Asked, class Ask>
bool normals_of_walls_have_any_length(const Asked& asked, const Ask& ask) {
  for (const int k : {1, -30, 300}) {
    auto other = asked;
    bool held = true;
    for (Plane3d& wall : std::get<1>(other)) {
      const auto normal = longer(wall.normal, k);
      const double offset = std::ldexp(wall.offset, k);
      held = held && normal && finite(offset) && std::ldexp(offset, -k) == wall.offset;
      if (held) wall = {*normal, offset};
    }
    if (held && !equal(ask(other), ask(asked))) return false;
  }
  return true;
}

/// A question of a step with its bodies and walls in reverse order.
template <class Asked>
Asked in_reverse_order(Asked asked) {
  std::reverse(std::get<0>(asked).begin(), std::get<0>(asked).end());
  std::reverse(std::get<1>(asked).begin(), std::get<1>(asked).end());
  return asked;
}
/// Contacts of that, as those of the question itself.
inline void reverse_back(std::vector<IndexPair>& contacts, std::size_t bodies, std::size_t walls) {
  const auto turned = [&](Index place) {
    return static_cast<Index>(place < bodies ? bodies - 1 - place : bodies + walls - 1 - (place - bodies));
  };
  for (auto& [i, j] : contacts) {
    const Index a = turned(i), b = turned(j);
    i = std::min(a, b), j = std::max(a, b);
  }
  std::sort(contacts.begin(), contacts.end(),
            [](const IndexPair& a, const IndexPair& b) { return a.i != b.i ? a.i < b.i : a.j < b.j; });
}

/// Of worked examples in the plane.
namespace steps_in_the_plane {
inline StepBodyd ball(double x, double y, double radius, double vx, double vy, double inverse_mass = 1) {
  return {inverse_mass, {vx, vy, 0}, {{x, y, 0}, radius}};
}
inline const Plane3d ground{{0, 1, 0}, 0};
}  // namespace steps_in_the_plane

/// The test case of any_normal_of_the_plane, in the types of the file's `Row`.
#define NORMAL_LAW(operation, normal)                                   \
  TEST_CASE(operation ": the normal's length and side do not matter") { \
    law<Row>("the same plane", any_normal_of_the_plane<normal>);        \
  }

}  // namespace touchstone::proptests
