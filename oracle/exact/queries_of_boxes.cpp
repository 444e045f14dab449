// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/queries_of_boxes.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace touchstone::oracle {
namespace {

using Box = Aabb3<Rational>;

Rational square(const Rational& x) { return Rational(x * x); }
void keep_least(std::optional<Rational>& least, const Rational& one) {
  if (!least || one < *least) least = one;
}

constexpr std::array axes{&Point3<Rational>::x, &Point3<Rational>::y, &Point3<Rational>::z};

/// What two boxes have to spare before they part; less than 0: what they lack.
Rational spare(const Box& a, const Box& b) {
  std::optional<Rational> least;
  for (const auto axis : axes)
    keep_least(least, std::min<Rational>(a.max.*axis - b.min.*axis, b.max.*axis - a.min.*axis));
  return *least;
}

Certificate proof(const Box& query, const Box& box) {
  std::vector<Rational> corner;
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational &low = std::max(query.min.*axes[k], box.min.*axes[k]),
                   &high = std::min(query.max.*axes[k], box.max.*axes[k]);
    if (high < low) return {"gap", {{"axis", {Rational(static_cast<long>(k))}}}};
    corner.push_back(low);
  }
  return {"common_point", {{"point", corner}}};
}

/// How far a point of the ray is beyond a face: excess + slope t.
struct Face {
  Rational excess, slope;
};

/// A ray and one box: the faces below and above on each axis, one after another.
class BoxOnRay {
 public:
  BoxOnRay(const Ray3<Rational>& ray, const Box& box) {
    const auto& [o, d] = ray;
    const std::array direction{d.x, d.y, d.z};
    for (std::size_t k = 0; k < 3; ++k) {
      faces_.push_back({Rational(box.min.*axes[k] - o.*axes[k]), Rational(-direction[k])});
      faces_.push_back({Rational(o.*axes[k] - box.max.*axes[k]), direction[k]});
    }
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      const auto& [excess, slope] = faces_[i];
      if (sgn(slope) >= 0) keep_greatest(excess, {{i, 1}});
      else enter(i, Rational(excess / -slope));
      for (std::size_t j = 0; j < faces_.size() && sgn(slope) < 0; ++j) {
        const Face& left = faces_[j];
        if (sgn(left.slope) <= 0) continue;
        const Rational both = left.slope - slope, here = left.slope / both, there = -slope / both;
        keep_greatest(Rational(here * excess + there * left.excess), {{i, here}, {j, there}});
      }
    }
  }

  /// What the ray lacks to meet the box; less than 0: what it has to spare.
  const Rational& lack() const { return *lack_; }
  bool met() const { return sgn(*lack_) <= 0; }
  /// When it passes the last of the faces that it approaches, perhaps before it starts.
  const Rational& entry() const { return *entry_; }
  Rational first() const { return std::max(*entry_, Rational(0)); }

  Certificate proof() const {
    if (!met()) {
      std::array<std::vector<Rational>, 2> weights{std::vector<Rational>(3), std::vector<Rational>(3)};
      for (const auto& [face, weight] : weights_) weights[face % 2][face / 2] = weight;
      return {"apart", {{"below", weights[0]}, {"above", weights[1]}}};
    }
    if (sgn(*entry_) <= 0) return {"start", {}};
    return {"entry", {{"first", {*entry_}}, {"axis", {Rational(static_cast<long>(entered_ / 2))}}}};
  }

 private:
  using Weights = std::vector<std::pair<std::size_t, Rational>>;

  void keep_greatest(const Rational& lack, const Weights& weights) {
    if (lack_ && lack <= *lack_) return;
    lack_ = lack;
    weights_ = weights;
  }
  void enter(std::size_t face, const Rational& t) {
    if (entry_ && t <= *entry_) return;
    entry_ = t;
    entered_ = face;
  }

  std::vector<Face> faces_;
  std::optional<Rational> lack_, entry_;
  Weights weights_;
  std::size_t entered_ = 0;
};

/// How much later the second of two that follow one another would have to be first.
Rational lead(const BoxOnRay& one, const BoxOnRay& next) {
  return sgn(next.entry()) > 0 ? Rational(next.first() - one.first()) : Rational(-one.entry());
}

}  // namespace

Truth<std::vector<Index>> met_by(const Box& query, const std::vector<Box>& boxes) {
  Truth<std::vector<Index>> found;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Rational room = spare(query, boxes[i]);
    if (sgn(room) >= 0) found.answer.push_back(static_cast<Index>(i));
    keep_least(found.margin, square(room));
  }
  found.certificate = [query, boxes] {
    std::vector<Certificate> each;
    for (const Box& box : boxes) each.push_back(proof(query, box));
    return Certificate{"each_body", {}, {{"each", std::move(each)}}};
  };
  return found;
}

Truth<std::vector<Index>> met_by(const Ray3<Rational>& ray, const std::vector<Box>& boxes) {
  Truth<std::vector<Index>> found;
  std::vector<BoxOnRay> each;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    each.emplace_back(ray, boxes[i]);
    if (each[i].met()) found.answer.push_back(static_cast<Index>(i));
    keep_least(found.margin, square(each[i].lack()));
  }
  std::stable_sort(found.answer.begin(), found.answer.end(),
                   [&](Index i, Index j) { return each[i].first() < each[j].first(); });
  const auto& d = ray.direction;
  const Rational unit = std::max({Rational(abs(d.x)), Rational(abs(d.y)), Rational(abs(d.z))});
  for (std::size_t k = 1; k < found.answer.size(); ++k)
    keep_least(found.margin, square(Rational(unit * lead(each[found.answer[k - 1]], each[found.answer[k]]))));
  found.certificate = [each = std::move(each)] {
    std::vector<Certificate> proofs;
    for (const BoxOnRay& one : each) proofs.push_back(one.proof());
    return Certificate{"each_along", {}, {{"each", std::move(proofs)}}};
  };
  return found;
}

bool in_interior(const Point3<Rational>& point, const Box& box) { return sgn(spare({point, point}, box)) > 0; }
bool in_interior(const Ray3<Rational>& ray, const Box& box) { return sgn(BoxOnRay(ray, box).lack()) < 0; }

}  // namespace touchstone::oracle
