// SPDX-License-Identifier: Apache-2.0
#include "report/figures/space_lens.h"

#include <algorithm>
#include <cmath>

#include "catalogue/numbers/ulps.h"
#include "report/figures/viewport.h"

namespace touchstone::report {
namespace {

using SpaceKind = SpaceFigure::Kind;
using Ring = std::vector<SpaceVertex>;

constexpr int half_in_gaps = 4, cut_in_halves = 10, flat_in_halves = 50;

mpq_class coordinate(const SpaceVector& v, std::size_t axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }

class Lens {
 public:
  Lens(const SpaceVertex& centre, const mpq_class& half) : centre_(centre), half_(half) {}

  const mpq_class& half() const { return half_; }
  SpacePoint steps(const SpaceVertex& p) const {
    SpaceScale scale;
    scale.middle = {centre_.x, centre_.y, centre_.z};
    scale.steps_per_unit.fill(mpq_class(steps_of_box / half_));
    return scale.at({p.x, p.y, p.z});
  }
  /// The part of a convex ring, an edge or a point in the cube that extends this many halves from the centre.
  Ring cut(Ring ring, const mpq_class& halves) const {
    const mpq_class reach = halves * half_;
    for (std::size_t side = 0; side < 6; ++side) {
      const auto inside = [&](const SpaceVertex& p) {
        const mpq_class x = coordinate(p - centre_, side / 2);
        return mpq_class(side % 2 == 0 ? mpq_class(reach - x) : mpq_class(reach + x));
      };
      Ring kept;
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const SpaceVertex &p = ring[i], &q = ring[(i + 1) % ring.size()];
        const mpq_class in_p = inside(p), in_q = inside(q);
        if (sgn(in_p) >= 0) kept.push_back(p);
        const bool closes = i + 1 == ring.size() && ring.size() < 3;
        if (!closes && sgn(in_p) * sgn(in_q) < 0) kept.push_back(p + mpq_class(in_p / (in_p - in_q)) * (q - p));
      }
      ring = std::move(kept);
    }
    return ring;
  }
  /// A square of a plane about the foot of the centre.
  Ring patch(const SpaceVector& normal, const SpaceVertex& of_plane) const {
    const SpaceVertex foot = centre_ + mpq_class(dot(of_plane - centre_, normal) / dot(normal, normal)) * normal;
    const mpq_class sizes[] = {abs(normal.x), abs(normal.y), abs(normal.z)};
    const auto least = std::min_element(sizes, sizes + 3) - sizes;
    const SpaceVector axis{mpq_class(least == 0), mpq_class(least == 1), mpq_class(least == 2)};
    const SpaceVector u = spread(cross(normal, axis)), v = spread(cross(normal, u));
    const mpq_class back(-1);
    return {foot + u + v, foot + back * u + v, foot + back * u + back * v, foot + u + back * v};
  }

 private:
  SpaceVector spread(const SpaceVector& v) const {
    const mpq_class size = abs(v.x) + abs(v.y) + abs(v.z);
    return mpq_class(3 * cut_in_halves * half_ / size) * v;
  }

  SpaceVertex centre_;
  mpq_class half_;
};

/// The surface near the lens of a much larger ball.
Ring tangent_patch(const Lens& lens, const SpaceVertex& centre, const SpaceVertex& near, const mpq_class& radius) {
  const SpaceVector displacement = near - centre;
  const mpq_class square = dot(displacement, displacement), length = length_of(displacement);
  const SpaceVertex place = near + mpq_class((radius * radius - square) / ((radius + length) * length)) * displacement;
  return lens.patch(displacement, place);
}

struct Cut {
  std::string kind = "mesh";
  std::vector<Ring> rings;
  std::optional<mpq_class> radius;
};

/// The part of a figure that the lens shows, before it is cut.
Cut shape_of(const SpaceFigure& figure, const Lens& lens, const SpaceVertex& near) {
  switch (figure.kind) {
    case SpaceKind::arrow: return {};
    case SpaceKind::point: return {"point", {vertices_of(figure)}, {}};
    case SpaceKind::segment: return {"segment", {vertices_of(figure)}, {}};
    case SpaceKind::plane: {
      const SpaceVector normal{exact_value(figure.numbers[0]), exact_value(figure.numbers[1]),
                               exact_value(figure.numbers[2])};
      const SpaceVertex foot =
          SpaceVertex{0, 0, 0} + mpq_class(-exact_value(figure.numbers[3]) / dot(normal, normal)) * normal;
      return {"mesh", {lens.patch(normal, foot)}, {}};
    }
    case SpaceKind::sphere: {
      const mpq_class radius = radius_of(figure);
      if (sgn(radius) == 0) return {"point", {vertices_of(figure)}, {}};
      if (radius <= flat_in_halves * lens.half()) return {"sphere", {vertices_of(figure)}, radius};
      if (vertices_of(figure)[0] == near) return {};  // its surface is far from its center
      return {"mesh", {tangent_patch(lens, vertices_of(figure)[0], near, radius)}, {}};
    }
    case SpaceKind::polygon:
      if (figure.numbers.size() == 6) return {"segment", {vertices_of(figure)}, {}};
      [[fallthrough]];
    case SpaceKind::box:
    case SpaceKind::mesh: return {"mesh", faces_of(figure), {}};
  }
  return {};
}

Json json_of(const SpaceFigure& figure, const Lens& lens, const SpaceVertex& near) {
  const Cut shape = shape_of(figure, lens, near);
  Json points = Json::array(), faces = Json::array(), places = Json::array();
  for (const Ring& ring : shape.rings) {
    const Ring drawn = shape.radius ? ring : lens.cut(ring, cut_in_halves);
    Json face = Json::array();
    for (const SpaceVertex& p : drawn) face.push_back(points.size()), points.push_back(lens.steps(p));
    if (face.size() > 2) faces.push_back(face);
    const Ring seen = lens.cut(ring, mpq_class(4, 5));
    for (std::size_t i = 0; i < seen.size(); ++i) {
      const SpaceVector across = seen[(i + 1) % seen.size()] - seen[i];
      places.push_back(lens.steps(seen[i] + mpq_class(1, 2) * across));
    }
  }
  const std::size_t needed = shape.kind == "segment" ? 2 : 1;
  const bool whole = shape.kind == "mesh" || points.size() >= needed;
  Json json{{"kind", whole ? shape.kind : "mesh"},
            {"label", figure.label},
            {"whose", whose(figure)},
            {"points", whole ? points : Json::array()},
            {"places", places}};
  if (json["kind"] == "mesh") json["faces"] = faces;
  add_node(json, figure);
  if (shape.radius) json["radius"] = lens.steps(near + SpaceVector{*shape.radius, 0, 0})[0] - lens.steps(near)[0];
  return json;
}

double rounded(double x) { return std::floor(1e6 * x + 0.5) / 1e6; }

/// A rotation that brings `along` into the plane of the screen, so that planes perpendicular to it are seen edge on.
Json turn_to(const SpaceVector& along) {
  const mpq_class length = length_of(along);
  const double x = mpq_class(along.x / length).get_d(), y = mpq_class(along.y / length).get_d(),
               z = mpq_class(along.z / length).get_d(), level = x * x + z * z;
  double sin_pitch = 5.0 / 13, cos_pitch = 12.0 / 13, sin_yaw = 8.0 / 17, cos_yaw = 15.0 / 17;
  double depth = -sin_pitch / cos_pitch * y;
  if (depth * depth > level) sin_pitch = 0, cos_pitch = 1, depth = 0;
  if (level > 1e-12) {
    const double rest = std::sqrt(std::max(0.0, level - depth * depth)), displacement = x < 0 ? -1 : 1;
    sin_yaw = (depth * x - displacement * z * rest) / level;
    cos_yaw = (depth * z + displacement * x * rest) / level;
  }
  return {{"cosYaw", rounded(cos_yaw)},
          {"sinYaw", rounded(sin_yaw)},
          {"cosPitch", rounded(cos_pitch)},
          {"sinPitch", rounded(sin_pitch)}};
}

}  // namespace

void add_node(Json& model, const SpaceFigure& figure) {
  if (!figure.node) return;
  model["node"] = figure.node->depth;
  model["entered"] = figure.node->entered;
}

Json space_lens(const std::vector<SpaceFigure>& figures, const SpaceScale& whole, const SpaceGap& gap) {
  const Lens lens(gap.at, mpq_class(half_in_gaps * gap.gap));
  Json model{
      {"title", "the gap, magnified"},
      {"figures", Json::array()},
      {"spans", {"around " + gap.label + ", " + about(mpq_class(2 * lens.half())) + " wide; gap " + about(gap.gap)}},
      {"remarks", Json::array()},
      {"reach", steps_of_box},
      {"mark", whole.at({gap.at.x, gap.at.y, gap.at.z})},
      {"turn", turn_to(gap.along)}};
  for (const SpaceFigure& figure : figures) model["figures"].push_back(json_of(figure, lens, gap.at));
  return model;
}

}  // namespace touchstone::report
