// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/space_partition.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "oracle/exact/linear_program.h"
#include "oracle/exact/plane_between.h"
#include "oracle/exact/whole_cloud.h"

namespace touchstone::oracle {
namespace {

using Point = Point3<Rational>;
using Cells = SpacePartition::Cells;
using Polygon = std::vector<Point>;

Rational height(const WitnessPlane& plane, const Point& p) {
  const auto& n = plane.normal;
  return Rational(n.x * p.x + n.y * p.y + n.z * p.z - plane.offset);
}

struct HalfSpace {
  WitnessPlane plane;
  int side;  ///< 1 in front, -1 behind
};
using Path = std::vector<HalfSpace>;

/// What of a convex polygon is in the half-space, closed.
Polygon clipped(const Polygon& polygon, const HalfSpace& half) {
  std::vector<Rational> heights;
  for (const Point& p : polygon) heights.emplace_back(half.side * height(half.plane, p));
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t next = (i + 1) % polygon.size();
    const Point &p = polygon[i], &q = polygon[next];
    if (sgn(heights[i]) >= 0) kept.push_back(p);
    if (sgn(heights[i]) * sgn(heights[next]) >= 0) continue;
    const Rational t = heights[i] / (heights[i] - heights[next]);
    kept.push_back({Rational(p.x + t * (q.x - p.x)), Rational(p.y + t * (q.y - p.y)), Rational(p.z + t * (q.z - p.z))});
  }
  return kept;
}

/// A point strictly in all half-spaces: side (normal . p - offset) >= 1 in p = (x - s, y - s, z - s) / w, all of x, y,
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

/// The first so many bits of a number.
Rational shortened(const Rational& value, mp_bitcnt_t bits) {
  if (sgn(value) == 0) return value;
  const auto size = [](const Integer& n) { return static_cast<long>(mpz_sizeinbase(n.get_mpz_t(), 2)); };
  const long last = size(value.get_num()) - size(value.get_den()) - static_cast<long>(bits);
  const auto shift = static_cast<mp_bitcnt_t>(std::labs(last));
  const Integer first = last > 0 ? Integer(value.get_num() / (value.get_den() << shift))
                                 : Integer((value.get_num() << shift) / value.get_den());
  return last > 0 ? Rational(Integer(first << shift)) : quotient(first, Integer(Integer(1) << shift));
}

bool strictly_in(const Path& path, const Point& p) {
  return std::all_of(path.begin(), path.end(),
                     [&p](const HalfSpace& half) { return half.side * sgn(height(half.plane, p)) > 0; });
}

/// The same point with so few bits that they take it no farther than within all half-spaces.
Point shortest_within(const Path& path, const Point& p) {
  for (mp_bitcnt_t bits = 4; bits <= 4096; bits *= 2) {
    const Point shorter{shortened(p.x, bits), shortened(p.y, bits), shortened(p.z, bits)};
    if (strictly_in(path, shorter)) return shorter;
  }
  return p;
}

/// The nearer, the greater k is, and on any line through p for one k at most.
Point near(const Point& p, long k) {
  const Rational step(Integer(1), Integer(1) << static_cast<mp_bitcnt_t>(k));
  return {Rational(p.x + step), Rational(p.y + k * step), Rational(p.z + k * k * step)};
}

/// What of a face is in a cell that it enters.
struct Piece {
  const Triangle3<Integer>* face;
  Polygon polygon;
};
using Pieces = std::array<std::vector<Piece>, 2>;

/// Every so manyth.
std::vector<const Piece*> some(const std::vector<Piece>& pieces, std::size_t most) {
  std::vector<const Piece*> chosen;
  const std::size_t step = (pieces.size() + most - 1) / most;
  for (std::size_t i = 0; i < pieces.size(); i += step) chosen.push_back(&pieces[i]);
  return chosen;
}

/// The corners of the faces of which these are pieces.
std::vector<Point3<Integer>> corners_of(const std::vector<const Piece*>& pieces) {
  std::vector<Point3<Integer>> corners;
  for (const Piece* piece : pieces) corners.insert(corners.end(), {piece->face->a, piece->face->b, piece->face->c});
  return corners;
}

Vector3<Integer> normal_of(const Triangle3<Integer>& face) { return cross(face.b - face.a, face.c - face.a); }

/// How many pieces of each solid enter what is in front of a plane, and behind it.
struct Count {
  std::array<std::size_t, 2> front{}, behind{};
  /// Pairs of pieces of both, and all pieces.
  std::pair<std::size_t, std::size_t> left() const {
    return {front[0] * front[1] + behind[0] * behind[1], front[0] + front[1] + behind[0] + behind[1]};
  }
};

class Cutting {
 public:
  Cutting(SpacePartition& result, const FacesOfBoth& faces, Cells cells, const SpacePartition::Locate& locate)
      : result_(result), cells_(cells), locate_(locate) {
    for (const std::size_t solid : {0, 1}) {
      for (const Triangle3<Integer>& face : faces[solid]) {
        if (cells == Cells::open && zero(normal_of(face))) continue;
        const auto rational = [](const Point3<Integer>& p) {
          return Point{Rational(p.x), Rational(p.y), Rational(p.z)};
        };
        all_[solid].push_back({&face, {rational(face.a), rational(face.b), rational(face.c)}});
      }
    }
  }

  bool all_of_space() { return done({}, all_); }

 private:
  /// Divides a cell until all of its parts are outside of one solid; false where a common point is found.
  bool done(const Path& path, const Pieces& pieces) {
    if (pieces[0].empty() || pieces[1].empty()) {
      if (is_outside(path, pieces)) return true;
      if (pieces[0].empty() && pieces[1].empty()) return found(within_);
      if (cells_ == Cells::closed) return found(pieces[pieces[0].empty()][0].polygon[0]);
    }
    const WitnessPlane plane = best_plane(pieces);
    result_.tree.push_back(SpacePartition::cut), result_.planes.push_back(plane);
    return part_done(path, pieces, {plane, 1}) && part_done(path, pieces, {plane, -1});
  }

  /// Of one of the solids that have no face in the cell, and so one point of the cell tells. A face without area may
  /// hold it, but not all of those near it.
  bool is_outside(const Path& path, const Pieces& pieces) {
    const Point first = shortest_within(path, point_within(path));
    for (long k = 0;; ++k) {
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

  bool part_done(Path path, const Pieces& pieces, const HalfSpace& half) {
    Pieces kept;
    for (const std::size_t solid : {0, 1}) {
      for (const Piece& piece : pieces[solid]) {
        if (enters(piece, half)) kept[solid].push_back({piece.face, clipped(piece.polygon, half)});
      }
    }
    path.push_back(half);
    return done(path, kept);
  }

  bool enters(const Piece& piece, const HalfSpace& half) const {
    const int least = cells_ == Cells::closed ? 0 : 1;
    return std::any_of(piece.polygon.begin(), piece.polygon.end(),
                       [&](const Point& p) { return half.side * sgn(height(half.plane, p)) >= least; });
  }

  Count count(const Pieces& pieces, const WitnessPlane& plane) const {
    Count found;
    for (const std::size_t solid : {0, 1}) {
      for (const Piece& piece : pieces[solid])
        found.front[solid] += enters(piece, {plane, 1}), found.behind[solid] += enters(piece, {plane, -1});
    }
    return found;
  }

  WitnessPlane best_plane(const Pieces& pieces) const {
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

  /// Each keeps one pair apart.
  std::vector<WitnessPlane> between_pairs(const Pieces& pieces) const {
    std::vector<WitnessPlane> found;
    for (const Piece* p : some(pieces[0], few)) {
      for (const Piece* q : some(pieces[1], few)) found.push_back(*plane_apart(corners_of({p}), corners_of({q})));
    }
    return found;
  }

  /// Each ends one piece.
  std::vector<WitnessPlane> planes_of_faces(const Pieces& pieces) const {
    std::vector<WitnessPlane> found;
    for (const std::size_t solid : {0, 1}) {
      if (pieces[solid].empty()) continue;
      for (const Piece* piece : some(pieces[solid], many)) {
        const Vector3<Integer> normal = normal_of(*piece->face);
        const Integer offset = dot(normal, piece->face->a - Point3<Integer>{0, 0, 0});
        found.push_back(WitnessPlane::of(normal, Rational(offset)));
      }
    }
    return found;
  }

  /// Where the box around the pieces of one solid ends. Only those that leave fewer pairs: then both parts have fewer
  /// pieces.
  void add_sides_of_boxes(std::vector<WitnessPlane>& candidates, const Pieces& pieces) const {
    for (const auto& of_solid : pieces) {
      for (const auto& [coordinate, normal] :
           {std::pair{&Point::x, Vector3<Integer>{1, 0, 0}}, {&Point::y, {0, 1, 0}}, {&Point::z, {0, 0, 1}}}) {
        Rational low = of_solid[0].polygon[0].*coordinate, high = low;
        for (const Piece& piece : of_solid) {
          for (const Point& p : piece.polygon) low = std::min(low, p.*coordinate), high = std::max(high, p.*coordinate);
        }
        for (const Rational& end : {low, high}) {
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
  Pieces all_;
};

}  // namespace

SpacePartition::SpacePartition(const FacesOfBoth& faces, Cells cells, const Locate& locate) {
  Cutting(*this, faces, cells, locate).all_of_space();
}

}  // namespace touchstone::oracle
