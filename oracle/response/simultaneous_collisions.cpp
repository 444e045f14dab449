// SPDX-License-Identifier: Apache-2.0
#include "oracle/response/simultaneous_collisions.h"

#include <string>

#include "geometry/validation.h"
#include "oracle/exact/shapes/whole_list.h"
#include "oracle/exact/systems/guessed_complement.h"
#include "oracle/exact/systems/principal_pivots.h"

namespace touchstone::oracle {
namespace {

/// A contact with its normal in a unit of its own.
struct IntegerContact {
  Index a, b;
  Vector3<Integer> normal;
  Rational unit;
};

template <class Number>
void validate_all_simultaneous_collisions(const std::vector<PointBody<Number>>& bodies,
                                          const std::vector<BodyContact<Number>>& contacts, const Number& e) {
  validation::validate_numbers("bodies", bodies), validation::validate_numbers("contacts", contacts);
  validation::validate_numbers("e", e);
  validation::validate("bodies", bodies);
  for (std::size_t i = 0; i < contacts.size(); ++i)
    if (!contacts[i].rules_among(bodies.size(), validation::Asking()))
      contacts[i].rules_among(bodies.size(), validation::Refusing{validation::named("contacts", {"", i})});
  validation::validate("e", e, rule::restitution);
}

template <class Number>
class System {
 public:
  System(const std::vector<PointBody<Number>>& bodies, const std::vector<BodyContact<Number>>& contacts,
         const Number& e)
      : restitution_(exact(e)) {
    std::vector<Number> inverse_masses, speeds;
    for (const auto& [w, v] : bodies) {
      inverse_masses.push_back(w);
      speeds.insert(speeds.end(), {v.x, v.y, v.z});
    }
    inverse_masses_ = integer_list(inverse_masses), speeds_ = integer_list(speeds);
    for (const auto& [a, b, n] : contacts) {
      const IntegerList list = integer_list(std::vector<Number>{n.x, n.y, n.z});
      contacts_.push_back({a, b, {list.integers[0], list.integers[1], list.integers[2]}, list.unit});
    }
  }

  Truth<SimultaneousVelocities<Rational>> resolved() const {
    const Complementary contacts = problem();
    std::optional<Complement> single = guessed_complement(contacts);
    if (!single) single = single_complement(contacts);
    const Complement found = single ? *single : lemke(contacts);
    const auto listed = [](const char* kind, const char* fact, std::vector<Rational> numbers) {
      return [=] { return Certificate{kind, {{fact, numbers}}}; };
    };
    if (!found.solved)
      return {{Resolution::impossible, {}}, std::nullopt, listed("contradiction", "weights", weights(found))};
    return {{Resolution::possible, velocities(found)}, std::nullopt, listed("pushes", "impulses", impulses(found))};
  }

 private:
  Vector3<Integer> velocity(Index body) const {
    return {speeds_.integers[3 * body], speeds_.integers[3 * body + 1], speeds_.integers[3 * body + 2]};
  }
  /// The separation at one contact due to the impulse of another, or of itself.
  Integer effect(const IntegerContact& c, const IntegerContact& d) const {
    const auto signed_mass = [this](Index body, Index pushed, Index pushed_back) {
      if (body == pushed) return inverse_masses_.integers[body];
      return body == pushed_back ? Integer(-inverse_masses_.integers[body]) : Integer(0);
    };
    const Integer mass = signed_mass(c.a, d.a, d.b) + signed_mass(c.b, d.b, d.a);
    return sgn(mass) == 0 ? Integer(0) : Integer(mass * dot(c.normal, d.normal));
  }
  /// The constants are the surplus of each contact over its demand if nothing pushes, times the denominator of e.
  Complementary problem() const {
    Complementary result;
    const Integer one = restitution_.get_den(), one_and_e = one + restitution_.get_num();
    for (const IntegerContact& c : contacts_) {
      std::vector<Integer> row;
      for (const IntegerContact& d : contacts_) row.push_back(effect(c, d));
      result.matrix.push_back(std::move(row));
      const Integer parting = dot(c.normal, velocity(c.a) - velocity(c.b));
      result.constants.push_back(parting * (sgn(parting) < 0 ? one_and_e : one));
    }
    return result;
  }
  std::vector<Vector3<Rational>> velocities(const Complement& found) const {
    const Integer below = found.denominator * restitution_.get_den();
    std::vector<Vector3<Integer>> above;
    for (Index i = 0; i < inverse_masses_.integers.size(); ++i) above.push_back(below * velocity(i));
    for (std::size_t i = 0; i < contacts_.size(); ++i) {
      const IntegerContact& c = contacts_[i];
      const Vector3<Integer> push = found.numerators[i] * c.normal;
      above[c.a] = above[c.a] + inverse_masses_.integers[c.a] * push;
      above[c.b] = above[c.b] - inverse_masses_.integers[c.b] * push;
    }
    std::vector<Vector3<Rational>> result;
    for (const Vector3<Integer>& v : above)
      result.push_back({actual(v.x, below), actual(v.y, below), actual(v.z, below)});
    return result;
  }
  Rational actual(const Integer& above, const Integer& below) const {
    Rational quotient(above, below);
    quotient.canonicalize();
    return speeds_.actual(quotient, 1);
  }
  std::vector<Rational> impulses(const Complement& found) const {
    std::vector<Rational> result;
    const Integer below = found.denominator * restitution_.get_den();
    for (std::size_t i = 0; i < contacts_.size(); ++i)
      result.push_back(actual(found.numerators[i], below) / (inverse_masses_.unit * contacts_[i].unit));
    return result;
  }
  /// Scaled to the sum 1.
  std::vector<Rational> weights(const Complement& found) const {
    std::vector<Rational> result;
    Rational sum;
    for (std::size_t i = 0; i < contacts_.size(); ++i)
      sum += result.emplace_back(Rational(found.numerators[i]) / contacts_[i].unit);
    for (Rational& weight : result) weight /= sum;
    return result;
  }

  IntegerList inverse_masses_, speeds_;
  std::vector<IntegerContact> contacts_;
  Rational restitution_;
};

template <class Number>
Truth<SimultaneousVelocities<Rational>> resolved(const std::vector<PointBody<Number>>& bodies,
                                                 const std::vector<BodyContact<Number>>& contacts, const Number& e) {
  validate_all_simultaneous_collisions(bodies, contacts, e);
  return System<Number>(bodies, contacts, e).resolved();
}

}  // namespace

template <Exact Number>
Truth<SimultaneousVelocities<Rational>> simultaneous_collisions(const std::vector<PointBody<Number>>& bodies,
                                                                const std::vector<BodyContact<Number>>& contacts,
                                                                const Number& e) {
  return resolved(bodies, contacts, e);
}
template Truth<SimultaneousVelocities<Rational>> simultaneous_collisions(const std::vector<PointBodyd>&,
                                                                         const std::vector<BodyContactd>&,
                                                                         const double&);
template Truth<SimultaneousVelocities<Rational>> simultaneous_collisions(const std::vector<PointBody<Rational>>&,
                                                                         const std::vector<BodyContact<Rational>>&,
                                                                         const Rational&);

}  // namespace touchstone::oracle
