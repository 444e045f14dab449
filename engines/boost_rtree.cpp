// SPDX-License-Identifier: Apache-2.0
#define BOOST_ALLOW_DEPRECATED_HEADERS  // some of its own includes are
#include <touchstone/program/engine_main.h>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/version.hpp>
#include <iterator>
#include <stdexcept>

#include "programs.h"

namespace bg = boost::geometry;

namespace touchstone {
namespace {

/// The R-tree of Boost.Geometry with the R*-tree's rules and nodes of at most four, so that small programs have a tree.
class BoostTree {
 public:
  using Point = bg::model::point<double, 3, bg::cs::cartesian>;
  using Box = bg::model::box<Point>;
  using Value = std::pair<Box, Index>;

  Index insert(const Aabb3d& box) {
    values_.emplace_back(boost_box(box), static_cast<Index>(values_.size()));
    tree_.insert(values_.back());
    return values_.back().second;
  }
  void move(Index body, const Aabb3d& box) {
    remove(body);
    values_[body].first = boost_box(box);
    tree_.insert(values_[body]);
  }
  /// Documented: the number of values removed.
  void remove(Index body) {
    if (tree_.remove(values_[body]) != 1) throw std::runtime_error("remove() removes nothing");
  }

  std::vector<IndexPair> pairs() const {
    std::vector<IndexPair> found;
    for (const Value& value : tree_) {
      for (const Index other : met(value.first))
        if (value.second < other) found.push_back({value.second, other});
    }
    return found;
  }
  std::vector<Index> in_box(const Aabb3d& box) const { return met(boost_box(box)); }
  std::vector<Index> at_point(const Point3d& point) const { return met(boost_point(point)); }
  /// It has no rays.
  std::vector<Index> along_ray(const Ray3d&) const { return {}; }

 private:
  static Point boost_point(const Point3d& p) { return {p.x, p.y, p.z}; }
  static Box boost_box(const Aabb3d& box) { return {boost_point(box.min), boost_point(box.max)}; }
  template <class Shape>
  std::vector<Index> met(const Shape& shape) const {
    std::vector<Value> values;
    tree_.query(bg::index::intersects(shape), std::back_inserter(values));
    std::vector<Index> bodies;
    for (const Value& value : values) bodies.push_back(value.second);
    return bodies;
  }

  std::vector<Value> values_;
  bg::index::rtree<Value, bg::index::rstar<4>> tree_;
};

/// Geometries of Boost are closed, `intersects` counts touches. No tolerance is documented.
struct BoostRtree {
  static constexpr const char* name = "Boost.Geometry R-tree " BOOST_LIB_VERSION;
  static constexpr auto boundary = Boundary::closed;
  static constexpr auto pairs = Pairs::exact;

  std::optional<Replies> broad_phase(const std::vector<Aabb3d>& boxes, const std::vector<Commandd>& commands) {
    if (programs::has<AlongRayd>(commands)) return std::nullopt;
    return replies(BoostTree(), boxes, commands);
  }
};

}  // namespace
}  // namespace touchstone

TOUCHSTONE_ENGINE_MAIN(touchstone::BoostRtree)
