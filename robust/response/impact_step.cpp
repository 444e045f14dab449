// SPDX-License-Identifier: Apache-2.0
#include "robust/response/impact_step.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "geometry/validation.h"
#include "robust/kernel/contacts/pushes_at_a_root.h"
#include "robust/kernel/contacts/rational_pushes.h"
#include "robust/kernel/integers/dyadic.h"
#include "robust/kernel/integers/one_root.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

using kernel::OneRoot;
using kernel::sign;
using Rational = mpq_class;

void validate_impact_step(const std::vector<StepBodyd>& bodies, const std::vector<Plane3d>& walls, double restitution,
                          double timestep) {
  validation::validate_all("bodies", bodies, "walls", walls, "restitution",
                           validation::under(rule::restitution, restitution), "timestep",
                           validation::under(rule::timestep, timestep));
}

Rational rational(double value) {
  const kernel::Dyadic dyadic_value = kernel::dyadic(value);
  Rational result;
  if (dyadic_value.exponent >= 0)
    mpq_mul_2exp(result.get_mpq_t(), Rational(dyadic_value.n).get_mpq_t(), dyadic_value.exponent);
  else mpq_div_2exp(result.get_mpq_t(), Rational(dyadic_value.n).get_mpq_t(), -dyadic_value.exponent);
  return result;
}
Vector3<Rational> rational(const Vector3d& v) { return {rational(v.x), rational(v.y), rational(v.z)}; }

/// A body that is at `from + t way` at time t of its flight, which began at `clock`.
struct Flight {
  Rational inverse_mass, radius, clock;
  Vector3<Rational> from, displacement, velocity;
  bool moves() const { return sgn(inverse_mass) != 0; }
  Vector3<Rational> at(const Rational& t) const { return from + t * displacement; }
  Vector3<OneRoot> at(const OneRoot& t) const { return kernel::with_root(from) + t * kernel::with_root(displacement); }
};
struct Wall {
  Vector3<Rational> normal;
  Rational offset;
};

/// A box of doubles around a ball's path to the end of the step: balls with disjoint boxes do not meet.
struct AroundFlight {
  Vector3d low, high;

  explicit AroundFlight(const Flight& flight) {
    const Vector3<Rational> from = flight.at(flight.clock), to = flight.at(Rational(1));
    const auto take = [&](double Vector3d::*axis, const Rational& a, const Rational& b) {
      low.*axis = std::nextafter(kernel::nearest(Rational(std::min(a, b) - flight.radius)), -HUGE_VAL);
      high.*axis = std::nextafter(kernel::nearest(Rational(std::max(a, b) + flight.radius)), HUGE_VAL);
    };
    take(&Vector3d::x, from.x, to.x), take(&Vector3d::y, from.y, to.y), take(&Vector3d::z, from.z, to.z);
  }
  bool apart(const AroundFlight& other) const {
    return high.x < other.low.x || other.high.x < low.x || high.y < other.low.y || other.high.y < low.y ||
           high.z < other.low.z || other.high.z < low.z;
  }
};

/// Two bodies, or a body and a wall: `other` is the index in the answer, after the bodies for a wall.
struct BodyPair {
  std::size_t body, other;
  friend auto operator<=>(const BodyPair&, const BodyPair&) = default;
};
struct Met {
  BodyPair pair;
  Vector3<OneRoot> normal;
  OneRoot parting;
  bool collides;
};

class ImpactStep {
 public:
  ImpactStep(const std::vector<StepBodyd>& bodies, const std::vector<Plane3d>& walls, double restitution,
             double timestep)
      : bounce_(1 + rational(restitution)), timestep_(rational(timestep)) {
    for (const auto& [w, v, sphere] : bodies) {
      const auto& [x, y, z] = sphere.center;
      const Vector3<Rational> velocity = rational(v);
      flights_.push_back(
          {rational(w), rational(sphere.radius), 0, rational(Vector3d{x, y, z}), timestep_ * velocity, velocity});
    }
    for (const auto& [normal, offset] : walls) walls_.push_back({rational(normal), rational(offset)});
  }

  ImpactStepd made() {
    ImpactStepd step{StepCourse::finished, {}, std::nullopt};
    while (const auto t = next_moment()) {
      if (step.moments.size() == most_moments) {
        step.relation = StepCourse::too_many_moments;
        return step;
      }
      const auto groups = groups_at(*t);
      std::vector<BodyPair> all;
      for (const auto& group : groups) {
        for (const Met& contact : group) all.push_back(contact.pair);
        if (!t->rational() && group.size() > most_contacts_at_a_root) step.relation = StepCourse::too_many_contacts;
      }
      std::sort(all.begin(), all.end());
      Moment<double> moment{kernel::nearest(*t), {}};
      for (const auto& [i, j] : all) moment.contacts.push_back({static_cast<Index>(i), static_cast<Index>(j)});
      step.moments.push_back(std::move(moment));
      if (step.relation == StepCourse::too_many_contacts) return step;
      answer(*t, groups, all);
    }
    step.bodies.emplace();
    for (const Flight& flight : flights_) {
      const auto [x, y, z] = nearest(flight.at(Rational(1)));
      step.bodies->push_back({{x, y, z}, nearest(flight.velocity)});
    }
    return step;
  }

 private:
  static Vector3d nearest(const Vector3<Rational>& v) {
    return {kernel::nearest(v.x), kernel::nearest(v.y), kernel::nearest(v.z)};
  }
  static Vector3<Rational> of_53_digits(const Vector3<OneRoot>& v) {
    return {kernel::of_53_digits(v.x), kernel::of_53_digits(v.y), kernel::of_53_digits(v.z)};
  }

  bool is_wall(std::size_t other) const { return other >= flights_.size(); }
  bool moves(std::size_t place) const { return !is_wall(place) && flights_[place].moves(); }
  template <class Visit>
  void visit_pairs(const Visit& visit) const {
    for (std::size_t i = 0; i < flights_.size(); ++i)
      for (std::size_t j = i + 1; j < flights_.size() + walls_.size(); ++j)
        if ((moves(i) || moves(j)) && (is_wall(j) || !around_[i].apart(around_[j]))) visit(BodyPair{i, j});
  }
  const Rational& start_of(const BodyPair& pair) const {
    const Rational& clock = flights_[pair.body].clock;
    return is_wall(pair.other) ? clock : std::max(clock, flights_[pair.other].clock);
  }

  /// The distance to contact, in squares for two balls: not positive if they meet.
  template <class Number>
  Number gap(const BodyPair& pair, const Vector3<Number>& normal) const {
    const Rational reach = flights_[pair.body].radius + flights_[pair.other].radius;
    return dot(normal, normal) - Number(reach * reach);
  }
  template <class Number>
  Number height(const BodyPair& pair, const Number& t) const {
    const auto& [normal, offset] = walls_[pair.other - flights_.size()];
    const Flight& f = flights_[pair.body];
    return Number(dot(normal, f.from) + offset) + t * Number(dot(normal, f.displacement));
  }
  /// True if a body meets a wall, from its height over it times the length of the normal.
  template <class Number>
  bool at_wall(const BodyPair& pair, const Number& height) const {
    const Vector3<Rational>& normal = walls_[pair.other - flights_.size()].normal;
    const Rational& radius = flights_[pair.body].radius;
    if (sign(OneRoot(height)) <= 0) return true;
    return sign(OneRoot(height * height - Number(radius * radius * dot(normal, normal)))) <= 0;
  }

  /// Sets `least` to the time at which the pair collides, if that is earlier, or there is none yet and it is at most 1.
  /// The decision is by signs at `least` itself, where a pair that approached before meets, or separates again.
  void look_at(const BodyPair& pair, std::optional<OneRoot>& least) const {
    const Rational& start = start_of(pair);
    const OneRoot limit = least ? *least : OneRoot(1);
    if (sign(OneRoot(start) - limit) > 0) return;
    if (is_wall(pair.other)) {
      const Vector3<Rational>& normal = walls_[pair.other - flights_.size()].normal;
      const Rational slope = dot(normal, flights_[pair.body].displacement), from = height(pair, start);
      if (sgn(slope) >= 0) return;
      if (at_wall(pair, from)) {
        least = OneRoot(start);
      } else if (at_wall(pair, height(pair, limit))) {
        least = kernel::with_root(start - from / slope, flights_[pair.body].radius / slope, dot(normal, normal));
      }
      return;
    }
    const Flight &a = flights_[pair.body], &b = flights_[pair.other];
    const Vector3<Rational> apart = a.at(start) - b.at(start), displacement = a.displacement - b.displacement;
    const Rational slope = dot(apart, displacement), from = gap(pair, apart);
    if (sgn(slope) >= 0) return;
    if (sgn(from) <= 0) {
      least = OneRoot(start);
      return;
    }
    const Rational square = dot(displacement, displacement), discriminant = slope * slope - square * from;
    if (sgn(discriminant) <= 0) return;
    const Vector3<OneRoot> apart_there = a.at(limit) - b.at(limit);
    const bool parts_there = sign(dot(apart_there, kernel::with_root(displacement))) > 0;
    if (!parts_there && sign(gap(pair, apart_there)) > 0) return;
    least = kernel::with_root(start - slope / square, -1 / square, discriminant);
  }
  std::optional<OneRoot> next_moment() {
    around_.clear();
    for (const Flight& flight : flights_) around_.emplace_back(flight);
    std::optional<OneRoot> least;
    visit_pairs([&](const BodyPair& pair) {
      if (settled_.count(pair) == 0) look_at(pair, least);
    });
    return least;
  }

  std::optional<Met> met_at(const OneRoot& t, const BodyPair& pair) const {
    if (sign(OneRoot(start_of(pair)) - t) > 0) return std::nullopt;
    Met met{pair, {}, {}, false};
    Vector3<Rational> relative = flights_[pair.body].velocity;
    if (is_wall(pair.other)) {
      met.normal = kernel::with_root(walls_[pair.other - flights_.size()].normal);
      if (!at_wall(pair, height(pair, t))) return std::nullopt;
    } else {
      const Flight &a = flights_[pair.body], &b = flights_[pair.other];
      met.normal = a.at(t) - b.at(t), relative = relative - b.velocity;
      if (sign(gap(pair, met.normal)) > 0 || sign(dot(met.normal, met.normal)) == 0) return std::nullopt;
    }
    met.parting = dot(met.normal, kernel::with_root(relative));
    if (sign(met.parting) > 0) return std::nullopt;
    met.collides = sign(met.parting) < 0 && settled_.count(pair) == 0;
    return met;
  }
  /// The contacts at one time in groups connected by bodies, without groups in which nothing collides.
  std::vector<std::vector<Met>> groups_at(const OneRoot& t) const {
    std::vector<std::vector<Met>> groups;
    visit_pairs([&](const BodyPair& pair) {
      const std::optional<Met> met = met_at(t, pair);
      if (!met) return;
      std::vector<Met> joined{*met};
      const auto shares = [&](const Met& c) {
        const auto either = [&](std::size_t place) {
          return moves(place) && (place == pair.body || place == pair.other);
        };
        return either(c.pair.body) || either(c.pair.other);
      };
      std::vector<std::vector<Met>> others;
      for (auto& group : groups) {
        const bool one = std::any_of(group.begin(), group.end(), shares);
        if (one) joined.insert(joined.end(), group.begin(), group.end());
        else others.push_back(std::move(group));
      }
      others.push_back(std::move(joined));
      groups = std::move(others);
    });
    std::erase_if(groups, [](const auto& group) {
      return std::none_of(group.begin(), group.end(), [](const Met& c) { return c.collides; });
    });
    return groups;
  }

  /// 1, -1 or 0 times the inverse mass: the effect of the contact's impulse on that body.
  Rational push(const BodyPair& pair, std::size_t place) const {
    if (!moves(place)) return 0;
    const Rational& w = flights_[place].inverse_mass;
    return pair.body == place ? w : pair.other == place ? Rational(-w) : Rational(0);
  }
  std::vector<OneRoot> impulses(const std::vector<Met>& group) const {
    kernel::PushesAtARoot program;
    for (const Met& c : group) {
      std::vector<OneRoot>& row = program.effects.emplace_back();
      for (const Met& d : group) {
        const Rational mass = push(d.pair, c.pair.body) - push(d.pair, c.pair.other);
        row.push_back(OneRoot(mass) * dot(c.normal, d.normal));
      }
      program.wanted.push_back(OneRoot(-bounce_) * c.parting);
    }
    return kernel::impulses_of(program);
  }
  /// For a rational time. Bodies are numbered in the order in which contacts name them.
  std::vector<OneRoot> rational_impulses(const std::vector<Met>& group) const {
    std::vector<PointBody<Rational>> bodies;
    std::map<std::size_t, Index> index;
    const auto index_of = [&](std::size_t place) {
      const auto [at, fresh] = index.try_emplace(place, static_cast<Index>(bodies.size()));
      if (fresh && is_wall(place)) bodies.push_back({0, {0, 0, 0}});
      else if (fresh) bodies.push_back({flights_[place].inverse_mass, flights_[place].velocity});
      return at->second;
    };
    std::vector<BodyContact<Rational>> contacts;
    for (const Met& c : group) {
      const Index a = index_of(c.pair.body), b = index_of(c.pair.other);
      contacts.push_back({a, b, {c.normal.x.p, c.normal.y.p, c.normal.z.p}});
    }
    const std::vector<Rational> found = kernel::impulses_of(bodies, contacts, bounce_);
    return {found.begin(), found.end()};
  }

  void answer(const OneRoot& t, const std::vector<std::vector<Met>>& groups, const std::vector<BodyPair>& all) {
    std::map<std::size_t, Vector3<OneRoot>> after;
    for (const auto& group : groups) {
      const std::vector<OneRoot> found = t.rational() ? rational_impulses(group) : impulses(group);
      for (std::size_t k = 0; k < group.size(); ++k) {
        const Met& c = group[k];
        for (const std::size_t place : {c.pair.body, c.pair.other}) {
          if (!moves(place)) continue;
          const auto [v, fresh] = after.try_emplace(place, kernel::with_root(flights_[place].velocity));
          v->second = v->second + OneRoot(push(c.pair, place)) * found[k] * c.normal;
        }
      }
    }
    std::erase_if(settled_, [&](const BodyPair& p) { return after.count(p.body) != 0 || after.count(p.other) != 0; });
    settled_.insert(all.begin(), all.end());
    const Rational clock = kernel::of_53_digits(t);
    for (const auto& [body, v] : after) {
      Flight& flight = flights_[body];
      const Vector3<Rational> at = of_53_digits(flight.at(t));
      flight.clock = clock, flight.velocity = of_53_digits(v), flight.displacement = timestep_ * flight.velocity;
      flight.from = at - clock * flight.displacement;
    }
  }

  Rational bounce_, timestep_;
  std::vector<Flight> flights_;
  std::vector<Wall> walls_;
  std::vector<AroundFlight> around_;
  std::set<BodyPair> settled_;
};

}  // namespace

ImpactStepd impact_step(const std::vector<StepBodyd>& bodies, const std::vector<Plane3d>& walls, double restitution,
                        double timestep) {
  validate_impact_step(bodies, walls, restitution, timestep);
  return ImpactStep(bodies, walls, restitution, timestep).made();
}

}  // namespace touchstone::robust
