// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/contacts/contact_system.h"

#include <algorithm>
#include <numeric>

#include "robust/kernel/integers/integers.h"

namespace touchstone::robust::kernel {
namespace {

/// The least exponent among nonzero numbers, and integers over it.
class Unit {
 public:
  void add(double number) {
    const Decoded part = decode(number);
    if (part.magnitude != 0) least_ = std::min(least_, part.exponent + std::countr_zero(part.magnitude));
  }
  void add(const Vector3d& v) { add(v.x), add(v.y), add(v.z); }
  int exponent() const { return least_ == INT_MAX ? 0 : least_; }
  mpz_class integer(double number) const {
    Decoded part = decode(number);
    if (part.magnitude == 0) return 0;
    const int zeros = std::countr_zero(part.magnitude);
    part.magnitude >>= zeros;
    return scaled(part, part.exponent + zeros - least_);
  }
  Vector3<mpz_class> integer(const Vector3d& v) const { return {integer(v.x), integer(v.y), integer(v.z)}; }

 private:
  int least_ = INT_MAX;
};

/// Returns 1, -1 or 0: the sign of the contact's impulse at that body.
int push_at(const IntegerContact& contact, Index body) { return (contact.a == body) - (contact.b == body); }

/// Sums of impulses along normals at each body, times a common denominator.
using Pushes = std::map<Index, Vector3<mpz_class>>;

/// The part as a quadratic program over indices into `part`.
class ActiveSet {
 public:
  ActiveSet(const ContactSystem& system, const Contacts& part) : system_(system), part_(part) {
    for (const std::size_t i : part_)
      for (const Index body : {at(i).a, at(i).b}) touching_[body].push_back(i);
  }

  Impulses found(const Contacts& guess) {
    active_ = guess;
    Solution solution = pushing();
    while (const auto broken = broken_by(solution)) {
      if (!enforced(*broken)) return {false, {}, {}, 1};
      solution = solved({wanted()});
    }
    return {true, active_, std::move(solution.numerators[0]), std::move(solution.denominator)};
  }

 private:
  const IntegerContact& at(std::size_t i) const { return system_.contacts[i]; }
  /// The separation at one contact due to the impulse of another.
  mpz_class effect(const IntegerContact& c, const IntegerContact& d) const {
    const mpz_class mass =
        push_at(d, c.a) * system_.inverse_masses[c.a] - push_at(d, c.b) * system_.inverse_masses[c.b];
    return sgn(mass) == 0 ? mpz_class(0) : mpz_class(mass * dot(c.normal, d.normal));
  }
  std::vector<mpz_class> wanted() const {
    std::vector<mpz_class> side;
    for (const std::size_t i : active_) side.push_back(at(i).wanted);
    return side;
  }
  std::vector<mpz_class> effects_of(std::size_t pushed) const {
    std::vector<mpz_class> side;
    for (const std::size_t i : active_) side.push_back(effect(at(i), at(pushed)));
    return side;
  }
  /// The matrix of the active contacts.
  SparseMatrix matrix() const {
    std::map<std::size_t, std::size_t> places;
    for (std::size_t k = 0; k < active_.size(); ++k) places[active_[k]] = k;
    SparseMatrix rows(active_.size());
    for (std::size_t k = 0; k < active_.size(); ++k)
      for (const Index body : {at(active_[k]).a, at(active_[k]).b}) {
        if (sgn(system_.inverse_masses[body]) == 0) continue;
        for (const std::size_t i : touching_.at(body)) {
          const auto place = places.find(i);
          if (place == places.end() || rows[k].count(place->second) != 0) continue;
          rows[k][place->second] = effect(at(active_[k]), at(i));
        }
      }
    return rows;
  }
  /// Solves the equations of contacts that are linearly independent.
  Solution solved(const std::vector<std::vector<mpz_class>>& right_sides) const {
    std::size_t dependent = 0;
    return *solve(matrix(), right_sides, dependent);
  }

  /// Removes contacts until they are independent and none would have to pull.
  Solution pushing() {
    for (;;) {
      std::size_t dependent = 0;
      auto solution = solve(matrix(), {wanted()}, dependent);
      if (!solution) {
        active_.erase(active_.begin() + static_cast<std::ptrdiff_t>(dependent));
        continue;
      }
      Contacts kept;
      for (std::size_t k = 0; k < active_.size(); ++k)
        if (sgn(solution->numerators[0][k]) >= 0) kept.push_back(active_[k]);
      if (kept.size() == active_.size()) return std::move(*solution);
      active_ = std::move(kept);
    }
  }

  /// Returns a contact whose demand these impulses break.
  std::optional<std::size_t> broken_by(const Solution& solution) const {
    Pushes pushes;
    for (std::size_t k = 0; k < active_.size(); ++k) {
      const IntegerContact& c = at(active_[k]);
      const Vector3<mpz_class> push = solution.numerators[0][k] * c.normal;
      pushes[c.a] = pushes[c.a] + system_.inverse_masses[c.a] * push;
      pushes[c.b] = pushes[c.b] - system_.inverse_masses[c.b] * push;
    }
    for (const std::size_t i : part_) {
      const IntegerContact& c = at(i);
      if (dot(c.normal, pushes[c.a] - pushes[c.b]) < c.wanted * solution.denominator) return i;
    }
    return std::nullopt;
  }

  /// Lets contact p push as well, until its demand is met; contacts that would have to pull from some impulse on are
  /// left out. Returns false if the demand cannot be met.
  ///
  /// With an impulse t at p the active ones are x - t d, where A x = r and A d = the effects of p. The surplus of p is
  /// that for x plus t times the part of its own effect that d leaves, 0 if p depends on them.
  bool enforced(std::size_t p) {
    for (;;) {
      const std::vector<mpz_class> effects = effects_of(p);
      const Solution solution = solved({wanted(), effects});
      const std::vector<mpz_class>&x = solution.numerators[0], &d = solution.numerators[1];
      mpz_class lacking = at(p).wanted * solution.denominator, own = effect(at(p), at(p)) * solution.denominator;
      std::optional<std::size_t> first;  // first to lose its push: x / d is least
      for (std::size_t k = 0; k < active_.size(); ++k) {
        lacking -= effects[k] * x[k], own -= effects[k] * d[k];
        if (sgn(d[k]) > 0 && (!first || x[k] * d[*first] < x[*first] * d[k])) first = k;
      }
      if (!first && sgn(own) == 0) return false;
      if (!first || (sgn(own) != 0 && lacking * d[*first] <= x[*first] * own)) {
        active_.push_back(p);
        return true;
      }
      active_.erase(active_.begin() + static_cast<std::ptrdiff_t>(*first));
    }
  }

  const ContactSystem& system_;
  const Contacts& part_;
  std::map<Index, Contacts> touching_;
  Contacts active_;
};

}  // namespace

ContactSystem contact_system(const std::vector<PointBodyd>& bodies, const std::vector<BodyContactd>& contacts,
                             double e) {
  ContactSystem result;
  Unit inverse_mass, speed;
  for (const auto& [w, v] : bodies) inverse_mass.add(w), speed.add(v);
  for (const auto& [w, v] : bodies) {
    result.inverse_masses.push_back(inverse_mass.integer(w));
    result.velocities.push_back(speed.integer(v));
  }
  result.velocity_exponent = speed.exponent();
  const auto [one, restitution] = integers_of(1.0, e).at;
  result.one = one;
  for (const auto& [a, b, n] : contacts) {
    Unit length;
    length.add(n);
    Vector3<mpz_class> normal = length.integer(n);
    const mpz_class parting = dot(normal, result.velocities[a] - result.velocities[b]);
    const mpz_class lacking = sgn(parting) < 0 ? mpz_class(one + restitution) : one;
    result.contacts.push_back({a, b, std::move(normal), -parting * lacking});
  }
  return result;
}

std::vector<Contacts> connected_parts(const ContactSystem& system) {
  const std::size_t bodies = system.inverse_masses.size();
  std::vector<std::size_t> root(bodies);
  std::iota(root.begin(), root.end(), 0);
  const auto root_of = [&root](std::size_t i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  const auto moves = [&system](Index body) { return sgn(system.inverse_masses[body]) != 0; };
  for (const IntegerContact& c : system.contacts)
    if (moves(c.a) && moves(c.b)) root[root_of(c.a)] = root_of(c.b);
  std::map<std::size_t, Contacts> parts;  // contacts of immovable bodies are parts of their own, after all bodies
  for (std::size_t i = 0; i < system.contacts.size(); ++i) {
    const IntegerContact& c = system.contacts[i];
    parts[moves(c.a) ? root_of(c.a) : moves(c.b) ? root_of(c.b) : bodies + i].push_back(i);
  }
  std::vector<Contacts> result;
  for (auto& [place, part] : parts) result.push_back(std::move(part));
  return result;
}

Impulses impulses_of(const ContactSystem& system, const Contacts& part, const Contacts& guess) {
  return ActiveSet(system, part).found(guess);
}

}  // namespace touchstone::robust::kernel
