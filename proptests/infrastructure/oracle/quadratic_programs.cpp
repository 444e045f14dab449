// SPDX-License-Identifier: Apache-2.0
#include <CGAL/Gmpq.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>

#include "catalogue/rows/response/simultaneous_collisions.h"
#include "proptests/catch.h"

// CGAL as second opinion: of the velocities themselves, where the oracle looks for impulses.
namespace touchstone {
namespace {

using Row = catalogue::rows::simultaneous_collisions;
using oracle::Rational;

CGAL::Gmpq for_cgal(const Rational& number) { return CGAL::Gmpq(number.get_mpq_t()); }
Rational from_cgal(const CGAL::Quotient<CGAL::Gmpq>& number) {
  return Rational(mpq_class(number.numerator().mpq()) / mpq_class(number.denominator().mpq()));
}

/// The least sum of m (v' - v)^2 over the bodies that can move, with every contact's demand met.
SimultaneousVelocities<Rational> by_cgal(const Row::Question& question) {
  const auto& [bodies, contacts, e] = question;
  CGAL::Quadratic_program<CGAL::Gmpq> program(CGAL::LARGER, false, 0, false, 0);
  std::vector<std::vector<Rational>> before;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const auto& [w, v] = bodies[i];
    before.push_back({oracle::exact(v.x), oracle::exact(v.y), oracle::exact(v.z)});
    for (std::size_t k = 0; k < 3 && w != 0; ++k) {
      const Rational doubled_mass = 2 / oracle::exact(w);
      const int variable = static_cast<int>(3 * i + k);
      program.set_d(variable, variable, for_cgal(doubled_mass));
      program.set_c(variable, for_cgal(Rational(-doubled_mass * before[i][k])));
    }
  }
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const auto& [a, b, n] = contacts[i];
    const std::vector<Rational> normal{oracle::exact(n.x), oracle::exact(n.y), oracle::exact(n.z)};
    Rational parting, fixed;
    for (std::size_t k = 0; k < 3; ++k) {
      parting += normal[k] * (before[a][k] - before[b][k]);
      const auto place = [&](Index body, const Rational& part) {
        if (bodies[body].inverse_mass == 0) fixed += part * before[body][k];
        else program.set_a(static_cast<int>(3 * body + k), static_cast<int>(i), for_cgal(part));
      };
      place(a, normal[k]), place(b, Rational(-normal[k]));
    }
    const Rational demand = parting < 0 ? Rational(-oracle::exact(e) * parting) : Rational(0);
    program.set_b(static_cast<int>(i), for_cgal(Rational(demand - fixed)));
  }
  const auto solution = CGAL::solve_quadratic_program(program, CGAL::Gmpq());
  if (solution.is_infeasible()) return {Resolution::impossible, {}};
  auto value = solution.variable_values_begin();
  std::vector<Vector3<Rational>> after;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    std::vector<Rational> v = before[i];
    for (std::size_t k = 0; k < 3; ++k)
      if (bodies[i].inverse_mass != 0) v[k] = from_cgal(value[static_cast<std::ptrdiff_t>(3 * i + k)]);
    after.push_back({v[0], v[1], v[2]});
  }
  return {Resolution::possible, after};
}

bool same(const SimultaneousVelocities<Rational>& a, const SimultaneousVelocities<Rational>& b) {
  if (a.relation != b.relation || a.velocities.has_value() != b.velocities.has_value()) return false;
  for (std::size_t i = 0; a.velocities && i < a.velocities->size(); ++i) {
    const auto &v = (*a.velocities)[i], &w = (*b.velocities)[i];
    if (v.x != w.x || v.y != w.y || v.z != w.z) return false;
  }
  return true;
}

}  // namespace

TEST_CASE("quadratic programs: CGAL finds the velocities of simultaneous_collisions that the oracle finds") {
  std::size_t possible = 0, impossible = 0;
  for (const auto& family : catalogue::hard_cases_of<Row>()) {
    for (std::uint64_t i = 0; i < 40; ++i) {
      catalogue::DrawStream draws = catalogue::DrawStream::seeded(catalogue::seed_of(1, family.name.c_str(), i));
      const Row::Question question = family.draw(draws);
      const auto found = [&]() -> std::optional<SimultaneousVelocities<Rational>> {
        try {
          return catalogue::ask_oracle<Row>(question).answer;
        } catch (const InvalidInput&) {
          return std::nullopt;
        }
      }();
      if (!found) continue;
      ++(found->relation == Resolution::possible ? possible : impossible);
      INFO(family.name << ", case " << i);
      CHECK(same(*found, by_cgal(question)));
    }
  }
  CHECK(possible > 200);
  CHECK(impossible > 20);
}

}  // namespace touchstone
