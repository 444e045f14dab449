// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/solids/space_partition.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <set>
#include <utility>

#include "oracle/exact/shapes/whole_cloud.h"
#include "oracle/exact/solids/plane_between.h"
#include "oracle/exact/systems/linear_program.h"

namespace touchstone::oracle {
namespace {

using Point = Point3<Rational>;
using Cells = SpacePartition::Cells;
using Place = std::uint32_t;  ///< index of a corner
using Polygon = std::vector<Place>;

Rational height(const WitnessPlane& plane, const Point& p) {
  const auto& n = plane.normal;
  return Rational(n.x * p.x + n.y * p.y + n.z * p.z - plane.offset);
}

/// p / w, w > 0.
struct Corner {
  Point3<Integer> p;
  Integer w;
};

/// Heights of corners over one plane, times the denominator of its offset; each is computed once.
class Heights {
 public:
  explicit Heights(const std::vector<Corner>& corners) : corners_(corners) {}

  void over(const WitnessPlane& plane) {
    const Integer& d = plane.offset.get_den();
    normal_ = d * plane.normal, offset_ = plane.offset.get_num(), ++plane_;
    known_.resize(corners_.size()), signs_.resize(corners_.size());
  }
  int side(Place at) {
    if (known_[at] != plane_) known_[at] = plane_, signs_[at] = sgn(height(at));
    return signs_[at];
  }
  /// The point where the plane crosses the segment between two on different sides.
  Corner crossing(Place from, Place to) const {
    const Integer before = height(from), after = height(to);
    const auto between = [&](const Integer& p, const Integer& q) { return Integer(after * p - before * q); };
    const Corner &p = corners_[from], &q = corners_[to];
    Corner found{{between(p.p.x, q.p.x), between(p.p.y, q.p.y), between(p.p.z, q.p.z)}, between(p.w, q.w)};
    Integer common = gcd(gcd(found.p.x, found.p.y), gcd(found.p.z, found.w));
    if (sgn(found.w) < 0) common = -common;
    for (Integer* n : {&found.p.x, &found.p.y, &found.p.z, &found.w})
      mpz_divexact(n->get_mpz_t(), n->get_mpz_t(), common.get_mpz_t());
    return found;
  }

 private:
  Integer height(Place at) const {
    const auto& [p, w] = corners_[at];
    return Integer(normal_.x * p.x + normal_.y * p.y + normal_.z * p.z - offset_ * w);
  }

  const std::vector<Corner>& corners_;
  Vector3<Integer> normal_{0, 0, 0};
  Integer offset_;
  std::uint32_t plane_ = 0;
  std::vector<std::uint32_t> known_;
  std::vector<int> signs_;
};

struct HalfSpace {
  WitnessPlane plane;
  int side;  ///< 1 in front, -1 behind
};
using Path = std::vector<HalfSpace>;

/// A point strictly in all half-spaces: side (normal . p - offset) >= 1 for p = (x - s, y - s, z - s) / w, with x, y,
/// z, s, w not negative and w at least 1.
Point point_within(const Path& path) {
  using Program = LinearProgram<Integer>;
  Program program(5, std::vector<Program::Row>(path.size() + 1, Program::Row::at_most));
  int row = 0;
  for (const auto& [plane, side] : path) {
    const Integer factor = -side * plane.offset.get_den();
    const auto& [x, y, z] = plane.normal;
    program.set_coefficient(row, 0, Integer(factor * x));
    program.set_coefficient(row, 1, Integer(factor * y));
    program.set_coefficient(row, 2, Integer(factor * z));
    program.set_coefficient(row, 3, Integer(-factor * (x + y + z)));
    program.set_coefficient(row, 4, Integer(side * plane.offset.get_num()));
    program.set_right_side(row++, -1);
  }
  program.set_coefficient(row, 4, -1), program.set_right_side(row, -1);
  program.feasible();
  const auto coordinate = [&program](int i) {
    return quotient(Integer(program.numerator(i) - program.numerator(3)), program.numerator(4));
  };
  return {coordinate(0), coordinate(1), coordinate(2)};
}

/// The leading bits of a number.
Rational shortened(const Rational& value, mp_bitcnt_t bits) {
  if (sgn(value) == 0) return value;
  const auto size = [](const Integer& n) { return static_cast<std::int64_t>(mpz_sizeinbase(n.get_mpz_t(), 2)); };
  const std::int64_t last = size(value.get_num()) - size(value.get_den()) - static_cast<std::int64_t>(bits);
  const auto shift = static_cast<mp_bitcnt_t>(std::abs(last));
  const Integer first = last > 0 ? Integer(value.get_num() / (value.get_den() << shift))
                                 : Integer((value.get_num() << shift) / value.get_den());
  return last > 0 ? Rational(Integer(first << shift)) : quotient(first, Integer(Integer(1) << shift));
}

bool strictly_in(const Path& path, const Point& p) {
  return std::all_of(path.begin(), path.end(),
                     [&p](const HalfSpace& half) { return half.side * sgn(height(half.plane, p)) > 0; });
}

/// The same point with as few bits as keep it within all half-spaces.
Point shortest_within(const Path& path, const Point& p) {
  for (mp_bitcnt_t bits = 4; bits <= 4096; bits *= 2) {
    const Point shorter{shortened(p.x, bits), shortened(p.y, bits), shortened(p.z, bits)};
    if (strictly_in(path, shorter)) return shorter;
  }
  return p;
}

/// A point that is nearer for greater k, and on any line through p for at most one k.
Point near(const Point& p, std::int64_t k) {
  const Rational step(Integer(1), Integer(1) << static_cast<mp_bitcnt_t>(k));
  return {Rational(p.x + step), Rational(p.y + k * step), Rational(p.z + k * k * step)};
}

/// The part of a face in a cell that it enters.
struct FacePiece {
  std::array<Place, 3> face;
  Polygon polygon;
};
using Pieces = std::array<std::vector<FacePiece>, 2>;

/// A sample with a regular stride.
std::vector<const FacePiece*> some(const std::vector<FacePiece>& pieces, std::size_t most) {
  std::vector<const FacePiece*> chosen;
  const std::size_t step = (pieces.size() + most - 1) / most;
  for (std::size_t i = 0; i < pieces.size(); i += step) chosen.push_back(&pieces[i]);
  return chosen;
}

/// The numbers of pieces of each solid that enter the part in front of a plane, and behind it.
struct Count {
  std::array<std::size_t, 2> front{}, behind{};
  /// Pairs of pieces of both, and all pieces.
  std::pair<std::size_t, std::size_t> left() const {
    return {front[0] * front[1] + behind[0] * behind[1], front[0] + front[1] + behind[0] + behind[1]};
  }
};

class Cutting {
 public:
  Cutting(SpacePartition& result, const std::array<const Solid*, 2>& solids, Cells cells,
          const SpacePartition::Locate& locate)
      : result_(result), cells_(cells), locate_(locate) {
    for (const std::size_t solid : {0, 1}) {
      const auto first = static_cast<Place>(corners_.size());
      for (const Point3<Integer>& p : solids[solid]->vertices()) corners_.push_back({p, 1});
      for (const Face& f : solids[solid]->faces()) {
        const std::array<Place, 3> face{first + f.a, first + f.b, first + f.c};
        if (cells == Cells::closed || !zero(normal_of(face))) all_[solid].push_back({face, {face.begin(), face.end()}});
      }
    }
  }

  bool all_of_space() { return done({}, all_); }

 private:
  /// Divides a cell until all of its parts are outside of one solid; returns false if a common point is found.
  bool done(const Path& path, const Pieces& pieces) {
    if (pieces[0].empty() || pieces[1].empty()) {
      if (is_outside(path, pieces)) return true;
      if (pieces[0].empty() && pieces[1].empty()) return found(within_);
      if (cells_ == Cells::closed) return found(point(pieces[pieces[0].empty()][0].polygon[0]));
    }
    const WitnessPlane plane = best_plane(pieces);
    result_.tree.push_back(SpacePartition::cut), result_.planes.push_back(plane);
    return part_done(path, pieces, {plane, 1}) && part_done(path, pieces, {plane, -1});
  }

  /// True if the cell is outside of one of the solids that have no face in the cell, so that one point of the cell
  /// decides. A face without area may contain that point, but not all of those near it.
  bool is_outside(const Path& path, const Pieces& pieces) {
    const Point first = shortest_within(path, point_within(path));
    for (std::int64_t k = 0;; ++k) {
      within_ = k == 0 ? first : near(first, k);
      bool on_face = !strictly_in(path, within_);
      for (const std::size_t solid : {0, 1}) {
        if (on_face || !pieces[solid].empty()) continue;
        const Location location = locate_(solid, within_);
        on_face = location == Location::boundary;
        if (location != Location::outside) continue;
        result_.tree.push_back(static_cast<int>(solid)), result_.points.push_back(within_);
        return true;
      }
      if (!on_face) return false;
    }
  }

  bool found(const Point& common) {
    result_.common = common;
    return false;
  }

  const Point3<Integer>& vertex(Place at) const { return corners_[at].p; }
  Point point(Place at) const {
    const auto& [p, w] = corners_[at];
    return {quotient(p.x, w), quotient(p.y, w), quotient(p.z, w)};
  }
  Vector3<Integer> normal_of(const std::array<Place, 3>& face) const {
    return cross(vertex(face[1]) - vertex(face[0]), vertex(face[2]) - vertex(face[0]));
  }
  /// The corners of the faces of these pieces.
  std::vector<Point3<Integer>> corners_of(const std::vector<const FacePiece*>& pieces) const {
    std::vector<Point3<Integer>> corners;
    for (const FacePiece* piece : pieces)
      for (const Place at : piece->face) corners.push_back(vertex(at));
    return corners;
  }

  /// The part of a convex polygon in the closed half-space.
  Polygon clipped(const Polygon& polygon, int side) {
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Place p = polygon[i], q = polygon[(i + 1) % polygon.size()];
      if (side * heights_.side(p) >= 0) kept.push_back(p);
      if (heights_.side(p) * heights_.side(q) >= 0) continue;
      corners_.push_back(heights_.crossing(p, q));
      kept.push_back(static_cast<Place>(corners_.size() - 1));
    }
    return kept;
  }

  bool part_done(Path path, const Pieces& pieces, const HalfSpace& half) {
    Pieces kept;
    heights_.over(half.plane);
    for (const std::size_t solid : {0, 1}) {
      for (const FacePiece& piece : pieces[solid]) {
        if (enters(piece, half.side)) kept[solid].push_back({piece.face, clipped(piece.polygon, half.side)});
      }
    }
    path.push_back(half);
    return done(path, kept);
  }

  bool enters(const FacePiece& piece, int side) {
    const int least = cells_ == Cells::closed ? 0 : 1;
    return std::any_of(piece.polygon.begin(), piece.polygon.end(),
                       [&](Place at) { return side * heights_.side(at) >= least; });
  }

  Count count(const Pieces& pieces, const WitnessPlane& plane) {
    Count found;
    heights_.over(plane);
    for (const std::size_t solid : {0, 1}) {
      for (const FacePiece& piece : pieces[solid])
        found.front[solid] += enters(piece, 1), found.behind[solid] += enters(piece, -1);
    }
    return found;
  }

  WitnessPlane best_plane(const Pieces& pieces) {
    const bool both = !pieces[0].empty() && !pieces[1].empty();
    if (both) {
      const auto a = corners_of(some(pieces[0], most)), b = corners_of(some(pieces[1], most));
      const auto plane = cells_ == Cells::closed ? plane_apart(a, b) : plane_between(a, b);
      if (plane && count(pieces, *plane).left().first == 0) return *plane;
    }
    std::vector<WitnessPlane> candidates = cells_ == Cells::closed ? between_pairs(pieces) : planes_of_faces(pieces);
    if (both && cells_ == Cells::open) add_sides_of_boxes(candidates, pieces);
    const auto left = [&](const WitnessPlane& plane) { return count(pieces, plane).left(); };
    std::size_t best = 0;
    auto least = left(candidates[0]);
    for (std::size_t i = 1; i < candidates.size(); ++i) {
      const auto other = left(candidates[i]);
      if (other < least) best = i, least = other;
    }
    return candidates[best];
  }

  /// Planes that each separate one pair.
  std::vector<WitnessPlane> between_pairs(const Pieces& pieces) const {
    std::vector<WitnessPlane> found;
    for (const FacePiece* p : some(pieces[0], few)) {
      for (const FacePiece* q : some(pieces[1], few)) found.push_back(*plane_apart(corners_of({p}), corners_of({q})));
    }
    return found;
  }

  /// Planes that each end one piece.
  std::vector<WitnessPlane> planes_of_faces(const Pieces& pieces) const {
    std::vector<WitnessPlane> found;
    for (const std::size_t solid : {0, 1}) {
      if (pieces[solid].empty()) continue;
      for (const FacePiece* piece : some(pieces[solid], many)) {
        const Vector3<Integer> normal = normal_of(piece->face);
        const Integer offset = dot(normal, vertex(piece->face[0]) - Point3<Integer>{0, 0, 0});
        found.push_back(WitnessPlane::of(normal, Rational(offset)));
      }
    }
    return found;
  }

  /// The sides of the box around the pieces of one solid. Only those that leave fewer pairs: then both parts have fewer
  /// pieces.
  void add_sides_of_boxes(std::vector<WitnessPlane>& candidates, const Pieces& pieces) {
    for (const auto& of_solid : pieces) {
      std::set<Place> places;
      for (const FacePiece& piece : of_solid) places.insert(piece.polygon.begin(), piece.polygon.end());
      for (const auto& [coordinate, normal] : {std::pair{&Point3<Integer>::x, Vector3<Integer>{1, 0, 0}},
                                               {&Point3<Integer>::y, {0, 1, 0}},
                                               {&Point3<Integer>::z, {0, 0, 1}}}) {
        const auto below = [&, axis = coordinate](Place i, Place j) {
          const Corner &p = corners_[i], &q = corners_[j];
          return p.w == q.w ? p.p.*axis < q.p.*axis : p.p.*axis * q.w < q.p.*axis * p.w;
        };
        const auto [low, high] = std::minmax_element(places.begin(), places.end(), below);
        for (const Place at : {*low, *high}) {
          const Rational end = quotient(corners_[at].p.*coordinate, corners_[at].w);
          const WitnessPlane plane{normal, end};
          if (count(pieces, plane).left().first < pieces[0].size() * pieces[1].size()) candidates.push_back(plane);
        }
      }
    }
  }

  static constexpr std::size_t few = 4, many = 12, most = 64;
  SpacePartition& result_;
  Cells cells_;
  const SpacePartition::Locate& locate_;
  Point within_;
  std::vector<Corner> corners_;
  Heights heights_{corners_};
  Pieces all_;
};

}  // namespace

SpacePartition::SpacePartition(const std::array<const Solid*, 2>& solids, Cells cells, const Locate& locate) {
  Cutting(*this, solids, cells, locate).all_of_space();
}

}  // namespace touchstone::oracle
