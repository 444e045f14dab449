// SPDX-License-Identifier: Apache-2.0
#include "robust/lines/line_line.h"

#include "robust/kernel/enclosed/enclosed_shapes.h"
#include "robust/kernel/shapes/plane.h"
#include "robust/kernel/shapes/valid.h"

namespace touchstone::robust {
namespace {

template <class Integer>
LineRelation relation_of(const Line2<Integer>& a, const Line2<Integer>& b) {
  if (kernel::turn(a.q - a.p, b.q - b.p) != 0) return LineRelation::crossing;
  return kernel::turn(a.p, a.q, b.p) == 0 ? LineRelation::same : LineRelation::parallel;
}

template <class Integer, class Numbers>
Line2<Integer> first_line_in(const Numbers& n) {
  return {{n[0], n[1]}, {n[2], n[3]}};
}
template <class Integer, class Numbers>
Line2<Integer> second_line_in(const Numbers& n) {
  return {{n[4], n[5]}, {n[6], n[7]}};
}

auto on_lattice(const Line2d& a, const Line2d& b) {
  return kernel::lattice_of(a.p.x, a.p.y, a.q.x, a.q.y, b.p.x, b.p.y, b.q.x, b.q.y);
}
auto as_integers(const Line2d& a, const Line2d& b) {
  return kernel::integers_of(a.p.x, a.p.y, a.q.x, a.q.y, b.p.x, b.p.y, b.q.x, b.q.y);
}

void validate_line_line(const Line2d& a, const Line2d& b) {
  if (kernel::valid(a) && kernel::valid(b)) return;
  validation::validate_all("a", a, "b", b);
}

}  // namespace

Perhaps<LineRelation> stages::line_line::decision::lattice(const Line2d& a, const Line2d& b) {
  const auto lattice = on_lattice(a, b);
  if (!lattice) return std::nullopt;
  return relation_of(first_line_in<std::int64_t>(lattice->at), second_line_in<std::int64_t>(lattice->at));
}

LineRelation stages::line_line::decision::exact(const Line2d& a, const Line2d& b) {
  const auto n = as_integers(a, b).at;
  return relation_of(first_line_in<mpz_class>(n), second_line_in<mpz_class>(n));
}

Decided<LineRelation> stages::line_line::decision::past_filter(const Line2d& a, const Line2d& b) {
  return in_turn<decision, validate_line_line, Stage::lattice, Stage::exact>(a, b);
}

namespace {

using kernel::Two;

LineLine<double> answer_of(const kernel::Crossing& crossing) {
  return {LineRelation::crossing, crossing.ta, crossing.tb, crossing.point};
}

/// The stage `enclosed`, if there is an answer made of its crossing. Inlined into both callers: constructing an answer
/// of several numbers out of place and copying it costs a tenth of the total (Perhaps explains it).
[[gnu::always_inline]] inline std::optional<kernel::Crossing> enclosed_crossing(const Line2d& a, const Line2d& b) {
  if (!kernel::in_window(Two(a.p), Two(a.q), Two(b.p), Two(b.q))) return std::nullopt;
  if (!kernel::rounds_to_nearest()) return std::nullopt;
  return kernel::crossing_of({a.p, a.q}, {b.p, b.q});
}

/// a.p + ta r = b.p + tb s: crossing both sides with s, and with r, leaves one unknown each.
template <class Integer>
LineLine<double> answer_of(const Line2<Integer>& a, const Line2<Integer>& b, int exponent) {
  const LineRelation relation = relation_of(a, b);
  if (relation != LineRelation::crossing) return {relation, {}, {}, {}};
  const Vector2<Integer> r = a.q - a.p, s = b.q - b.p, between = b.p - a.p;
  const kernel::Second<Integer> d = kernel::determinant(r, s), na = kernel::determinant(between, s),
                                nb = kernel::determinant(between, r);
  return {relation, kernel::round_quotient(na, d), kernel::round_quotient(nb, d),
          kernel::point_along(a.p, r, na, d, exponent)};
}

}  // namespace

Perhaps<LineLine<double>> stages::line_line::enclosed(const Line2d& a, const Line2d& b) {
  if (const auto crossing = enclosed_crossing(a, b)) return answer_of(*crossing);
  return std::nullopt;
}

Perhaps<LineLine<double>> stages::line_line::lattice(const Line2d& a, const Line2d& b) {
  const auto lattice = on_lattice(a, b);
  if (!lattice) return std::nullopt;
  return answer_of(first_line_in<std::int64_t>(lattice->at), second_line_in<std::int64_t>(lattice->at),
                   lattice->exponent);
}

LineLine<double> stages::line_line::exact(const Line2d& a, const Line2d& b) {
  const auto n = as_integers(a, b);
  return answer_of(first_line_in<mpz_class>(n.at), second_line_in<mpz_class>(n.at), n.exponent);
}

LineLine<double> line_line(const Line2d& a, const Line2d& b) {
  if (const auto crossing = enclosed_crossing(a, b)) return answer_of(*crossing);
  return answer_in_turn<stages::line_line, validate_line_line, Stage::lattice, Stage::exact>(a, b);
}

}  // namespace touchstone::robust
