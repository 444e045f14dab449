// SPDX-License-Identifier: Apache-2.0
#include "audit/text/geometries.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>

#include "catalogue/codec/excerpt.h"
#include "catalogue/codec/expected.h"

namespace touchstone::audit {
namespace {

std::string shown(const std::string& text) { return excerpt(text, most_of_a_key); }

/// The parts of GeoJSON, each named by its path in refusals.
const Json& part(const Json& value, const std::string& path, const char* name) {
  if (!value.is_object()) throw InvalidInput(path, expected("an object of GeoJSON", value));
  const auto found = value.find(name);
  if (found == value.end()) throw InvalidInput(path, std::string("an object of GeoJSON with \"") + name + "\"");
  return *found;
}

void collect(const Json& value, const std::string& path, Json& geometries) {
  const Json& type = part(value, path, "type");
  const auto all = [&](const char* name) {
    const Json& list = part(value, path, name);
    if (!list.is_array()) throw InvalidInput(path, expected(std::string("a list \"") + name + "\"", list));
    for (std::size_t i = 0; i < list.size(); ++i)
      collect(list[i], std::string(name) + "[" + std::to_string(i) + "]", geometries);
  };
  if (type == "FeatureCollection") all("features");
  else if (type == "GeometryCollection") all("geometries");
  else if (type == "Feature")
    collect(part(value, path, "geometry"), path == "line" ? "geometry" : path + ".geometry", geometries);
  else if (!type.is_string()) throw InvalidInput(path, expected("a type of GeoJSON", type));
  else geometries.push_back(value);
}

/// The geometry that a field accepts.
struct Wanted {
  std::string type;
  std::size_t axes = 0;
  bool holes = false;
};

Wanted wanted_by(const Shape& shape) {
  static constexpr std::array<std::array<const char*, 2>, 5> types{{{"Point", "Point"},
                                                                     {"Segment", "LineString"},
                                                                     {"Line", "LineString"},
                                                                     {"Polygon", "Polygon"},
                                                                     {"Region", "Polygon"}}};
  if (shape.kind == Shape::Kind::list) {
    const Wanted one = wanted_by(*shape.parts[0].shape);
    return one.type == "Point" ? Wanted{"MultiPoint", one.axes} : Wanted{};
  }
  for (const std::size_t axes : {2, 3}) {
    for (const auto& [name, type] : types) {
      if (shape.name == name + std::to_string(axes) + "<double>") return {type, axes, shape.name.starts_with("Region")};
    }
  }
  return {};
}

/// Positions have as many numbers as the shape has axes.
void require_axes(const Json& coordinates, std::size_t axes, const std::string& field) {
  if (!coordinates.is_array() || coordinates.empty()) return;  // refused by the field's shape
  if (coordinates[0].is_array()) {
    for (const Json& inner : coordinates) require_axes(inner, axes, field);
  } else if (coordinates.size() > axes) {
    throw InvalidInput(field, axes == 2 ? "x and y alone, for its shape is in the plane: drop the third coordinate"
                                        : "x, y and z alone");
  } else if (coordinates.size() == 2 && axes == 3) {
    throw InvalidInput(field, "x, y and z: its shape is in space");
  }
}

/// The only polygon of a MultiPolygon.
Json only_part(const Json& geometry, const std::string& field) {
  const Json& parts = part(geometry, field, "coordinates");
  if (!parts.is_array() || parts.size() != 1)
    throw InvalidInput(field, "one Polygon, got a MultiPolygon of " + std::to_string(parts.size()) +
                                  ": ask about each part on its own");
  Json polygon = Json::object();
  polygon["type"] = "Polygon", polygon["coordinates"] = parts[0];
  return polygon;
}

Json value_of(const Json& geometry, const Shape& shape, const std::string& field) {
  const Wanted wanted = wanted_by(shape);
  if (wanted.type.empty()) throw InvalidInput(field, "no geometry of WKT or GeoJSON is of its shape");
  const std::string type = geometry["type"].get<std::string>();
  if (type == "MultiPolygon" && wanted.type == "Polygon") return value_of(only_part(geometry, field), shape, field);
  if (type != wanted.type) throw InvalidInput(field, "expected a " + wanted.type + ", got " + shown(type));
  const Json& coordinates = part(geometry, field, "coordinates");
  require_axes(coordinates, wanted.axes, field);
  if (wanted.type == "LineString" && coordinates.is_array() && coordinates.size() != 2 && !coordinates.empty())
    throw InvalidInput(field, "two positions, got " + std::to_string(coordinates.size()));
  if (wanted.type != "Polygon" || !coordinates.is_array() || coordinates.empty()) return coordinates;
  if (wanted.holes) {
    Json region = Json::object(), holes = Json::array();
    for (std::size_t i = 1; i < coordinates.size(); ++i) holes.push_back(coordinates[i]);
    region["outer"] = coordinates[0], region["holes"] = holes;
    return region;
  }
  if (coordinates.size() > 1)
    throw InvalidInput(
        field, "no hole: point_in_region and region_region take polygons with holes");
  return coordinates[0];
}

/// In the order of the fields, if each field accepts a kind that no other accepts, and there is one geometry of each;
/// otherwise unchanged.
Json in_order_of(const std::vector<const Shape::Part*>& fields, const Json& geometries) {
  Json ordered = Json::array();
  std::set<std::string> kinds;
  for (const Shape::Part* field : fields) {
    const std::string wanted = wanted_by(*field->shape).type;
    if (!kinds.insert(wanted).second) return geometries;
    const auto fits = [&](const Json& geometry) {
      const auto& type = geometry["type"];
      return type == wanted || (wanted == "Polygon" && type == "MultiPolygon");
    };
    if (std::count_if(geometries.begin(), geometries.end(), fits) != 1) return geometries;
    ordered.push_back(*std::find_if(geometries.begin(), geometries.end(), fits));
  }
  return ordered;
}

Json input_of_fields(const Shape& question, const Json& geometries, const Json& given) {
  Json input = given;
  std::string names;
  std::size_t next = 0;
  std::vector<const Shape::Part*> fields;
  for (const Shape::Part& field : question.parts) {
    if (given.contains(field.name)) continue;
    names += (names.empty() ? "" : ", ") + std::string(field.name);
    fields.push_back(&field);
  }
  if (fields.size() != geometries.size()) {
    throw InvalidInput("line", "a geometry for each field (" + names + "), got " + std::to_string(geometries.size()));
  }
  const Json ordered = in_order_of(fields, geometries);
  for (const Shape::Part* field : fields) input[field->name] = value_of(ordered[next++], *field->shape, field->name);
  return input;
}

}  // namespace

Json geometries_of_geojson(const std::string& text) {
  Json geometries = Json::array();
  collect(parse_line(text), "line", geometries);
  return geometries;
}

/// Among several alternatives the first that accepts the geometries; if none does, the error says why.
Json input_of(const Operation& operation, const Json& geometries, const Json& given) {
  const Shape& question = operation.question_shape();
  if (question.kind != Shape::Kind::choice) return input_of_fields(question, geometries, given);
  for (std::size_t i = 0; i + 1 < question.parts.size(); ++i) {
    try {
      return input_of_fields(*question.parts[i].shape, geometries, given);
    } catch (const InvalidInput&) {
    }
  }
  return input_of_fields(*question.parts.back().shape, geometries, given);
}

Json input_in(const std::string& text, bool wkt, bool geojson, const Operation& operation, const Json& meshes) {
  if (wkt) return input_of(operation, geometries_of_wkt(text), meshes);
  if (geojson) return input_of(operation, geometries_of_geojson(text), meshes);
  Json input = parse_line(text);
  if (!meshes.empty() && input.is_object()) input.update(meshes);
  return input;
}

std::string option_for(const std::string& text) {
  const std::size_t start = std::min(text.find_first_not_of(" \t\r\n"), text.size());
  std::string begin = text.substr(start, 20);
  for (char& c : begin) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  for (const char* word : {"POINT", "LINESTRING", "POLYGON", "MULTI", "GEOMETRYCOLLECTION", "SRID="})
    if (begin.starts_with(word)) return "--wkt";
  if (text.find("\"type\"") == std::string::npos) return "";
  for (const char* type : {"\"Point\"", "\"LineString\"", "\"Polygon\"", "\"MultiP", "\"Feature", "\"GeometryC"})
    if (text.find(type) != std::string::npos) return "--geojson";
  return "";
}

void OpenBrackets::read(const std::string& line) {
  bool in_string = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (in_string && c == '\\') ++i;
    else if (c == '"') in_string = !in_string;
    else if (!in_string && (c == '{' || c == '[')) ++depth_;
    else if (!in_string && (c == '}' || c == ']')) --depth_;
  }
}

}  // namespace touchstone::audit
