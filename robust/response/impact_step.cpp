// SPDX-License-Identifier: Apache-2.0
#include "robust/response/impact_step.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "geometry/validation.h"
#include "robust/kernel/contacts/push_program.h"
#include "robust/kernel/contacts/rational_pushes.h"
#include "robust/kernel/enclosed/sure.h"
#include "robust/kernel/filters/control_word.h"
#include "robust/kernel/integers/dyadic.h"
#include "robust/kernel/integers/one_root.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

using kernel::nearest, kernel::sign;
using kernel::OneRoot, kernel::Sure;
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

int sign(const Rational& x) { return sgn(x); }
double at_least(const Rational& x) { return std::nextafter(nearest(x), -HUGE_VAL); }
double at_most(const Rational& x) { return std::nextafter(nearest(x), HUGE_VAL); }

/// The numbers of a step that is exact, and of one that throws kernel::Unsure where enclosed numbers do not decide.
/// Times and what depends on them are of the type AtTime.
struct ExactStep {
  using Number = Rational;
  using AtTime = OneRoot;
  static Rational number(double x) { return rational(x); }
};
struct EnclosedStep {
  using Number = Sure;
  using AtTime = Sure;
  static Sure number(double x) { return Sure(x); }
};

/// A body that is at `from + t displacement` at time t of its flight, which began at `clock`.
template <class Numbers>
struct Flight {
  using Number = typename Numbers::Number;
  using AtTime = typename Numbers::AtTime;

  Number inverse_mass, radius, clock;
  Vector3<Number> from, displacement, velocity;
  bool moves() const { return sign(inverse_mass) != 0; }
  template <class Time>
  Vector3<Time> at(const Time& t) const {
    if constexpr (std::is_same_v<Time, Number>) return from + t * displacement;
    else return kernel::with_root(from) + t * kernel::with_root(displacement);
  }
};

/// A box of doubles around a ball's path to the end of the step: balls with disjoint boxes do not meet.
struct AroundFlight {
  Vector3d low, high;

  template <class Numbers>
  explicit AroundFlight(const Flight<Numbers>& flight) {
    using Number = typename Numbers::Number;
    const Vector3<Number> from = flight.at(flight.clock), to = flight.at(Number(1));
    const auto take = [&](double Vector3d::*axis, const Number& a, const Number& b) {
      low.*axis = std::min(at_least(Number(a - flight.radius)), at_least(Number(b - flight.radius)));
      high.*axis = std::max(at_most(Number(a + flight.radius)), at_most(Number(b + flight.radius)));
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
template <class Numbers>
class ImpactStep {
  using Number = typename Numbers::Number;
  using AtTime = typename Numbers::AtTime;
  struct Wall {
    Vector3<Number> normal;
    Number offset;
  };
  struct Met : BodyPair {
    Vector3<AtTime> normal;
    AtTime parting;
    bool collides;
  };

 public:
  ImpactStep(const std::vector<StepBodyd>& bodies, const std::vector<Plane3d>& walls, double restitution,
             double timestep)
      : bounce_(Number(1) + number(restitution)), timestep_(number(timestep)) {
    for (const auto& [w, v, sphere] : bodies) {
      const auto& [x, y, z] = sphere.center;
      const Vector3<Number> velocity = numbers(v);
      flights_.push_back(
          {number(w), number(sphere.radius), Number(0), numbers({x, y, z}), timestep_ * velocity, velocity});
    }
    for (const auto& [normal, offset] : walls) walls_.push_back({numbers(normal), number(offset)});
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
        for (const Met& contact : group) all.push_back(contact);
        if (group.size() > most_contacts_at_a_root && touching_ && !is_rational(*t))
          step.relation = StepCourse::too_many_contacts;
      }
      std::sort(all.begin(), all.end());
      Moment<double> moment{nearest(*t), {}};
      for (const auto& [i, j] : all) moment.contacts.push_back({static_cast<Index>(i), static_cast<Index>(j)});
      step.moments.push_back(std::move(moment));
      if (step.relation == StepCourse::too_many_contacts) return step;
      answer(*t, groups, all);
    }
    step.bodies.emplace();
    for (const Flight<Numbers>& flight : flights_) {
      const auto [x, y, z] = rounded(flight.at(Number(1)));
      step.bodies->push_back({{x, y, z}, rounded(flight.velocity)});
    }
    return step;
  }

 private:
  static Number number(double x) { return Numbers::number(x); }
  static Vector3<Number> numbers(const Vector3d& v) { return {number(v.x), number(v.y), number(v.z)}; }
  static Vector3d rounded(const Vector3<Number>& v) { return {nearest(v.x), nearest(v.y), nearest(v.z)}; }
  static bool is_rational(const OneRoot& t) { return t.rational(); }
  [[noreturn]] static bool is_rational(const Sure&) { throw kernel::Unsure(); }
  static Vector3<Number> of_53_digits(const Vector3<AtTime>& v) {
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
  const Number& start_of(const BodyPair& pair) const {
    const Number& clock = flights_[pair.body].clock;
    if (is_wall(pair.other)) return clock;
    const Number& other = flights_[pair.other].clock;
    return sign(Number(clock - other)) < 0 ? other : clock;
  }

  /// The distance to contact, in squares for two balls: not positive if they meet.
  template <class Value>
  Value gap(const BodyPair& pair, const Vector3<Value>& normal) const {
    const Number reach = flights_[pair.body].radius + flights_[pair.other].radius;
    return dot(normal, normal) - Value(Number(reach * reach));
  }
  template <class Value>
  Value height(const BodyPair& pair, const Value& t) const {
    const auto& [normal, offset] = walls_[pair.other - flights_.size()];
    const Flight<Numbers>& f = flights_[pair.body];
    return Value(Number(dot(normal, f.from) + offset)) + t * Value(dot(normal, f.displacement));
  }
  /// True if a body meets a wall, from its height over it times the length of the normal.
  template <class Value>
  bool at_wall(const BodyPair& pair, const Value& height) const {
    const Vector3<Number>& normal = walls_[pair.other - flights_.size()].normal;
    const Number& radius = flights_[pair.body].radius;
    if (sign(height) <= 0) return true;
    return sign(Value(height * height - Value(Number(radius * radius * dot(normal, normal))))) <= 0;
  }

  /// Sets `least` to the time at which the pair collides, if that is earlier, or there is none yet and it is at most 1.
  /// The decision is by signs at `least` itself, where a pair that approached before meets, or separates again.
  void look_at(const BodyPair& pair, std::optional<AtTime>& least) {
    const Number& start = start_of(pair);
    const AtTime limit = least ? *least : AtTime(1);
    if (sign(AtTime(start) - limit) > 0) return;
    if (is_wall(pair.other)) {
      const Vector3<Number>& normal = walls_[pair.other - flights_.size()].normal;
      const Number slope = dot(normal, flights_[pair.body].displacement), from = height(pair, start);
      if (sign(slope) >= 0) return;
      if (at_wall(pair, from)) {
        least = AtTime(start), touching_.reset();
      } else if (at_wall(pair, height(pair, limit))) {
        least = kernel::with_root(start - from / slope, flights_[pair.body].radius / slope, dot(normal, normal));
        touching_ = pair;
      }
      return;
    }
    const Flight<Numbers>&a = flights_[pair.body], &b = flights_[pair.other];
    const Vector3<Number> apart = a.at(start) - b.at(start), displacement = a.displacement - b.displacement;
    const Number slope = dot(apart, displacement), from = gap(pair, apart);
    if (sign(slope) >= 0) return;
    if (sign(from) <= 0) {
      least = AtTime(start), touching_.reset();
      return;
    }
    const Number square = dot(displacement, displacement), discriminant = slope * slope - square * from;
    if (sign(discriminant) <= 0) return;
    const Vector3<AtTime> apart_there = a.at(limit) - b.at(limit);
    const bool parts_there = sign(dot(apart_there, kernel::with_root(displacement))) > 0;
    if (!parts_there && sign(gap(pair, apart_there)) > 0) return;
    if constexpr (std::is_same_v<Numbers, ExactStep>)
      least = kernel::with_root(start - slope / square, Number(-1) / square, discriminant);
    else least = start + from / (square_root(discriminant) - slope);  // no cancellation
    touching_ = pair;
  }
  std::optional<AtTime> next_moment() {
    around_.clear();
    for (const Flight<Numbers>& flight : flights_) around_.emplace_back(flight);
    std::optional<AtTime> least;
    visit_pairs([&](const BodyPair& pair) {
      if (settled_.count(pair) == 0) look_at(pair, least);
    });
    return least;
  }

  std::optional<Met> met_at(const AtTime& t, const BodyPair& pair) const {
    if (sign(AtTime(start_of(pair)) - t) > 0) return std::nullopt;
    Met met{pair, {}, {}, false};
    Vector3<Number> relative = flights_[pair.body].velocity;
    if (is_wall(pair.other)) {
      met.normal = kernel::with_root(walls_[pair.other - flights_.size()].normal);
      if (touching_ != pair && !at_wall(pair, height(pair, t))) return std::nullopt;
    } else {
      const Flight<Numbers>&a = flights_[pair.body], &b = flights_[pair.other];
      met.normal = a.at(t) - b.at(t), relative = relative - b.velocity;
      if (touching_ != pair && sign(gap(pair, met.normal)) > 0) return std::nullopt;
      if (sign(dot(met.normal, met.normal)) == 0) return std::nullopt;
    }
    met.parting = dot(met.normal, kernel::with_root(relative));
    if (sign(met.parting) > 0) return std::nullopt;
    met.collides = sign(met.parting) < 0 && settled_.count(pair) == 0;
    return met;
  }
  /// The contacts at one time in groups connected by bodies, without groups in which nothing collides.
  std::vector<std::vector<Met>> groups_at(const AtTime& t) const {
    std::vector<std::vector<Met>> groups;
    visit_pairs([&](const BodyPair& pair) {
      const std::optional<Met> met = met_at(t, pair);
      if (!met) return;
      std::vector<Met> joined{*met};
      const auto shares = [&](const Met& c) {
        const auto either = [&](std::size_t place) {
          return moves(place) && (place == pair.body || place == pair.other);
        };
        return either(c.body) || either(c.other);
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
  Number push(const BodyPair& pair, std::size_t place) const {
    if (!moves(place)) return Number(0);
    const Number& w = flights_[place].inverse_mass;
    return pair.body == place ? w : pair.other == place ? Number(-w) : Number(0);
  }
  /// For a rational time. Bodies are numbered in the order in which contacts name them.
  std::vector<AtTime> rational_impulses(const std::vector<Met>& group) const {
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
      const Index a = index_of(c.body), b = index_of(c.other);
      contacts.push_back({a, b, {c.normal.x.p, c.normal.y.p, c.normal.z.p}});
    }
    const std::vector<Rational> found = kernel::impulses_of(bodies, contacts, bounce_);
    return {found.begin(), found.end()};
  }

  std::vector<AtTime> impulses_at(const AtTime& t, const std::vector<Met>& group) const {
    if constexpr (std::is_same_v<Numbers, ExactStep>)
      if (t.rational()) return rational_impulses(group);
    const auto push_at = [this](const Met& c, std::size_t place) { return AtTime(push(c, place)); };
    return kernel::impulses_of(kernel::push_program(group, AtTime(bounce_), push_at));
  }

  void answer(const AtTime& t, const std::vector<std::vector<Met>>& groups, const std::vector<BodyPair>& all) {
    std::map<std::size_t, Vector3<AtTime>> after;
    for (const auto& group : groups) {
      const std::vector<AtTime> found = impulses_at(t, group);
      for (std::size_t k = 0; k < group.size(); ++k) {
        const Met& c = group[k];
        for (const std::size_t place : {c.body, c.other}) {
          if (!moves(place)) continue;
          const auto [v, fresh] = after.try_emplace(place, kernel::with_root(flights_[place].velocity));
          v->second = v->second + AtTime(push(c, place)) * found[k] * c.normal;
        }
      }
    }
    std::erase_if(settled_, [&](const BodyPair& p) { return after.count(p.body) != 0 || after.count(p.other) != 0; });
    settled_.insert(all.begin(), all.end());
    const Number clock = kernel::of_53_digits(t);
    for (const auto& [body, v] : after) {
      Flight<Numbers>& flight = flights_[body];
      const Vector3<Number> at = of_53_digits(flight.at(t));
      flight.clock = clock, flight.velocity = of_53_digits(v), flight.displacement = timestep_ * flight.velocity;
      flight.from = at - clock * flight.displacement;
    }
  }

  Number bounce_, timestep_;
  std::vector<Flight<Numbers>> flights_;
  std::vector<Wall> walls_;
  std::vector<AroundFlight> around_;
  std::set<BodyPair> settled_;
  std::optional<BodyPair> touching_;  ///< meets at the next moment, a root of its gap, which no enclosed number tells
};

}  // namespace

Perhaps<ImpactStepd> stages::impact_step::enclosed(const std::vector<StepBodyd>& bodies,
                                                   const std::vector<Plane3d>& walls, double restitution,
                                                   double timestep) {
  const kernel::ControlWord guard;
  try {
    return ImpactStep<EnclosedStep>(bodies, walls, restitution, timestep).made();
  } catch (const kernel::Unsure&) {
    return std::nullopt;
  }
}

ImpactStepd stages::impact_step::exact(const std::vector<StepBodyd>& bodies, const std::vector<Plane3d>& walls,
                                       double restitution, double timestep) {
  return ImpactStep<ExactStep>(bodies, walls, restitution, timestep).made();
}

Decided<ImpactStepd> stages::impact_step::ask(const std::vector<StepBodyd>& bodies, const std::vector<Plane3d>& walls,
                                              double restitution, double timestep) {
  return in_turn<impact_step, validate_impact_step, Stage::enclosed, Stage::exact>(bodies, walls, restitution,
                                                                                   timestep);
}

ImpactStepd impact_step(const std::vector<StepBodyd>& bodies, const std::vector<Plane3d>& walls, double restitution,
                        double timestep) {
  return stages::impact_step::ask(bodies, walls, restitution, timestep).answer;
}

}  // namespace touchstone::robust
