// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "catalogue/families/draw_stream.h"
#include "catalogue/operation/operation.h"
#include "proptests/long_rings.h"

/// Questions in general position whose lists have as many elements as one likes.
namespace touchstone::proptests {

using catalogue::DrawStream;
using catalogue::Json;

/// Elements of a list, each drawn.
class GrowingLists {
 public:
  explicit GrowingLists(std::size_t n) : n_(n), draws_(DrawStream::seeded(n)) {}

  /// From -size to size.
  double number(double size) { return size * (static_cast<double>(draws_.any_bits() >> 11) * 0x1p-52 - 1); }
  Json in_space(double size = 1) {
    const double x = number(size), y = number(size);
    return Json::array({x, y, number(size)});
  }
  /// n / `share` elements.
  template <class Element>
  Json list(const Element& element, std::size_t share = 1) {
    Json list = Json::array();
    for (std::size_t i = 0; i < n_ / share; ++i) list.push_back(element(i));
    return list;
  }
  Json points(std::size_t share = 1) {
    return list([this](std::size_t) { return in_space(); }, share);
  }
  Json points_of_plane() {
    return list([this](std::size_t) { return Json::array({number(1), number(1)}); });
  }
  Json box(double middle_x, double middle_y, double middle_z) {
    const double x = 1 + number(0.5), y = 1 + number(0.5), z = 1 + number(0.5);
    return {{"min", {middle_x - x, middle_y - y, middle_z - z}}, {"max", {middle_x + x, middle_y + y, middle_z + z}}};
  }
  double room() const { return 2 * std::cbrt(static_cast<double>(n_)); }
  /// Boxes of one to three units, about one in each 64 units of space; n / `share` of them.
  Json boxes(std::size_t share = 1) {
    return list(
        [this](std::size_t) {
          const double x = number(room()), y = number(room());
          return box(x, y, number(room()));
        },
        share);
  }
  Json queries(std::size_t share) {
    return list(
        [this](std::size_t i) -> Json {
          if (i % 3 == 0) return {{"at_point", in_space(room())}};
          if (i % 3 == 1) return {{"along_ray", {{"origin", in_space(room())}, {"direction", in_space()}}}};
          return {{"in_box", box(number(room()), number(room()), number(room()))}};
        },
        share);
  }
  /// Normals and slabs that hold the ball of radius 1 around the origin.
  Json kdop() {
    Json normals = points(2);
    return {{"normals", normals},
            {"slabs", list(
                          [&normals](std::size_t i) {
                            const double r =
                                std::hypot(double(normals[i][0]), double(normals[i][1]), double(normals[i][2]));
                            return Json::array({-2 * r, 2 * r});
                          },
                          2)}};
  }
  /// A ring whose distance from (x, 0) goes up and down, of n / `share` vertices.
  Json ring(double x = 0, std::size_t share = 1) {
    Json ring = Json::array();
    for (const Point2d& p : wavy_ring(n_ / share).vertices) ring.push_back({x + p.x, p.y});
    return ring;
  }
  /// Such a ring, and a hole of the same form and a quarter of its size.
  Json region(double x = 0, std::size_t share = 1) {
    Json outer = ring(x, 2 * share), hole = Json::array();
    for (const Point2d& p : wavy_ring(n_ / share / 2).vertices) hole.push_back({x + p.x / 4, p.y / 4});
    return {{"outer", outer}, {"holes", Json::array({hole})}};
  }
  Json convex_ring() {
    return list([this](std::size_t i) {
      const double u = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n_);
      return Json::array({std::cos(u), std::sin(u)});
    });
  }
  /// With one number so small that floating point alone, in which no steps are counted, does not answer.
  Json polygon_in_space() {
    Json polygon = ring();
    for (Json& vertex : polygon) vertex.push_back(number(0.5));
    polygon[0][2] = 0x1p-400;
    return polygon;
  }
  /// A sphere around (x, 0, 0) of radius 1, an icosahedron whose faces are cut into four as often as n allows.
  Json sphere(double x = 0, std::size_t share = 1) const;
  /// Unequal balls on a lattice so wide that none meets another, and slow.
  Json balls() {
    const auto side = static_cast<std::size_t>(std::ceil(std::cbrt(static_cast<double>(n_))));
    return list([&](std::size_t i) -> Json {
      const auto at = [](std::size_t k) { return 4 * static_cast<double>(k); };
      const Json center{at(i % side), at(i / side % side), at(i / side / side)};
      return {{"inverse_mass", 1},
              {"velocity", in_space()},
              {"sphere", {{"center", center}, {"radius", 0.75 + number(0.25)}}}};
    });
  }

 private:
  std::size_t n_;
  DrawStream draws_;
};

inline Json GrowingLists::sphere(double x, std::size_t share) const {
  const double t = (1 + std::sqrt(5.0)) / 2;
  std::vector<Point3d> vertices{{-1, t, 0},  {1, t, 0},  {-1, -t, 0}, {1, -t, 0}, {0, -1, t},  {0, 1, t},
                                {0, -1, -t}, {0, 1, -t}, {t, 0, -1},  {t, 0, 1},  {-t, 0, -1}, {-t, 0, 1}};
  std::vector<Face> faces{{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                          {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                          {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  const auto on_sphere = [](const Point3d& p) {
    const double r = std::hypot(p.x, p.y, p.z);
    return Point3d{p.x / r, p.y / r, p.z / r};
  };
  for (Point3d& p : vertices) p = on_sphere(p);
  while (6 * faces.size() * share <= n_) {
    std::map<std::pair<Index, Index>, Index> middles;
    const auto middle = [&](Index i, Index j) {
      const auto [at, added] = middles.emplace(std::minmax(i, j), static_cast<Index>(vertices.size()));
      const Point3d &p = vertices[i], &q = vertices[j];
      if (added) vertices.push_back(on_sphere({p.x + q.x, p.y + q.y, p.z + q.z}));
      return at->second;
    };
    std::vector<Face> finer;
    for (const auto& [a, b, c] : faces) {
      const Index ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      for (const Face& face : {Face{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}}) finer.push_back(face);
    }
    faces = std::move(finer);
  }
  Json mesh{{"vertices", Json::array()}, {"faces", Json::array()}};
  for (const Point3d& p : vertices) mesh["vertices"].push_back({x + p.x, p.y, p.z});
  for (const auto& [a, b, c] : faces) mesh["faces"].push_back({a, b, c});
  return mesh;
}

/// Of each operation that is asked about lists: a question of about n elements, all lists together.
inline const std::map<std::string, std::function<Json(GrowingLists)>>& growing_questions() {
  using L = GrowingLists;
  const Json origin{0.1, 0.2, 0.3};
  const auto body = [](L& l) -> Json { return {{"mass", 2 + l.number(1)}, {"velocity", l.in_space()}}; };
  const auto bodies = [body](L l) -> Json { return {{"bodies", l.list([&](std::size_t) { return body(l); })}}; };
  const auto ring = [](L l) -> Json { return {{"polygon", l.ring()}}; };
  const auto cloud = [](L l) -> Json { return {{"points", l.points()}}; };
  static const std::map<std::string, std::function<Json(L)>> questions{
      {"all_pairs",
       [](L l) -> Json {
         return {{"boxes", l.boxes()}};
       }},
      {"broad_phase",
       [](L l) -> Json {
         return {{"boxes", l.boxes(2)}, {"commands", l.queries(2)}};
       }},
      {"polygon_normal",
       [](L l) -> Json {
         return {{"polygon", l.polygon_in_space()}};
       }},
      {"triangulate_polygon", ring},
      {"convex_partition", ring},
      {"interior_angles", ring},
      {"polygon_convexity", ring},
      {"point_in_polygon",
       [](L l) -> Json {
         return {{"polygon", l.ring()}, {"point", {0.1, 0.2}}};
       }},
      {"point_in_region",
       [](L l) -> Json {
         return {{"region", l.region()}, {"point", {0.1, 0.2}}};
       }},
      {"region_region",
       [](L l) -> Json {
         return {{"a", l.region(0, 2)}, {"b", l.region(1, 2)}};
       }},
      {"point_in_convex_polygon",
       [](L l) -> Json {
         return {{"polygon", l.convex_ring()}, {"point", {0.1, 0.2}}};
       }},
      {"polygon_polygon",
       [](L l) -> Json {
         return {{"a", l.ring(0, 2)}, {"b", l.ring(1, 2)}};
       }},
      {"aabb_of_points", cloud},
      {"obb_of_points", cloud},
      {"convex_hull", cloud},
      {"convex_hull_2d",
       [](L l) -> Json {
         return {{"points", l.points_of_plane()}};
       }},
      {"bounding_sphere",
       [](L l) -> Json {
         return {{"points", l.points()}, {"method", "smallest"}};
       }},
      {"kdop_of_points",
       [](L l) -> Json {
         return {{"points", l.points(2)}, {"normals", l.points(2)}};
       }},
      {"point_in_kdop",
       [origin](L l) -> Json {
         return {{"kdop", l.kdop()}, {"point", origin}};
       }},
      {"kdop_kdop",
       [](L l) -> Json {
         const Json kdop = l.kdop();
         return {{"a", kdop}, {"b", kdop}};
       }},
      {"point_in_polyhedron",
       [origin](L l) -> Json {
         return {{"mesh", l.sphere()}, {"point", origin}};
       }},
      {"point_mesh_distance",
       [origin](L l) -> Json {
         return {{"point", origin}, {"mesh", l.sphere()}};
       }},
      {"ray_mesh",
       [origin](L l) -> Json {
         return {{"ray", {{"origin", origin}, {"direction", {1, 0.2, 0.1}}}}, {"mesh", l.sphere()}};
       }},
      {"point_in_convex_polyhedron",
       [origin](L l) -> Json {
         return {{"mesh", l.sphere()}, {"point", origin}};
       }},
      {"polyhedron_complexity",
       [](L l) -> Json {
         return {{"mesh", l.sphere()}};
       }},
      {"polyhedron_polyhedron",
       [](L l) -> Json {
         return {{"a", l.sphere(0, 2)}, {"b", l.sphere(1.5, 2)}};
       }},
      {"convex_distance",
       [](L l) -> Json {
         return {{"a", l.sphere(0, 2)}, {"b", l.sphere(3, 2)}};
       }},
      {"penetration",
       [](L l) -> Json {
         return {{"a", l.sphere(0, 2)}, {"b", l.sphere(1.5, 2)}, {"radius_a", 0.1}, {"radius_b", 0}};
       }},
      {"sphere_convex",
       [](L l) -> Json {
         return {{"sphere", {{"center", {2, 0.1, 0.2}}, {"radius", 1}}}, {"mesh", l.sphere()}};
       }},
      {"capsule_convex",
       [](L l) -> Json {
         return {{"capsule", {{"segment", {{2, 0.1, 0.2}, {1.5, 3, 0.1}}}, {"radius", 1}}}, {"mesh", l.sphere()}};
       }},
      {"swept_convex_polyhedra",
       [](L l) -> Json {
         return {{"a", l.sphere(0, 2)}, {"b", l.sphere(3, 2)}, {"velocity", {2, 0.1, 0.2}}};
       }},
      {"swept_sphere_mesh",
       [origin](L l) -> Json {
         return {{"sphere", {{"center", origin}, {"radius", 0.5}}}, {"velocity", {2, 0.1, 0.2}}, {"mesh", l.sphere()}};
       }},
      {"momentum", bodies},
      {"kinetic_energy", bodies},
      {"simultaneous_collisions",
       [](L l) -> Json {
         // Pairs of bodies, each pair a collision of its own.
         Json bodies = l.list(
             [&](std::size_t) -> Json {
               return {{"inverse_mass", 1}, {"velocity", l.in_space()}};
             },
             3);
         Json contacts = Json::array();
         for (std::size_t i = 0; i + 1 < bodies.size(); i += 2)
           contacts.push_back({{"a", i}, {"b", i + 1}, {"normal", l.in_space()}});
         return {{"bodies", bodies}, {"contacts", contacts}, {"e", 0.5}};
       }},
      {"impact_step",
       [](L l) -> Json {
         return {{"bodies", l.balls()}, {"walls", Json::array()}, {"restitution", 0.5}, {"timestep", 0.125}};
       }},
      {"simulation_step",
       [](L l) -> Json {
         return {{"bodies", l.balls()},
                 {"walls", Json::array()},
                 {"settings",
                  {{"gravity", {0, 0, -8}},
                   {"motion", "accelerate_then_move"},
                   {"restitution", 0.5},
                   {"timestep", 0.125},
                   {"turn", "before_move"}}}};
       }},
  };
  return questions;
}

/// Of a method of an operation: that operation's.
inline catalogue::Question growing_question(const catalogue::Operation& operation, std::size_t n) {
  const auto& metadata = operation.metadata();
  const std::string name = metadata.is_implementation() ? metadata.implementation_of : metadata.name;
  return operation.parse(catalogue::parse_line(catalogue::one_line(growing_questions().at(name)(GrowingLists(n)))));
}

}  // namespace touchstone::proptests
