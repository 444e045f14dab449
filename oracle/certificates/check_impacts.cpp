// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <set>

#include "oracle/certificates/check_steps.h"
#include "oracle/certificates/check_surd.h"

namespace touchstone::certify {
namespace {

constexpr std::size_t most_moments = 16, most_contacts_at_a_root = 6;

/// The product of numbers over one root, that of the time t.
Surd product(const Surd& x, const Surd& y) {
  const Rational& r = sgn(x.q) != 0 ? x.r : y.r;
  return {Rational(x.p * y.p + x.q * y.q * r), Rational(x.p * y.q + x.q * y.p), r};
}
Surd sum(const Surd& x, const Surd& y) { return {Rational(x.p + y.p), Rational(x.q + y.q), sgn(x.q) != 0 ? x.r : y.r}; }
Surd lifted(const Rational& x) { return {x, 0, 0}; }

struct Column {
  Surd x, y, z;
};
Column lifted(const Triple& v) { return {lifted(v.x), lifted(v.y), lifted(v.z)}; }
Column times(const Surd& t, const Column& v) { return {product(t, v.x), product(t, v.y), product(t, v.z)}; }
Column sum(const Column& v, const Column& w) { return {sum(v.x, w.x), sum(v.y, w.y), sum(v.z, w.z)}; }
Column difference(const Column& v, const Column& w) { return sum(v, times(lifted(-1), w)); }
Surd product(const Column& v, const Column& w) {
  return sum(sum(product(v.x, w.x), product(v.y, w.y)), product(v.z, w.z));
}

struct Flight {
  Rational inverse_mass, radius, clock;
  Triple at, velocity;
};
/// A body and another, or a wall: then `other` is after the bodies.
using Meeting = std::pair<std::size_t, std::size_t>;
struct Met {
  Meeting places;
  Column normal;
  Surd parting;
  bool collides;
  std::size_t group;
};

/// Requires the nearest number of 53 binary digits: n 2^k with 2^52 <= |n| < 2^53; at most half of 2^k away, or a
/// quarter on the side of 0 if n is 2^52; and n is even if the distance is exactly that.
void expect_nearest(const Rational& rounded, const Surd& exact, const std::string& what) {
  const std::string wrong = what + ": not the nearest number of 53 digits";
  if (sgn(rounded) == 0) return expect(sign(exact) == 0, wrong);
  const mpz_class &above = rounded.get_num(), &below = rounded.get_den();
  const std::size_t zeros = mpz_scan1(above.get_mpz_t(), 0), digits = mpz_sizeinbase(above.get_mpz_t(), 2) - zeros;
  expect(mpz_popcount(below.get_mpz_t()) == 1 && digits <= 53, wrong);
  const Rational size = abs(rounded), negated = -rounded;
  Rational last;  // 2^k
  mpz_class top = mpz_class(1) << (digits + zeros - 1);
  last = Rational(top, below);
  last.canonicalize();
  last /= Rational(mpz_class(1) << 52);
  const bool power = digits == 1, even = digits < 53;
  const int side = sgn(rounded);
  const Rational half = last / 2, inner = power ? Rational(last / 4) : half;
  const Surd outwards = Surd{Rational(side * exact.p), Rational(side * exact.q), exact.r};
  const int over = sign(outwards + Rational(-size - half)), under = sign(outwards + Rational(inner - size));
  expect(over < 0 || (over == 0 && even), wrong);
  expect(under > 0 || (under == 0 && even), wrong);
}

class Step {
 public:
  explicit Step(const Claim& claim) : claim_(claim) {
    for (const auto& [w, v, ball] : movers(claim.input["bodies"]))
      flights_.push_back({w, ball.radius, 0, ball.center, v});
    walls_ = planes(claim.input["walls"]);
    restitution_ = restitution(claim.input["restitution"], "restitution");
    timestep_ = number(claim.input["timestep"], "timestep");
    expect(sgn(timestep_) > 0, "timestep: timestep > 0");
  }

  void check() {
    const std::string course = claim_.word("relation");
    const bool finished = course == "finished", too_many = course == "too_many_contacts";
    expect(finished || too_many || course == "too_many_moments", "truth.relation: no such word");
    if (finished) claim_.answers({"relation", "moments", "bodies"});
    else claim_.answers({"relation", "moments"});
    claim_.expect_kind("impacts");
    claim_.facts({"moments"});
    const json &moments = claim_.truth["moments"], &proofs = claim_.certificate["moments"];
    expect(moments.is_array() && moments.size() <= most_moments, "truth.moments: a list of at most 16");
    expect(proofs.is_array() && proofs.size() + (too_many ? 1 : 0) == moments.size(),
           "certificate.moments: one for each that is answered");
    for (std::size_t k = 0; k < moments.size(); ++k) {
      const std::string name = numbered("truth.moments", k);
      only(moments[k], name, {"t", "contacts"});
      const Surd t = exact_surd(moments[k]["t"], name + ".t");
      expect(sign(t + Rational(-1)) <= 0, name + ".t: at most 1");
      const std::vector<Met> contacts = contacts_of(t, name);
      expect_listed(moments[k]["contacts"], contacts, name);
      const bool beyond = has_too_many(t, contacts);
      expect(beyond == (too_many && k + 1 == moments.size()), "truth.relation: not what the contacts say");
      if (!beyond) answer({claim_.input, claim_.truth, proofs[k]}, t, contacts, name);
    }
    if (finished) expect_end();
    else if (!too_many)
      expect(moments.size() == most_moments && another(), "truth.relation: there are no more moments");
  }

 private:
  bool is_wall(std::size_t place) const { return place >= flights_.size(); }
  bool moves(std::size_t place) const { return !is_wall(place) && sgn(flights_[place].inverse_mass) != 0; }
  const Plane& wall(std::size_t place) const { return walls_[place - flights_.size()]; }
  template <class Visit>
  void visit_pairs(const Visit& visit) const {
    for (std::size_t i = 0; i < flights_.size(); ++i)
      for (std::size_t j = i + 1; j < flights_.size() + walls_.size(); ++j)
        if (moves(i) || moves(j)) visit(Meeting{i, j});
  }
  Rational start_of(const Meeting& pair) const {
    const Rational& clock = flights_[pair.first].clock;
    return is_wall(pair.second) ? clock : std::max(clock, flights_[pair.second].clock);
  }
  Column place_at(std::size_t body, const Surd& t) const {
    const Flight& f = flights_[body];
    return sum(lifted(f.at), times((t + Rational(-f.clock)) * timestep_, lifted(f.velocity)));
  }
  Column normal_at(const Meeting& pair, const Surd& t) const {
    if (is_wall(pair.second)) return lifted(wall(pair.second).normal);
    return difference(place_at(pair.first, t), place_at(pair.second, t));
  }
  Triple relative_velocity(const Meeting& pair) const {
    const Triple& v = flights_[pair.first].velocity;
    return is_wall(pair.second) ? v : v - flights_[pair.second].velocity;
  }
  Surd parting_at(const Meeting& pair, const Surd& t) const {
    return product(normal_at(pair, t), lifted(relative_velocity(pair)));
  }
  /// The sign of their distance from touching.
  int gap_at(const Meeting& pair, const Surd& t) const {
    const Flight& f = flights_[pair.first];
    const Column n = normal_at(pair, t);
    if (!is_wall(pair.second)) {
      const Rational reach = f.radius + flights_[pair.second].radius;
      return sign(product(n, n) + Rational(-reach * reach));
    }
    const Surd height = product(n, place_at(pair.first, t)) + wall(pair.second).offset;
    if (sign(height) < 0) return -1;
    return sign(sum(square(height), product(n, n) * Rational(-f.radius * f.radius)));
  }

  /// True if the pair collides before t, or at t as well if it `counts`: it approaches at its start and meets then, or
  /// later; for two balls the square of their distance, whose first zero that is, has two zeros.
  bool collides_until(const Meeting& pair, const Surd& t, bool counts) const {
    const Rational start = start_of(pair);
    const Surd from = lifted(start);
    const int wait = sign(t + Rational(-start));
    if (wait < 0 || (wait == 0 && !counts) || sign(parting_at(pair, from)) >= 0) return false;
    if (gap_at(pair, from) <= 0) return true;
    const int gap = gap_at(pair, t);
    if (is_wall(pair.second)) return counts ? gap <= 0 : gap < 0;
    const Column n = normal_at(pair, from);
    const Triple v = relative_velocity(pair), apart{n.x.p, n.y.p, n.z.p};
    const Rational reach = flights_[pair.first].radius + flights_[pair.second].radius, slope = dot(apart, v);
    const Rational discriminant = slope * slope - dot(v, v) * (dot(apart, apart) - reach * reach);
    if (sgn(discriminant) <= 0) return false;
    return gap < 0 || (counts && gap == 0) || sign(parting_at(pair, t)) > 0;
  }
  /// True if a pair collides in the rest of the step.
  bool another() const {
    bool found = false;
    visit_pairs([&](const Meeting& pair) {
      found = found || (settled_.count(pair) == 0 && collides_until(pair, lifted(1), true));
    });
    return found;
  }

  std::vector<Met> contacts_of(const Surd& t, const std::string& name) const {
    std::vector<Met> met;
    visit_pairs([&](const Meeting& pair) {
      const bool settled = settled_.count(pair) != 0;
      expect(settled || !collides_until(pair, t, false), name + ".t: a pair collides before");
      if (sign(t + Rational(-start_of(pair))) < 0 || gap_at(pair, t) > 0) return;
      const Column n = normal_at(pair, t);
      const Surd parting = parting_at(pair, t);
      if (sign(product(n, n)) == 0 || sign(parting) > 0) return;
      const std::size_t group = met.size();
      met.push_back({pair, n, parting, sign(parting) < 0 && !settled, group});
      for (std::size_t k = 0; k < group; ++k)
        if (hang_together(met[k].places, pair) && met[k].group != met[group].group) {
          const std::size_t old = met[k].group;
          for (Met& c : met)
            if (c.group == old) c.group = met[group].group;
        }
    });
    std::set<std::size_t> colliding;
    for (const Met& c : met)
      if (c.collides) colliding.insert(c.group);
    std::erase_if(met, [&](const Met& c) { return colliding.count(c.group) == 0; });
    expect(!met.empty(), name + ".t: nothing collides then");
    return met;
  }
  bool hang_together(const Meeting& a, const Meeting& b) const {
    const auto shared = [&](std::size_t place) { return moves(place) && (place == b.first || place == b.second); };
    return shared(a.first) || shared(a.second);
  }
  static bool has_too_many(const Surd& t, const std::vector<Met>& contacts) {
    std::map<std::size_t, std::size_t> counts;
    std::size_t most = 0;
    for (const Met& c : contacts) most = std::max(most, ++counts[c.group]);
    return sgn(t.q) != 0 && !is_square(t.r) && most > most_contacts_at_a_root;
  }
  static void expect_listed(const json& listed, const std::vector<Met>& contacts, const std::string& name) {
    const auto is_place = [](const json& value, std::size_t place) {
      return value.is_number_unsigned() && value.get<std::size_t>() == place;
    };
    bool same = listed.is_array() && listed.size() == contacts.size();
    for (std::size_t k = 0; same && k < contacts.size(); ++k) {
      const json& pair = listed[k];
      same = pair.is_array() && pair.size() == 2 && is_place(pair[0], contacts[k].places.first) &&
             is_place(pair[1], contacts[k].places.second);
    }
    expect(same, name + ".contacts: not those of this moment");
  }

  /// The conditions of Karush, Kuhn and Tucker, as for simulation_step, and the rounding of the numbers.
  void answer(const Claim& proof, const Surd& t, const std::vector<Met>& contacts, const std::string& name) {
    proof.expect_kind("pushes");
    proof.facts({"impulses", "impulses_of_root", "clock", "states"});
    const std::vector<Rational> rational = proof.list("impulses"), of_root = proof.list("impulses_of_root"),
                                states = proof.list("states");
    const Rational clock = proof.single("clock");
    expect(rational.size() == contacts.size() && of_root.size() == contacts.size(),
           "certificate.impulses: one for each contact");
    std::map<std::size_t, Column> after;
    std::vector<Surd> impulses;
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      const Surd impulse = impulses.emplace_back(Surd{rational[k], of_root[k], t.r});
      expect(sign(impulse) >= 0, "certificate.impulses: not negative");
      const auto& [i, j] = contacts[k].places;
      for (const std::size_t body : {i, j}) {
        if (!moves(body)) continue;
        const Rational mass = body == i ? flights_[body].inverse_mass : Rational(-flights_[body].inverse_mass);
        Column& v = after.try_emplace(body, lifted(flights_[body].velocity)).first->second;
        v = sum(v, times(impulse * mass, contacts[k].normal));
      }
    }
    const auto velocity_of = [&](std::size_t body) {
      const auto found = after.find(body);
      return found == after.end() ? lifted(nothing) : found->second;
    };
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      const auto& [places, normal, before, collides, group] = contacts[k];
      const Surd parting = product(normal, difference(velocity_of(places.first), velocity_of(places.second)));
      const int surplus = sign(sum(parting, before * restitution_));
      const std::string contact = numbered(name + ".contacts", k);
      expect(surplus >= 0, contact + ": its demand is broken");
      expect(sign(impulses[k]) == 0 || surplus == 0, contact + ": pushes beyond its demand");
    }
    expect_nearest(clock, t, "certificate.clock");
    expect(states.size() == 6 * after.size(), "certificate.states: six numbers for each body");
    std::erase_if(settled_, [&](const Meeting& p) { return after.count(p.first) != 0 || after.count(p.second) != 0; });
    for (const Met& c : contacts) settled_.insert(c.places);
    std::size_t next = 0;
    for (const auto& [body, v] : after) {
      const Column at = place_at(body, t);
      for (const Surd* exact : {&at.x, &at.y, &at.z, &v.x, &v.y, &v.z}) {
        expect_nearest(states[next], *exact, numbered("certificate.states", next));
        ++next;
      }
      const auto kept = [&](std::size_t k) { return states[next - 6 + k]; };
      flights_[body].at = {kept(0), kept(1), kept(2)}, flights_[body].velocity = {kept(3), kept(4), kept(5)};
      flights_[body].clock = clock;
    }
  }

  void expect_end() const {
    expect(!another(), "truth.moments: a pair collides after the last");
    const json& states = claim_.truth["bodies"];
    expect(states.is_array() && states.size() == flights_.size(), "truth.bodies: one for each body");
    for (std::size_t i = 0; i < flights_.size(); ++i) {
      const Flight& f = flights_[i];
      const std::string name = numbered("truth.bodies", i);
      only(states[i], name, {"position", "velocity"});
      const Triple end = along(f.at, Rational((1 - f.clock) * timestep_), f.velocity);
      expect(exact_triple(states[i]["position"], name + ".position") == end, name + ".position: not where it comes to");
      expect(exact_triple(states[i]["velocity"], name + ".velocity") == f.velocity,
             name + ".velocity: not what impulses make");
    }
  }

  const Claim& claim_;
  std::vector<Flight> flights_;
  std::vector<Plane> walls_;
  Rational restitution_, timestep_;
  std::set<Meeting> settled_;
};

void check_impact_step(const Claim& claim) {
  claim.inputs({"bodies", "walls", "restitution", "timestep"});
  Step(claim).check();
}

}  // namespace

Checks checks_of_impacts() { return {{"impact_step", check_impact_step}}; }

}  // namespace touchstone::certify
