// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/solids/meeting_solids.h"

#include <optional>

namespace touchstone::oracle {

Motion motion(const ConvexMesh& a, const ConvexMesh& b, const std::array<Rational, 3>& velocity) {
  Integer common(1);
  for (const Rational* number : {&a.unit, &b.unit, &velocity[0], &velocity[1], &velocity[2]})
    mpz_lcm(common.get_mpz_t(), common.get_mpz_t(), number->get_den_mpz_t());
  const auto integer = [&common](const Rational& number) {
    return Integer(number.get_num() * (common / number.get_den()));
  };
  const auto vertices = [&integer](const ConvexMesh& mesh) {
    const Integer unit = integer(mesh.unit);
    std::vector<Coordinates> list;
    for (const auto& p : mesh.vertices) list.push_back({Integer(p.x * unit), Integer(p.y * unit), Integer(p.z * unit)});
    return list;
  };
  return {vertices(a),
          vertices(b),
          {integer(velocity[0]), integer(velocity[1]), integer(velocity[2])},
          Rational(1 / Rational(common))};
}

/// The least s for which a displacement with coordinates of at most s makes them meet: s, and the positive and the
/// negative part of each coordinate.
Rational distance(const Motion& m) {
  Meeting meeting(m, 7, 6);
  const int size = meeting.more();
  for (int k = 0; k < 3; ++k) {
    for (int part = 0; part < 2; ++part) {
      const int variable = size + 1 + 2 * k + part, row = 6 + 2 * k + part;
      meeting.program().set_coefficient(k, variable, Integer(1 - 2 * part));
      meeting.program().set_coefficient(row, variable, Integer(1));
      meeting.program().set_coefficient(row, size, Integer(-1));
    }
  }
  meeting.program().feasible();
  return meeting.optimum(size);
}

/// The distance by which a can be moved towards the nearest corner of a cube and still meet b.
Rational depth(const Motion& m) {
  std::optional<Rational> least;
  for (int corner = 0; corner < 8; ++corner) {
    Meeting meeting(m, 1, 0);
    const auto side = [corner](int k) { return Integer((corner >> k & 1) != 0 ? -1 : 1); };
    meeting.set(meeting.more(), {side(0), side(1), side(2)}, 1);
    meeting.program().feasible();
    const Rational displacement = meeting.optimum(meeting.more(), -1);
    if (!least || displacement < *least) least = displacement;
  }
  return least.value();
}

}  // namespace touchstone::oracle
