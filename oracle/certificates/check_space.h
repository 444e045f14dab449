// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "oracle/certificates/check_reading.h"

/// Shapes of space, and boxes of the plane, in the form of claims, each with the rules of its shape.
namespace touchstone::certify {

/// A position or a displacement.
struct Triple {
  Rational x, y, z;
};

inline bool operator==(const Triple& p, const Triple& q) { return p.x == q.x && p.y == q.y && p.z == q.z; }
inline Triple operator-(const Triple& p, const Triple& q) {
  return {Rational(p.x - q.x), Rational(p.y - q.y), Rational(p.z - q.z)};
}
inline Triple along(const Triple& from, const Rational& t, const Triple& step) {
  return {Rational(from.x + t * step.x), Rational(from.y + t * step.y), Rational(from.z + t * step.z)};
}
inline Rational dot(const Triple& p, const Triple& q) { return Rational(p.x * q.x + p.y * q.y + p.z * q.z); }
inline Triple cross(const Triple& p, const Triple& q) {
  return {Rational(p.y * q.z - p.z * q.y), Rational(p.z * q.x - p.x * q.z), Rational(p.x * q.y - p.y * q.x)};
}

/// The points p with normal . p + offset = 0.
struct Plane {
  Triple normal;
  Rational offset;
  Rational at(const Triple& p) const { return Rational(dot(normal, p) + offset); }
};

/// Closed, of a radius that is not negative.
struct Ball {
  Triple center;
  Rational radius;
};

/// Closed, of the plane or of space: two or three coordinates, of a radius that is not negative.
struct BallOrDisc {
  std::vector<Rational> center;
  Rational radius;
  std::size_t axes() const { return center.size(); }
};

/// The points p with min[k] <= p[k] <= max[k]; two or three of each, min[k] <= max[k].
struct Box {
  std::vector<Rational> min, max;
  std::size_t axes() const { return min.size(); }
  bool holds(const std::vector<Rational>& p) const;
};
/// Requires a point strictly between min and max.
void expect_inside(const Box& box, const std::vector<Rational>& p);
/// Requires that the fact `axis` names one on which min = max.
void expect_flat_axis(const Claim& claim, const Box& box);

/// Input, by the field's name; `what` names the field in a refusal.
/// The coordinates of a point of the plane or of space.
std::vector<Rational> two_or_three(const json& value, const std::string& what);
Triple point_in_space(const json& value, const std::string& what);
Plane plane(const json& value, const std::string& what);
/// At least one.
std::vector<Triple> points_in_space(const json& value, const std::string& what);
std::vector<Triple> polygon_in_space(const json& value, const std::string& what);
Ball ball(const json& value, const std::string& what);
/// Shapes of the plane or of space, also the next.
BallOrDisc ball_or_disc(const json& value, const std::string& what);
Box box(const json& value, const std::string& what);
Box box_in_space(const json& value, const std::string& what);

/// Exact values of the truth and of the certificate.
Triple exact_triple(const json& value, const std::string& what);
Triple triple(const Claim& claim, const char* name);
/// The points of a list that a fact names by index.
std::vector<Triple> named(const Claim& claim, const char* fact, const std::vector<Triple>& points);

}  // namespace touchstone::certify
