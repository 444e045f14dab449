// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "audit/uses.h"
#include "catalogue/operation/operation.h"

/// Questions in WKT and GeoJSON: a geometry for each field of the operation, in the order of the fields.
namespace touchstone::audit {

/// The geometries of a line of WKT, separated by semicolons, in the form of GeoJSON. Throws InvalidInput naming the
/// column.
Json geometries_of_wkt(const std::string& line);

/// The geometries of one GeoJSON text, which is a geometry, a GeometryCollection, a Feature or a FeatureCollection;
/// properties and other members are skipped. Throws InvalidInput naming the position.
Json geometries_of_geojson(const std::string& text);

/// The input with these geometries as its fields, except those that are already given: in the order of the fields, or
/// in any order if all fields accept different kinds. A point accepts a Point, a list of points a MultiPoint, a segment
/// or line a LineString, a polygon a Polygon without holes or a MultiPolygon of one,
/// in space with Z, and a region one with holes. Throws
/// InvalidInput naming the field.
Json input_of(const Operation& operation, const Json& geometries, const Json& given);

/// The input of a question in text: JSON, or WKT or GeoJSON if one of these is selected. `meshes`: fields from mesh
/// files. Throws InvalidInput.
Json input_in(const std::string& text, bool wkt, bool geojson, const Operation& operation, const Json& meshes);

/// The option for text that looks like WKT or GeoJSON: "--wkt", "--geojson"; otherwise "".
std::string option_for(const std::string& text);

/// The nesting depth of a JSON text after the lines so far.
class OpenBrackets {
 public:
  void read(const std::string& line);
  bool none() const { return depth_ <= 0; }

 private:
  int depth_ = 0;
};

}  // namespace touchstone::audit
