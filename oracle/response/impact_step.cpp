// SPDX-License-Identifier: Apache-2.0
#include "oracle/response/impact_step.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <numeric>
#include <set>

#include "geometry/validation.h"
#include "oracle/exact/numbers/nearest_double.h"
#include "oracle/exact/numbers/space.h"
#include "oracle/exact/shapes/around_balls.h"
#include "oracle/exact/systems/impulses_at_a_root.h"
#include "oracle/response/simultaneous_collisions.h"

namespace touchstone::oracle {
namespace {

using ImpactStepVelocity = Vector3<Rational>;
using ImpactStepPosition = Point3<Rational>;
using Column = std::vector<OverRoot>;

template <class Number>
void validate_all_impact_step(const std::vector<StepBody<Number>>& bodies, const std::vector<Plane<Number>>& walls,
                              const Number& restitution, const Number& timestep) {
  validation::validate_all("bodies", bodies, "walls", walls, "restitution",
                           validation::under(rule::restitution, restitution), "timestep",
                           validation::under(rule::timestep, timestep));
}

/// The nearest number of 53 binary digits, ties to even.
Rational of_53_digits(const Surd& x) {
  if (sgn(x) == 0) return 0;
  for (std::int64_t bits = 64;; bits *= 2) {
    const auto [low, high] = x.enclosure(bits);
    if (sgn(low) * sgn(high) <= 0) continue;
    const auto order = static_cast<int>(binary_order(low));
    if (std::abs(order - static_cast<int>(binary_order(high))) > 1) continue;  // one end may be next to 0
    return scaled(exact(nearest_double(x * Surd(scaled(Rational(1), -order)))), order);
  }
}
Rational of_53_digits(const OverRoot& x) { return of_53_digits(Surd(x)); }
template <class Number>
Vector3<Number> lifted(const Vector3<Rational>& v) {
  return {v.x, v.y, v.z};
}

struct Flight {
  Rational inverse_mass, radius, clock;
  ImpactStepPosition at;
  ImpactStepVelocity velocity;
};
/// place: the index in the answer; b: the same, or for a wall the index after the last body.
struct Met {
  Index a, b, place;
  Vector3<OverRoot> normal;
  OverRoot parting;
  bool collides;
};

class ImpactStepStep {
 public:
  template <class Number>
  ImpactStepStep(const std::vector<StepBody<Number>>& bodies, const std::vector<Plane<Number>>& walls,
                 const Number& restitution, const Number& timestep)
      : restitution_(exact(restitution)), timestep_(exact(timestep)) {
    for (const auto& [w, v, sphere] : bodies) {
      const ImpactStepVelocity velocity{exact(v.x), exact(v.y), exact(v.z)};
      flights_.push_back({exact(w), exact(sphere.radius), 0, exact(sphere.center), velocity});
    }
    for (const Plane<Number>& wall : walls) walls_.push_back(exact(wall));
  }

  Truth<ImpactStep<Surd>> made() {
    ImpactStep<Surd> step{StepCourse::finished, {}, std::nullopt};
    std::vector<Certificate> proofs;
    while (const auto moment = next_moment()) {
      const OverRoot t(*moment);
      if (step.moments.size() == most_moments) {
        step.relation = StepCourse::too_many_moments;
        break;
      }
      const std::vector<std::vector<Met>> groups = groups_at(t);
      std::vector<Met> all;
      for (const auto& group : groups) {
        all.insert(all.end(), group.begin(), group.end());
        if (!moment->rational() && group.size() > most_contacts_at_a_root)
          step.relation = StepCourse::too_many_contacts;
      }
      const auto earlier = [](const Met& c, const Met& d) { return c.a != d.a ? c.a < d.a : c.place < d.place; };
      std::sort(all.begin(), all.end(), earlier);
      std::vector<IndexPair> contacts;
      for (const Met& c : all) contacts.push_back({c.a, c.place});
      step.moments.push_back({*moment, std::move(contacts)});
      if (step.relation == StepCourse::too_many_contacts) break;
      proofs.push_back(answer(t, groups, all));
    }
    if (step.relation == StepCourse::finished) {
      step.bodies.emplace();
      for (Index i = 0; i < flights_.size(); ++i) {
        const ImpactStepPosition end = place(i, 1);
        const ImpactStepVelocity& v = flights_[i].velocity;
        step.bodies->push_back({{end.x, end.y, end.z}, lifted<Surd>(v)});
      }
    }
    return {std::move(step), std::nullopt, [proofs] { return Certificate{"impacts", {}, {{"moments", proofs}}}; }};
  }

 private:
  bool movable(Index body) const { return body < flights_.size() && sgn(flights_[body].inverse_mass) != 0; }
  Index ground() const { return static_cast<Index>(flights_.size()); }
  /// Calls visit(a, b, place) for every pair that may collide in the rest of the step.
  template <class Visit>
  void visit_pairs(const Visit& visit) const {
    for (Index i = 0; i < ground(); ++i) {
      for (Index j = i + 1; j < ground(); ++j)
        if ((movable(i) || movable(j)) && !around_[i].apart(around_[j])) visit(i, j, j);
      for (Index k = 0; k < walls_.size() && movable(i); ++k) visit(i, ground(), ground() + k);
    }
  }
  Rational start_of(Index a, Index b) const {
    return b == ground() ? flights_[a].clock : std::max(flights_[a].clock, flights_[b].clock);
  }
  ImpactStepPosition place(Index body, const Rational& t) const {
    const Flight& f = flights_[body];
    return f.at + Rational((t - f.clock) * timestep_) * f.velocity;
  }
  Point3<OverRoot> place_at(Index body, const OverRoot& t) const {
    const Flight& f = flights_[body];
    const OverRoot passed = (t - OverRoot(f.clock)) * OverRoot(timestep_);
    return Point3<OverRoot>{f.at.x, f.at.y, f.at.z} + passed * lifted<OverRoot>(f.velocity);
  }

  std::optional<Surd> collides_at(Index a, Index b, Index place_of_b) const {
    const Rational start = start_of(a, b);
    std::optional<Surd> t;
    if (b == ground()) {
      const Plane<Rational>& wall = walls_[place_of_b - ground()];
      const Rational slope = timestep_ * dot(wall.normal, flights_[a].velocity), square = dot(wall.normal, wall.normal);
      if (sgn(slope) >= 0) return std::nullopt;
      const Rational height = height_over(wall, place(a, start)), radius = flights_[a].radius;
      if (sgn(height) <= 0 || height * height <= radius * radius * square) return Surd(start);
      t = Surd(Rational(start - height / slope), Rational(radius / slope), square);
    } else {
      const ImpactStepVelocity apart = place(a, start) - place(b, start),
                               w = timestep_ * (flights_[a].velocity - flights_[b].velocity);
      const Rational reach = flights_[a].radius + flights_[b].radius, slope = dot(apart, w), square = dot(w, w),
                     gap = dot(apart, apart) - reach * reach;
      if (sgn(slope) >= 0) return std::nullopt;
      if (sgn(gap) <= 0) return Surd(start);
      const Rational discriminant = slope * slope - square * gap;
      if (sgn(discriminant) <= 0) return std::nullopt;
      t = Surd(Rational(start - slope / square), Rational(-1 / square), discriminant);
    }
    if (*t > Surd(Rational(1))) return std::nullopt;
    return t;
  }
  std::optional<Surd> next_moment() {
    std::optional<Surd> least;
    around_.assign(flights_.size(), {});
    for (Index i = 0; i < ground(); ++i)
      for (const Rational& t : {flights_[i].clock, Rational(1)}) around_[i].add(place(i, t), flights_[i].radius);
    visit_pairs([&](Index a, Index b, Index place_of_b) {
      if (settled_.count({a, place_of_b}) != 0) return;
      const std::optional<Surd> t = collides_at(a, b, place_of_b);
      if (t && (!least || *t < *least)) least = t;
    });
    return least;
  }

  /// The contacts at one time that are connected to one that collides, by groups.
  std::vector<std::vector<Met>> groups_at(const OverRoot& t) const {
    std::vector<Met> met;
    visit_pairs([&](Index a, Index b, Index place_of_b) {
      if (sgn(t - OverRoot(start_of(a, b))) < 0) return;
      const Point3<OverRoot> p = place_at(a, t);
      Vector3<OverRoot> normal;
      bool meets = false;
      if (b == ground()) {
        const Plane<Rational>& wall = walls_[place_of_b - ground()];
        normal = lifted<OverRoot>(wall.normal);
        const OverRoot height = dot(normal, Vector3<OverRoot>{p.x, p.y, p.z}) + OverRoot(wall.offset),
                       r = flights_[a].radius;
        meets = sgn(height) <= 0 || sgn(height * height - r * r * dot(normal, normal)) <= 0;
      } else {
        normal = p - place_at(b, t);
        const OverRoot reach = Rational(flights_[a].radius + flights_[b].radius), square = dot(normal, normal);
        meets = sgn(square) != 0 && sgn(square - reach * reach) <= 0;
      }
      if (!meets) return;
      const ImpactStepVelocity &v = flights_[a].velocity,
                               u = b == ground() ? ImpactStepVelocity{0, 0, 0} : flights_[b].velocity;
      const OverRoot parting = dot(normal, lifted<OverRoot>(v - u));
      const bool collides = sgn(parting) < 0 && settled_.count({a, place_of_b}) == 0;
      if (sgn(parting) <= 0) met.push_back({a, b, place_of_b, normal, parting, collides});
    });
    std::vector<Index> leader(flights_.size());
    std::iota(leader.begin(), leader.end(), 0);
    const auto leader_of = [&leader](Index body) {
      while (leader[body] != body) body = leader[body];
      return body;
    };
    for (const Met& c : met)
      if (movable(c.a) && movable(c.b)) leader[leader_of(c.a)] = leader_of(c.b);
    std::map<Index, std::vector<Met>> groups;
    for (const Met& c : met) groups[leader_of(movable(c.a) ? c.a : c.b)].push_back(c);
    std::vector<std::vector<Met>> result;
    for (const auto& [body, group] : groups) {
      const auto collides = [](const Met& c) { return c.collides; };
      if (std::any_of(group.begin(), group.end(), collides)) result.push_back(group);
    }
    return result;
  }

  /// The separation at one contact due to the impulse of another.
  OverRoot effect(const Met& c, const Met& d) const {
    const auto mass = [&](Index body, Index pushed, Index pushed_back) -> Rational {
      if (!movable(body)) return 0;
      const Rational& w = flights_[body].inverse_mass;
      return body == pushed ? w : body == pushed_back ? Rational(-w) : Rational(0);
    };
    return OverRoot(Rational(mass(c.a, d.a, d.b) + mass(c.b, d.b, d.a))) * dot(c.normal, d.normal);
  }
  Column impulses(const std::vector<Met>& group) const {
    ImpulsesWanted wanted;
    for (const Met& c : group) {
      Column& effects = wanted.effects.emplace_back();
      for (const Met& d : group) effects.push_back(effect(c, d));
      wanted.demands.push_back(OverRoot(Rational(-1 - restitution_)) * c.parting);
    }
    return impulses_at_a_root(wanted);
  }
  Column impulses_of_rationals(const std::vector<Met>& group) const {
    std::vector<PointBody<Rational>> movers;
    for (const Flight& f : flights_) movers.push_back({f.inverse_mass, f.velocity});
    movers.push_back({0, {0, 0, 0}});
    std::vector<BodyContact<Rational>> contacts;
    for (const Met& c : group) {
      const auto& [x, y, z] = c.normal;
      contacts.push_back({c.a, c.b, {x.p, y.p, z.p}});
    }
    const auto resolved = simultaneous_collisions(movers, contacts, restitution_);
    const auto found = resolved.certificate().facts.front().second;
    return {found.begin(), found.end()};
  }

  Certificate answer(const OverRoot& t, const std::vector<std::vector<Met>>& groups, const std::vector<Met>& all) {
    std::map<Index, Vector3<OverRoot>> after;
    std::map<std::pair<Index, Index>, OverRoot> impulse_of;
    for (const auto& group : groups) {
      const Column found = t.r == nullptr ? impulses_of_rationals(group) : impulses(group);
      for (std::size_t k = 0; k < group.size(); ++k) {
        const Met& c = group[k];
        impulse_of[{c.a, c.place}] = found[k];
        for (const auto& [body, sign] : {std::pair{c.a, 1}, std::pair{c.b, -1}}) {
          if (!movable(body)) continue;
          const OverRoot push = OverRoot(Rational(sign * flights_[body].inverse_mass)) * found[k];
          Vector3<OverRoot>& v = after.try_emplace(body, lifted<OverRoot>(flights_[body].velocity)).first->second;
          v = v + push * c.normal;
        }
      }
    }
    const Rational clock = of_53_digits(t);
    Certificate proof{"pushes", {{"impulses", {}}, {"impulses_of_root", {}}, {"clock", {clock}}, {"states", {}}}};
    std::erase_if(settled_,
                  [&](const auto& pair) { return after.count(pair.first) != 0 || after.count(pair.second) != 0; });
    for (const Met& c : all) {
      const OverRoot& impulse = impulse_of.at({c.a, c.place});
      proof.facts[0].second.push_back(impulse.p), proof.facts[1].second.push_back(impulse.q);
      settled_.insert({c.a, c.place});
    }
    for (const auto& [body, v] : after) {
      const Point3<OverRoot> p = place_at(body, t);
      Flight& f = flights_[body];
      f.at = {of_53_digits(p.x), of_53_digits(p.y), of_53_digits(p.z)};
      f.velocity = {of_53_digits(v.x), of_53_digits(v.y), of_53_digits(v.z)};
      f.clock = clock;
      const std::vector<Rational> state{f.at.x, f.at.y, f.at.z, f.velocity.x, f.velocity.y, f.velocity.z};
      proof.facts[3].second.insert(proof.facts[3].second.end(), state.begin(), state.end());
    }
    return proof;
  }

  Rational restitution_, timestep_;
  std::vector<Flight> flights_;
  std::vector<Plane<Rational>> walls_;
  std::vector<AroundBalls> around_;  ///< of each body on its flight to the end of the step
  std::set<std::pair<Index, Index>> settled_;
};

}  // namespace

template <Exact Number>
Truth<ImpactStep<Surd>> impact_step(const std::vector<StepBody<Number>>& bodies,
                                    const std::vector<Plane<Number>>& walls, const Number& restitution,
                                    const Number& timestep) {
  validate_all_impact_step(bodies, walls, restitution, timestep);
  return ImpactStepStep(bodies, walls, restitution, timestep).made();
}
template Truth<ImpactStep<Surd>> impact_step(const std::vector<StepBodyd>&, const std::vector<Plane3d>&, const double&,
                                             const double&);
template Truth<ImpactStep<Surd>> impact_step(const std::vector<StepBody<Rational>>&,
                                             const std::vector<Plane<Rational>>&, const Rational&, const Rational&);

}  // namespace touchstone::oracle
