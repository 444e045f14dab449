// SPDX-License-Identifier: Apache-2.0
#include "oracle/volumes/kdop_of_points.h"

#include <gmp.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "geometry/validation.h"
#include "oracle/exact/numbers/decode.h"

namespace touchstone::oracle {
namespace {

/// N . P of a point, and the sum of the magnitudes of its products.
struct Height {
  Rational value, size;
};

/// The heights of all points over one normal, and their indices from the least value to the greatest.
struct Heights {
  std::vector<Height> of;
  std::vector<std::size_t> order;
  const Rational& least() const { return of[order.front()].value; }
  const Rational& greatest() const { return of[order.back()].value; }
};

/// For every normal; refuses invalid input.
template <class Number>
std::vector<Heights> heights(const std::vector<Point3<Number>>& points, const std::vector<Vector3<Number>>& normals) {
  validation::validate_all("points", validation::under(rule::points, points), "normals",
                           validation::under(rule::normals, normals));
  std::vector<Heights> all;
  for (const auto& n : normals) {
    validation::validate("normals[" + std::to_string(all.size()) + "]", n, rule::normal);
    Heights found;
    for (const auto& p : points) {
      const Rational x(exact(n.x) * exact(p.x)), y(exact(n.y) * exact(p.y)), z(exact(n.z) * exact(p.z));
      found.of.push_back({Rational(x + y + z), Rational(abs(x) + abs(y) + abs(z))});
    }
    found.order.resize(points.size());
    std::iota(found.order.begin(), found.order.end(), std::size_t{0});
    std::stable_sort(found.order.begin(), found.order.end(),
                     [&](std::size_t i, std::size_t j) { return found.of[i].value < found.of[j].value; });
    all.push_back(std::move(found));
  }
  return all;
}

constexpr double infinity = std::numeric_limits<double>::infinity();

/// "2.776e-17", even if a double would be 0.
std::string decimal(const Rational& value) {
  std::array<char, 64> text{};
  const mpf_class rounded(value, 128);
  gmp_snprintf(text.data(), text.size(), "%.4Fg", rounded.get_mpf_t());
  return text.data();
}

/// The allowed distance of an end outwards from the exact one, the contract's t, and S + t.
struct Allowance {
  Rational t, reach;
  explicit Allowance(const Heights& heights) {
    const auto wider = [](const Height& a, const Height& b) { return a.size < b.size; };
    const Rational& size = std::max_element(heights.of.begin(), heights.of.end(), wider)->size;
    t = scaled(Rational(9 * size), -53) + scaled(Rational(1), -1070);
    reach = size + t;
  }
};

/// The defect of an upper end; a lower one is that of the opposite normal. `greatest` is the exact one.
std::string defect_of_end(double end, const Rational& greatest, const Allowance& allowed) {
  const Rational largest = exact(std::numeric_limits<double>::max());
  if (end == infinity) return greatest > largest || allowed.reach > largest ? "" : "infinite, which is too far out";
  if (end == -infinity || exact(end) < greatest) return "lost";
  if (exact(end) <= greatest + allowed.t) return "";
  const double within = std::nextafter(end, -infinity);
  if (within == -infinity || exact(within) < greatest) return "";  // no better double
  return "too far out: " + decimal(Rational(exact(end) - greatest)) + ", allowed are " + decimal(allowed.t);
}

std::string defect_of_slab(const Slabd& slab, const Heights& heights) {
  if (std::isnan(slab.min) || std::isnan(slab.max)) return "not a number";
  const Allowance allowed(heights);
  const std::string low = defect_of_end(-slab.min, Rational(-heights.least()), allowed),
                    high = defect_of_end(slab.max, heights.greatest(), allowed);
  const auto lost = [](std::size_t point, const std::string& where, const std::string& by) {
    return "points[" + std::to_string(point) + "] is lost " + where + ", by " + by;
  };
  if (low == "lost")
    return lost(heights.order.front(), "below min",
                std::isinf(slab.min) ? "inf" : decimal(Rational(exact(slab.min) - heights.least())));
  if (high == "lost")
    return lost(heights.order.back(), "above max",
                std::isinf(slab.max) ? "inf" : decimal(Rational(heights.greatest() - exact(slab.max))));
  return !low.empty() ? "min is " + low : !high.empty() ? "max is " + high : "";
}

}  // namespace

template <Exact Number>
Truth<std::vector<Slab<Rational>>> kdop_of_points(const std::vector<Point3<Number>>& points,
                                                  const std::vector<Vector3<Number>>& normals) {
  std::vector<Slab<Rational>> slabs;
  std::vector<std::size_t> least, greatest;
  for (const Heights& one : heights(points, normals)) {
    slabs.push_back({one.least(), one.greatest()});
    least.push_back(one.order.front()), greatest.push_back(one.order.back());
  }
  return {std::move(slabs), std::nullopt, [least = std::move(least), greatest = std::move(greatest)] {
            return Certificate{
                "extreme_points",
                {{"least", {least.begin(), least.end()}}, {"greatest", {greatest.begin(), greatest.end()}}}};
          }};
}
template Truth<std::vector<Slab<Rational>>> kdop_of_points(const std::vector<Point3d>&, const std::vector<Vector3d>&);
template Truth<std::vector<Slab<Rational>>> kdop_of_points(const std::vector<Point3<Rational>>&,
                                                           const std::vector<Vector3<Rational>>&);

std::string kdop_of_points_defect(const std::vector<Point3d>& points, const std::vector<Vector3d>& normals,
                                  const std::vector<Slabd>& slabs) {
  const std::vector<Heights> all = heights(points, normals);
  if (slabs.size() != all.size()) return "not as many slabs as normals";
  std::string too_far;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string defect = defect_of_slab(slabs[i], all[i]);
    if (defect.empty()) continue;
    const std::string complaint = "slabs[" + std::to_string(i) + "]: " + defect;
    if (defect.starts_with("points")) return complaint;
    if (too_far.empty()) too_far = complaint;
  }
  return too_far;
}

}  // namespace touchstone::oracle
