// SPDX-License-Identifier: Apache-2.0
#include "oracle/sweeps/swept_convex_polyhedra.h"

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "oracle/exact/convex_mesh.h"
#include "oracle/exact/linear_program.h"
#include "oracle/exact/rational_validation.h"

namespace touchstone::oracle {
namespace {

using Program = LinearProgram<Integer>;
using Coordinates = std::array<Integer, 3>;

/// Vertices and velocity as integers times one positive unit.
struct Motion {
  std::vector<Coordinates> a, b;
  Coordinates velocity;
  Rational unit;
};

template <class Number>
Motion validated(const Mesh<Number>& a, const Mesh<Number>& b, const Vector3<Number>& velocity) {
  validation::validate_numbers("a", a), validation::validate_numbers("b", b),
      validation::validate_numbers("velocity", velocity);
  const ConvexMesh first("a", a), second("b", b);
  const std::array<Rational, 3> v{exact(velocity.x), exact(velocity.y), exact(velocity.z)};
  Integer common(1);
  for (const Rational* number : {&first.unit, &second.unit, &v[0], &v[1], &v[2]})
    mpz_lcm(common.get_mpz_t(), common.get_mpz_t(), number->get_den_mpz_t());
  const auto whole = [&common](const Rational& number) {
    return Integer(number.get_num() * (common / number.get_den()));
  };
  const auto vertices = [&whole](const ConvexMesh& mesh) {
    const Integer unit = whole(mesh.unit);
    std::vector<Coordinates> list;
    for (const auto& p : mesh.vertices) list.push_back({Integer(p.x * unit), Integer(p.y * unit), Integer(p.z * unit)});
    return list;
  };
  return {vertices(first), vertices(second), {whole(v[0]), whole(v[1]), whole(v[2])}, Rational(1 / Rational(common))};
}

/// Variables: the weights of a, those of b, t, and more. Rows 0 to 2: the point of a, moved by t velocity, is that of
/// b; 3 and 4: the sums of the weights; 5: t <= 1; and more.
class Meeting {
 public:
  explicit Meeting(const Motion& m, int more_variables = 0, int more_rows = 0)
      : time_(static_cast<int>(m.a.size() + m.b.size())),
        variables_(time_ + 1 + more_variables),
        program_(variables_, rows(more_rows)) {
    int variable = 0;
    for (const Coordinates& p : m.a) set(variable, p, 1), program_.set_coefficient(3, variable++, Integer(1));
    for (const Coordinates& p : m.b) set(variable, p, -1), program_.set_coefficient(4, variable++, Integer(1));
    set(time_, m.velocity, 1), program_.set_coefficient(5, time_, Integer(1));
    for (const int row : {3, 4, 5}) program_.set_right_side(row, Integer(1));
  }

  /// The three coefficients in rows 0 to 2.
  void set(int variable, const Coordinates& p, int sign) {
    for (int k = 0; k < 3; ++k) program_.set_coefficient(k, variable, Integer(sign * p[static_cast<std::size_t>(k)]));
  }

  int time() const { return time_; }
  int more() const { return time_ + 1; }
  Program& program() { return program_; }
  Rational value(int variable) const { return quotient(program_.numerator(variable), program_.denominator()); }

  /// The least value of a variable of a program that is feasible; with the cost -1 the greatest.
  Rational optimum(int variable, int cost = 1) {
    std::vector<Integer> costs(static_cast<std::size_t>(variables_), Integer(0));
    costs[static_cast<std::size_t>(variable)] = cost;
    program_.minimise(costs);
    return value(variable);
  }

 private:
  static std::vector<Program::Row> rows(int more) {
    std::vector<Program::Row> rows(6 + static_cast<std::size_t>(more), Program::Row::at_most);
    std::fill(rows.begin(), rows.begin() + 5, Program::Row::equal);
    return rows;
  }

  int time_, variables_;
  Program program_;
};

/// The least s for which a displacement with coordinates of at most s lets them meet: s, and the positive and the
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

/// How far a can be moved towards the nearest corner of a cube and still meet b.
Rational depth(const Motion& m) {
  std::optional<Rational> least;
  for (int corner = 0; corner < 8; ++corner) {
    Meeting meeting(m, 1, 0);
    const auto side = [corner](int k) { return Integer((corner >> k & 1) != 0 ? -1 : 1); };
    meeting.set(meeting.more(), {side(0), side(1), side(2)}, 1);
    meeting.program().feasible();
    const Rational way = meeting.optimum(meeting.more(), -1);
    if (!least || way < *least) least = way;
  }
  return least.value();
}

std::vector<Rational> listed(const Coordinates& p) { return {Rational(p[0]), Rational(p[1]), Rational(p[2])}; }

Integer product(const Coordinates& p, const Coordinates& q) { return Integer(p[0] * q[0] + p[1] * q[1] + p[2] * q[2]); }

/// A normal n with n . velocity > 0 and n . p + t n . velocity <= n . q for all vertices p of a and q of b. Variables:
/// the positive and the negative parts of n, and of a number in between; n . velocity is 1 in the unit's square.
std::vector<Rational> touching_normal(const Motion& m, const Rational& t) {
  std::vector<Program::Row> rows(m.a.size() + m.b.size() + 1, Program::Row::at_most);
  rows.back() = Program::Row::equal;
  Program program(8, rows);
  const auto set = [&program](int row, int variable, const Integer& coefficient) {
    program.set_coefficient(row, variable, coefficient);
    program.set_coefficient(row, variable + 1, Integer(-coefficient));
  };
  int row = 0;
  const Integer& d = t.get_den();
  for (const Coordinates& p : m.a) {
    for (std::size_t k = 0; k < 3; ++k)
      set(row, static_cast<int>(2 * k), Integer(d * p[k] + t.get_num() * m.velocity[k]));
    set(row++, 6, Integer(-d));
  }
  for (const Coordinates& q : m.b) {
    for (std::size_t k = 0; k < 3; ++k) set(row, static_cast<int>(2 * k), Integer(-q[k]));
    set(row++, 6, Integer(1));
  }
  for (std::size_t k = 0; k < 3; ++k) set(row, static_cast<int>(2 * k), m.velocity[k]);
  program.set_right_side(row, product(m.velocity, m.velocity));
  if (!program.feasible()) throw std::logic_error("solids that first meet on the way are separated until then");
  const auto part = [&program](int k) {
    return Rational(rational(Integer(program.numerator(2 * k) - program.numerator(2 * k + 1))));
  };
  return {part(0), part(1), part(2)};
}

Certificate of_hit(const Motion& m, const Meeting& meeting, const Rational& t) {
  std::array<Rational, 3> point;
  for (std::size_t j = 0; j < m.b.size(); ++j) {
    const Rational weight = meeting.value(static_cast<int>(m.a.size() + j));
    for (std::size_t k = 0; k < 3; ++k) point[k] += weight * m.b[j][k];
  }
  std::vector<Rational> common;
  for (const Rational& coordinate : point) common.push_back(Rational(coordinate * m.unit));
  if (sgn(t) == 0) return {"start", {{"point", std::move(common)}}};
  return {"first_contact", {{"point", std::move(common)}, {"normal", touching_normal(m, t)}}};
}

Truth<FirstContact<Rational>> truth(Motion m) {
  Meeting meeting(m);
  if (!meeting.program().feasible()) {
    const auto& y = meeting.program().farkas();
    return {{HitRelation::never, std::nullopt},
            Rational(distance(m) * m.unit),
            [x = Integer(-y[0]), y = Integer(-y[1]), z = Integer(-y[2])] {
              return Certificate{"separating_axis", {{"normal", listed({x, y, z})}}};
            }};
  }
  const Rational t = meeting.optimum(meeting.time()), margin(depth(m) * m.unit);
  return {{HitRelation::hit, t}, margin, [m = std::move(m), meeting = std::move(meeting), t] {
            return of_hit(m, meeting, t);
          }};
}

}  // namespace

Truth<FirstContact<Rational>> swept_convex_polyhedra(const Meshd& a, const Meshd& b, const Vector3d& velocity) {
  return truth(validated(a, b, velocity));
}

template <Exact Number>
Truth<FirstContact<Rational>> swept_convex_polyhedra(const Mesh<Number>& a, const Mesh<Number>& b,
                                                     const Vector3<Number>& velocity) {
  return truth(validated(a, b, velocity));
}
template Truth<FirstContact<Rational>> swept_convex_polyhedra(const Mesh<Rational>&, const Mesh<Rational>&,
                                                              const Vector3<Rational>&);

}  // namespace touchstone::oracle
