// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/response/rigid_body_collision.h"

#include "proptests/contact_laws.h"
#include "robust/response/restitution_collision.h"

namespace touchstone::proptests::rigid_body_collision_tests {
namespace {

using Row = rows::rigid_body_collision;
using ExactBody = RigidBody<Rational>;
using ExactMotions = Motions<Rational>;

constexpr Inertiad unit_inertia{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
constexpr RigidBodyd still{1, unit_inertia, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}};

Motion3 angular_momentum(const Inertia<Rational>& i, const Motion3& w) {
  return {dot(i.x, w), dot(i.y, w), dot(i.z, w)};
}
/// Around the origin.
Motion3 all_momentum(const ExactBody& body) {
  return angular_momentum(body.inertia, body.angular_velocity) +
         body.mass * cross(from_origin(body.position), body.velocity);
}
Rational doubled_energy(const ExactBody& body) {
  return Rational(body.mass * dot(body.velocity, body.velocity) +
                  dot(body.angular_velocity, angular_momentum(body.inertia, body.angular_velocity)));
}
ExactBody after(ExactBody body, const Motion<Rational>& motion) {
  body.velocity = motion.velocity, body.angular_velocity = motion.angular_velocity;
  return body;
}
Motion3 velocity_at(const ExactBody& body, const Point3<Rational>& p) {
  return body.velocity + cross(body.angular_velocity, p - body.position);
}
bool alike(const Motion<Rational>& m, const Motion<Rational>& n) {
  return same(m.velocity, n.velocity) && same(m.angular_velocity, n.angular_velocity);
}
template <class R>
Motions<R> exchanged(const Motions<R>& m) {
  return {m.b, m.a};
}

/// The rows of a matrix change places as its columns do.
template <class Body>
Body mapped(const AxisMap& map, Body body) {
  auto& [x, y, z] = body.inertia;
  for (auto* part : {&x, &y, &z, &body.velocity, &body.angular_velocity}) map.place(*part);
  map.place(body.position);
  const auto old = body.inertia;
  const auto row = [&](int i) {
    const auto& from = map.from[i] == 0 ? old.x : map.from[i] == 1 ? old.y : old.z;
    return map.sign[i] < 0 ? -1.0 * from : from;
  };
  x = row(0), y = row(1), z = row(2);
  return turns_over(map) ? with_turn(body, -1.0) : body;
}

/// A mass and its inertia times 2^k, where that is exact.
std::optional<RigidBodyd> heavier(RigidBodyd body, int k) {
  const auto mass = longer({body.mass, 0, 0}, k), x = longer(body.inertia.x, k), y = longer(body.inertia.y, k),
             z = longer(body.inertia.z, k);
  if (!mass || !x || !y || !z) return std::nullopt;
  body.mass = mass->x, body.inertia = {*x, *y, *z};
  return body;
}

}  // namespace

EXACT_LAW("rigid_body_collision: momentum and angular momentum are kept, the relative velocity becomes -e times that",
          a, b, p, n, e) {
  const ExactMotions motions = ask(asked);
  const ExactBody c = after(a, motions.a), d = after(b, motions.b);
  const Rational before = dot(velocity_at(a, p) - velocity_at(b, p), n);
  return same(c.mass * c.velocity + d.mass * d.velocity, a.mass * a.velocity + b.mass * b.velocity) &&
         same(all_momentum(c) + all_momentum(d), all_momentum(a) + all_momentum(b)) &&
         same(cross(c.velocity - a.velocity, n), none()) &&
         dot(velocity_at(c, p) - velocity_at(d, p), n) == -e * before;
}

EXACT_LAW("rigid_body_collision: energy is kept with e = 1 and never gained; the rest is lost with 1 - e^2", a, b, p, n,
          e) {
  const auto lost = [&](const Rational& restitution) {
    const ExactMotions motions = ask(std::tuple(a, b, p, n, restitution));
    return Rational(doubled_energy(a) + doubled_energy(b) - doubled_energy(after(a, motions.a)) -
                    doubled_energy(after(b, motions.b)));
  };
  const Rational most = lost(Rational(0)), half = lost(Rational(1, 2));
  return most >= 0 && lost(Rational(1)) == 0 && Rational(4 * half) == Rational(3 * most) &&
         lost(e) == Rational((1 - e * e) * most);
}

TEST_CASE(
    "rigid_body_collision: exchanged bodies, other units of mass, other observers, the normal's length and side") {
  law<Row>("exchanged", [](const auto& ask, const auto& asked) {
    const auto& [a, b, p, n, e] = asked;
    return equal(ask(Row::Question{b, a, p, n, e}), exchanged(ask(asked)));
  });
  law<Row>("units of mass", [](const auto& ask, const auto& asked) {
    const auto& [a, b, p, n, e] = asked;
    const auto answer = ask(asked);
    for (const int k : {1, -60, 300, -300}) {
      const auto c = heavier(a, k), d = heavier(b, k);
      if (c && d && !equal(ask(Row::Question{*c, *d, p, n, e}), answer)) return false;
    }
    return true;
  });
  law<Row>("the same normal", any_normal_of_the_plane<3>);
  exact_law<Row>("galilean_invariance", [](const auto& ask, const auto& asked) {
    const auto& [a, b, p, n, e] = asked;
    const Motion3 shift{Rational(7, 3), Rational(-11), Rational(13, 5)};
    const ExactMotions motions = ask(asked), seen = ask(std::tuple(with_velocity(a, a.velocity + shift),
                                                                   with_velocity(b, b.velocity + shift), p, n, e));
    return alike(seen.a, {motions.a.velocity + shift, motions.a.angular_velocity}) &&
           alike(seen.b, {motions.b.velocity + shift, motions.b.angular_velocity});
  });
}

LAW("rigid_body_collision: axes exchanged and turned; where space is turned over, turns change their sense", a, b, p, n,
    e) {
  const auto answer = ask(asked);
  for (const AxisMap& map : axis_maps) {
    auto expected = map(answer);
    using R = std::remove_cvref_t<decltype(answer.a.velocity.x)>;
    if (turns_over(map)) expected.a = with_turn(expected.a, R(-1)), expected.b = with_turn(expected.b, R(-1));
    const auto [q, m] = map(std::tuple(p, n));
    if (!equal(ask(Row::Question{mapped(map, a), mapped(map, b), q, m, e}), expected)) return false;
  }
  return true;
}

ROBUST_LAW("rigid_body_collision: pushed at both positions it is restitution_collision") {
  auto [a, b, p, n, e] = asked;
  a.position = b.position = p;
  const auto motions = ask(Row::Question{a, b, p, n, e});
  const Velocitiesd pushed = robust::restitution_collision({a.mass, b.mass}, {a.velocity, b.velocity}, n, e);
  return equal(Velocitiesd{motions.a.velocity, motions.b.velocity}, pushed) &&
         equal(motions.a.angular_velocity, a.angular_velocity) && equal(motions.b.angular_velocity, b.angular_velocity);
}

TEST_CASE("rigid_body_collision: p. 74's impulse worked by hand") {
  // n . (va - vb) = -2, 1/ma + 1/mb = 2, j = 2
  RigidBodyd a = still, b = still;
  a.velocity = {0, -2, 0};
  example<Row>({a, b, {0, 0, 0}, {0, 1, 0}, 1}, {{{0, 0, 0}, {0, 0, 0}}, {{0, -2, 0}, {0, 0, 0}}});
  // ra x n = (2, 0, 0) x (0, 1, 0) = (0, 0, 2): 2 + 4 = 6 times j is (1 + e) 2.
  a.position = {-2, 0, 0};
  example<Row>({a, b, {0, 0, 0}, {0, 1, 0}, 0.5},
               {{{0, Rational(-3, 2), 0}, {0, 0, 1}}, {{0, Rational(-1, 2), 0}, {0, 0, 0}}});
  example<Row>({b, a, {0, 0, 0}, {0, 7, 0}, 0.5},
               {{{0, Rational(-1, 2), 0}, {0, 0, 0}}, {{0, Rational(-3, 2), 0}, {0, 0, 1}}});
  a.inertia = {{2, 1, 0}, {1, 2, 0}, {0, 0, 4}};
  // ra x n = (0, 0, 2), turned by 4: (0, 0, 1/2); 2 + 1 = 3 times j is 2: j = 2/3.
  example<Row>({a, b, {0, 0, 0}, {0, 1, 0}, 0},
               {{{0, Rational(-4, 3), 0}, {0, 0, Rational(1, 3)}}, {{0, Rational(-2, 3), 0}, {0, 0, 0}}});
  // n = (0, 0, 1): ra x n = (0, -2, 0), and I (2/3, -4/3, 0) = (0, -2, 0). vb = (0, 0, 1), so n . (va - vb) = -1, 2 +
  // 8/3 = 14/3 times j is 1: j = 3/14.
  b.velocity = {0, 0, 1};
  example<Row>({a, b, {0, 0, 0}, {0, 0, 1}, 0}, {{{0, -2, Rational(3, 14)}, {Rational(1, 7), Rational(-2, 7), 0}},
                                                 {{0, 0, Rational(11, 14)}, {0, 0, 0}}});
}

TEST_CASE("rigid_body_collision: huge, subnormal and negative zero") {
  RigidBodyd a = still, b = still;
  a.velocity = {0, -greatest, 0}, b.velocity = {0, greatest, 0};
  CHECK(robust::rigid_body_collision(a, b, {0, 0, 0}, {0, tiny, 0}, 1).a.velocity.y == greatest);
  a = {tiny, {{tiny, 0, 0}, {0, tiny, 0}, {0, 0, tiny}}, {-1, 0, 0}, {0, -3, -0.0}, {-0.0, 0, 0}};
  b = {tiny, unit_inertia, {0, 0, 0}, {-0.0, 0, 0}, {0, 0, -0.0}};
  // 1/m + 1/m + 1/m times j is 3
  const auto answer = robust::rigid_body_collision(a, b, {0, 0, 0}, {0, 1, 0}, 0);
  CHECK((answer.a.velocity.y == -2 && answer.b.velocity.y == -1 && answer.a.angular_velocity.z == 1));
  CHECK((plus_zero(answer.a.velocity.z) && plus_zero(answer.a.angular_velocity.x) && plus_zero(answer.b.velocity.x) &&
         plus_zero(answer.b.angular_velocity.z)));
}

TEST_CASE("rigid_body_collision: an inertia that is none is refused by its field") {
  const Point3d o{0, 0, 0};
  const Vector3d n{0, 1, 0};
  const auto with_inertia = [](const Inertiad& i) {
    RigidBodyd body = still;
    body.inertia = i;
    return body;
  };
  const std::string definite = "positive definite";
  refused<Row>({with_inertia({{1, tiny, 0}, {0, 1, 0}, {0, 0, 1}}), still, o, n, 1}, "a.inertia[1][0]", "symmetric");
  refused<Row>({still, with_inertia({{1, 0, 2}, {0, 1, 0}, {1, 0, 1}}), o, n, 1}, "b.inertia[2][0]", "symmetric");
  refused<Row>({still, with_inertia({{1, 0, 0}, {0, 1, 2}, {0, -2, 1}}), o, n, 1}, "b.inertia[2][1]", "symmetric");
  refused<Row>({with_inertia({{0, 0, 0}, {0, 1, 0}, {0, 0, 1}}), still, o, n, 1}, "a.inertia", definite);
  refused<Row>({with_inertia({{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}), still, o, n, 1}, "a.inertia", definite);
  refused<Row>({with_inertia({{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}}), still, o, n, 1}, "a.inertia", definite);
  refused<Row>({still, with_inertia({{1, 1, 1}, {1, 2, 3}, {1, 3, 5}}), o, n, 1}, "b.inertia", definite);
  refused<Row>({still, with_inertia({{1, 0, 0}, {0, 1, 0}, {0, 0, -tiny}}), o, n, 1}, "b.inertia", definite);
}

CONTRACT("rigid_body_collision: the formula in double keeps its contract", a, b, p, normal, e) {
  bool moderate = true;
  const auto asked = std::tuple(a, b, p, normal, e);
  catalogue::for_each_number(asked, [&](const double& x) {
    moderate = moderate && (x == 0 || (std::fabs(x) >= 0x1p-30 && std::fabs(x) <= 0x1p30));
  });
  if (!moderate) return true;
  const Motion3 n = exactly(normal);
  Rational k = 1, exact_below, below, apart;
  std::array<Motion3, 2> turns;
  for (const RigidBodyd* body : {&a, &b}) {
    const Motion3 x = exactly(body->inertia.x), y = exactly(body->inertia.y), z = exactly(body->inertia.z),
                  moment = cross(arm_of(*body, p), n), sizes = cross_of_sizes(size_of(arm_of(*body, p)), size_of(n)),
                  yz = cross_of_sizes(size_of(y), size_of(z)), zx = cross_of_sizes(size_of(z), size_of(x)),
                  xy = cross_of_sizes(size_of(x), size_of(y));
    const Rational determinant = dot(x, cross(y, z)), mass = exact(body->mass);
    k = std::max(k, Rational(dot(size_of(x), yz) / determinant));
    Motion3& turn = turns[body == &a ? 0 : 1];
    turn = Rational(1 / determinant) * (sizes.x * yz + sizes.y * zx + sizes.z * xy);
    const Motion3 exact_turn =
        Rational(1 / determinant) * (moment.x * cross(y, z) + moment.y * cross(z, x) + moment.z * cross(x, y));
    exact_below += dot(n, n) / mass + dot(moment, exact_turn), below += dot(n, n) / mass + dot(sizes, turn);
    apart += dot(size_of(n), size_at(*body, p));
  }
  const Rational kl = 100 * k * below / exact_below, j = kl * (1 + exact(e)) * apart / exact_below;
  if (kl * unit() > 1) return true;
  const auto near = [&](const Vector3d& found, const Motion3& expected, const Motion3& changed, const Vector3d& was) {
    const auto kept = [&](double f, const Rational& x, const Rational& along, double from) {
      return within(f, x, (abs(along) * j + 2 * size(from)) * unit() + power_of_two(-1060));
    };
    return kept(found.x, expected.x, changed.x, was.x) && kept(found.y, expected.y, changed.y, was.y) &&
           kept(found.z, expected.z, changed.z, was.z);
  };
  const auto body_near = [&](const Motion<double>& found, const Motion<Rational>& expected, const RigidBodyd& body,
                             const Motion3& turn) {
    return near(found.velocity, expected.velocity, Rational(1 / exact(body.mass)) * n, body.velocity) &&
           near(found.angular_velocity, expected.angular_velocity, turn, body.angular_velocity);
  };
  return body_near(answer.a, truth.answer.a, a, turns[0]) && body_near(answer.b, truth.answer.b, b, turns[1]);
}

TEST_CASE("rigid_body_collision: the formula is right in exact arithmetic") { right_in_exact_arithmetic<Row>(); }

}  // namespace touchstone::proptests::rigid_body_collision_tests
