// SPDX-License-Identifier: Apache-2.0
#include "catalogue/codec/mesh_json.h"

#include <gmpxx.h>

#include <algorithm>
#include <string>
#include <variant>

#include "catalogue/codec/expected.h"
#include "geometry/validation.h"
#include "robust/kernel/solids/polygon_faces.h"
#include "robust/structures/polygon_mesh.h"

namespace touchstone::catalogue {
namespace {

using Corners = std::vector<Index>;

std::vector<Corners> read_lists(const Json& json, const std::string& path) {
  if (!json.is_array()) throw InvalidInput(path, expected("an array", json));
  std::vector<Corners> lists;
  for (const Json& list : json) {
    const std::string place = element(path, lists.size());
    if (!list.is_array()) throw InvalidInput(place, expected("an array of at least 3 corners", list));
    Corners& corners = lists.emplace_back();
    for (const Json& corner : list) corners.push_back(read_index(corner, element(place, corners.size())));
  }
  return lists;
}

/// The extent is computed in doubles, for all number types.
double thickness_of(const std::vector<Point3d>& vertices, const Corners& corners) {
  return robust::thickness(vertices, corners);
}
double thickness_of(const std::vector<Point3<mpq_class>>& vertices, const Corners& corners) {
  std::vector<Point3d> near;
  for (const auto& p : vertices) near.push_back({p.x.get_d(), p.y.get_d(), p.z.get_d()});
  return robust::thickness(near, corners);
}

template <class Real>
std::vector<Face> cut_of(const std::vector<Corners>& polygons, const std::string& path, const Real* numbers,
                         std::size_t count) {
  std::vector<Point3<Real>> vertices;
  for (std::size_t i = 0; i < count; ++i) vertices.push_back({numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]});
  Mesh<Real>{vertices, {}, polygons}.polygon_rules(validation::Refusing{path});
  std::vector<Face> triangles;
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    const Corners& corners = polygons[i];
    if (corners.size() == 3) {
      triangles.push_back({corners[0], corners[1], corners[2]});
      continue;
    }
    const auto cut = robust::kernel::cut_polygon(vertices, corners);
    if (const auto* faces = std::get_if<std::vector<Face>>(&cut)) {
      triangles.insert(triangles.end(), faces->begin(), faces->end());
    } else if (std::get<robust::kernel::PolygonDefect>(cut) == robust::kernel::PolygonDefect::no_ring) {
      validation::refuse_ring(path, i);
    } else {
      throw InvalidInput(element(path + ".faces", i),
                         "planar: its corners lie " + decimal(thickness_of(vertices, corners)) + " apart across it");
    }
  }
  return triangles;
}

}  // namespace

template <class Real>
void read_faces(const Json& mesh, const std::string& path, const Real* vertices, std::size_t count,
                std::vector<Word>& words) {
  const std::string faces = member_path(path, "faces"), cut = member_path(path, "cut");
  const auto append = [&words](const auto& corners) { words.insert(words.end(), corners.begin(), corners.end()); };
  const auto length = [&words](std::size_t size) { words.push_back(static_cast<Word>(size)); };
  const std::vector<Corners> named = read_lists(mesh["faces"], faces);
  const bool triangles =
      std::all_of(named.begin(), named.end(), [](const Corners& corners) { return corners.size() == 3; });
  if (triangles) {
    if (mesh.contains("cut")) throw InvalidInput(cut, "only where a face has more than three corners");
    length(named.size());
    for (const Corners& corners : named) append(corners);
    return length(0);
  }
  if (mesh.contains("cut")) {
    const std::vector<Corners> given = read_lists(mesh["cut"], cut);
    length(given.size());
    for (std::size_t i = 0; i < given.size(); ++i) {
      if (given[i].size() != 3) throw InvalidInput(element(cut, i), "three corners");
      append(given[i]);
    }
  } else {
    const std::vector<Face> made = cut_of(named, path, vertices, count);
    length(made.size());
    for (const Face& f : made) append(std::vector<Index>{f.a, f.b, f.c});
  }
  length(named.size());
  for (const Corners& corners : named) length(corners.size()), append(corners);
}

template void read_faces(const Json&, const std::string&, const double*, std::size_t, std::vector<Word>&);
template void read_faces(const Json&, const std::string&, const mpq_class*, std::size_t, std::vector<Word>&);

Json with_polygons_as_faces(Json mesh) {
  Json result = Json::object();
  result["vertices"] = std::move(mesh["vertices"]);
  const bool polygons = !mesh["polygons"].empty();
  result["faces"] = std::move(mesh[polygons ? "polygons" : "faces"]);
  if (polygons) result["cut"] = std::move(mesh["faces"]);
  return result;
}

}  // namespace touchstone::catalogue
