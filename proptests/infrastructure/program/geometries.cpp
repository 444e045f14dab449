// SPDX-License-Identifier: Apache-2.0
#include "program/commands/geometries.h"

#include "proptests/infrastructure/program/called.h"
#include "proptests/uses.h"

/// Questions in WKT and GeoJSON.
namespace touchstone::proptests::geometries_tests {
namespace {

std::string input_of_wkt(const std::string& operation, const std::string& line) {
  return one_line(find_operation(operation)->print(
      find_operation(operation)->parse(input_of(*find_operation(operation), geometries_of_wkt(line), Json::object()))));
}
std::string input_of_geojson(const std::string& operation, const std::string& text) {
  return one_line(find_operation(operation)->print(find_operation(operation)->parse(
      input_of(*find_operation(operation), geometries_of_geojson(text), Json::object()))));
}

/// What the program says of a line, its exit code being that of bad input.
std::string refusal(const char* operation, const char* option, const std::string& text) {
  const TextFile file("geometries", text);
  const Called asked = called({"ask", operation, option, file.path()});
  CHECK(asked.code == bad_usage);
  CHECK(std::count(asked.err.begin(), asked.err.end(), '\n') == 1);
  const std::string begin = "touchstone: " + std::string(file.path()) + ": line 1: ";
  CHECK_THAT(asked.err, StartsWith(begin));
  return asked.err.substr(begin.size(), asked.err.size() - begin.size() - 1);
}

}  // namespace

TEST_CASE("geometries: WKT fills the fields in their order, numbers as they were typed") {
  CHECK(input_of_wkt("point_in_polygon", "POLYGON ((0 0, 4 0, 4 4, 0 0)); POINT (1 3)") ==
        R"({"polygon":[[0,0],[4,0],[4,4],[0,0]],"point":[1,3]})");
  CHECK(input_of_wkt("polygon_polygon", "polygon((0 0,1 0,0 1,0 0));POLYGON ((5 5 , 6 5,\t5 6 , 5 5) ) ; ") ==
        R"({"a":[[0,0],[1,0],[0,1],[0,0]],"b":[[5,5],[6,5],[5,6],[5,5]]})");
  CHECK(input_of_wkt("segment_segment", "LINESTRING (0 0, +2 .5); LineString(-.25 1e2, 3. 4.e1)") ==
        R"({"a":[[0,0],[2,0.5]],"b":[[-0.25,100],[3,40]]})");
  CHECK(input_of_wkt("segment_segment", "LINESTRING (0 0, +.5 +1.); LINESTRING (0 0, 1 1)") ==
        R"({"a":[[0,0],[0.5,1]],"b":[[0,0],[1,1]]})");
  CHECK(input_of_wkt("polygon_normal", "POLYGON Z ((0 0 5, 1 0 5, 1 1 5, 0 0 5))") ==
        R"({"polygon":[[0,0,5],[1,0,5],[1,1,5],[0,0,5]]})");
  CHECK(input_of_wkt("polygon_normal", "POLYGONZ((0 0 5, 1 0 5, 1 1 5))") ==
        R"({"polygon":[[0,0,5],[1,0,5],[1,1,5]]})");
  const std::string points = R"({"points":[[0,0],[1,0],[0,1]]})";
  CHECK(input_of_wkt("convex_hull_2d", "MULTIPOINT ((0 0), (1 0), (0 1))") == points);
  CHECK(input_of_wkt("convex_hull_2d", "MULTIPOINT (0 0, 1 0, 0 1)") == points);
}

TEST_CASE("geometries: GeoJSON of every kind, on one line or many") {
  const std::string polygon = R"({"type":"Polygon","coordinates":[[[0,0],[4,0],[4,4],[0,0]]]})",
                    point = R"({"coordinates":[1,3],"type":"Point"})",
                    both = R"({"polygon":[[0,0],[4,0],[4,4],[0,0]],"point":[1,3]})";
  CHECK(input_of_geojson("polygon_convexity", polygon) == R"({"polygon":[[0,0],[4,0],[4,4],[0,0]]})");
  CHECK(input_of_geojson("polygon_convexity", R"({"type":"Feature","properties":null,"geometry":)" + polygon + "}") ==
        R"({"polygon":[[0,0],[4,0],[4,4],[0,0]]})");
  CHECK(input_of_geojson("point_in_polygon",
                         R"({"type":"GeometryCollection","geometries":[)" + polygon + "," + point + "]}") == both);
  CHECK(input_of_geojson("point_in_polygon",
                         R"({"type":"FeatureCollection","features":[{"type":"Feature","geometry":)" + polygon +
                             R"(},{"type":"Feature","id":7,"geometry":)" + point + "}]}") == both);
  const std::string pretty =
      "{\n  \"type\": \"Polygon\", \"note\": \"}\\\"]\",\n  \"coordinates\":\n[[[0,0],[4,0],[4,4]]]}";
  const TextFile file("pretty.geojson", pretty + "\n\n" + polygon + "\n");
  const Called asked = called({"ask", "polygon_convexity", "--geojson", file.path()});
  CHECK(asked.code == nothing_found);
  CHECK(std::count(asked.out.begin(), asked.out.end(), '\n') == 2);
  CHECK_THAT(asked.out, ContainsSubstring(R"("input":{"polygon":[[0,0],[4,0],[4,4]]})") &&
                            ContainsSubstring(R"("input":{"polygon":[[0,0],[4,0],[4,4],[0,0]]})"));
}

TEST_CASE("geometries: kinds that differ come in any order, and a MultiPolygon of one is that polygon") {
  const std::string both = R"({"polygon":[[0,0],[4,0],[4,4],[0,0]],"point":[1,3]})";
  CHECK(input_of_wkt("point_in_polygon", "POINT (1 3); MULTIPOLYGON (((0 0, 4 0, 4 4, 0 0)))") == both);
  const std::string feature = R"({"type":"Feature","geometry":{"type":)";
  CHECK(input_of_geojson("point_in_polygon",
                         R"({"type":"FeatureCollection","features":[)" + feature + R"("Point","coordinates":[1,3]}},)" +
                             feature + R"("MultiPolygon","coordinates":[[[[0,0],[4,0],[4,4],[0,0]]]]}}]})") == both);
}

TEST_CASE("geometries: text without its option is refused with the option that was probably meant") {
  const std::pair<const char*, const char*> texts[] = {
      {"POLYGON ((0 0,9 0,9 9,0 0))", "--wkt"},
      {"srid=4326;POLYGON ((0 0,9 0,9 9,0 0))", "--wkt"},
      {R"({"type":"Polygon","coordinates":[[[0,0],[9,0],[9,9]]]})", "--geojson"},
      {R"({"type":"Feature","geometry":null})", "--geojson"}};
  for (const auto& [text, option] : texts) {
    const TextFile file("without", text);
    require_refused(called({"ask", "polygon_convexity", file.path()}), bad_usage,
                    std::string("(did you mean ") + option + "?)");
  }
  const TextFile file("without", "{\"polygon\":1}");
  CHECK_THAT(called({"ask", "polygon_convexity", file.path()}).err, !ContainsSubstring("did you mean"));
}

TEST_CASE("geometries: decimals as typed, and a mesh beside a point") {
  const TextFile line("typed.wkt", "POINT (0.3 0.1); LINESTRING (0 0, 0.9 0.3)\n");
  const Called typed = called({"ask", "point_on_segment", "--wkt", "--as-typed", line.path()});
  CHECK(typed.code == nothing_found);
  CHECK_THAT(typed.out, ContainsSubstring(R"("as_typed":{"truth":{"relation":"on","t":"1/3"}})"));
  const TextFile solid("solid.off", "OFF\n4 4 0\n0 0 0\n4 0 0\n0 4 0\n0 0 4\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
  const TextFile point("point.wkt", "POINT Z (1 1 1)\n");
  const std::string mesh = std::string("mesh=") + solid.path();
  const Called asked = called({"ask", "point_in_convex_polyhedron", "--mesh", mesh.c_str(), "--wkt", point.path()});
  CHECK(asked.code == nothing_found);
  CHECK_THAT(asked.out, ContainsSubstring(R"("truth":{"location":"inside"})"));
}

TEST_CASE("geometries: what no field takes is refused in one line that names it") {
  CHECK(refusal("polygon_convexity", "--wkt", "POLYGON ((0 0,9 0,9 9,0 0),(2 1,3 1,3 2,2 1))") ==
        "polygon: a hole is not supported yet: ask about the outer ring and about each hole as polygons of their own");
  CHECK(refusal("polygon_convexity", "--wkt", "MULTIPOLYGON (((0 0,9 0,9 9,0 0)),((2 0,3 0,3 1,2 0)))") ==
        "polygon: one Polygon, got a MultiPolygon of 2: ask about each part on its own");
  CHECK(refusal("polygon_convexity", "--wkt", "MULTIPOLYGON (((0 0,9 0,9 9,0 0),(2 1,3 1,3 2,2 1)))")
            .starts_with("polygon: a hole is not supported yet: "));
  CHECK(refusal("polygon_convexity", "--wkt", "MULTILINESTRING ((0 0,9 0))") ==
        "polygon: expected a Polygon, got MULTILINESTRING");
  CHECK(refusal("polygon_convexity", "--wkt", "SRID=4326;POLYGON ((0 0,9 0,9 9,0 0))") ==
        "line: WKT: drop SRID=4326; at column 1: coordinates are taken as they are");
  CHECK(refusal("polygon_convexity", "--wkt", "POLYGON Z ((0 0 1,9 0 1,9 9 1,0 0 1))") ==
        "polygon: x and y alone, for its shape is in the plane: drop the third coordinate");
  CHECK(refusal("polygon_convexity", "--wkt", "POLYGON ((0 0,9 0 1,9 9,0 0))") ==
        "polygon: x and y alone, for its shape is in the plane: drop the third coordinate");
  CHECK(refusal("polygon_normal", "--wkt", "POLYGON ((0 0,9 0,9 9,0 0))") ==
        "polygon: x, y and z: its shape is in space");
  CHECK(refusal("polygon_normal", "--wkt", "POLYGON ZM ((0 0 1 1,9 0 1 1,9 9 1 1))") ==
        "line: WKT: expected no M coordinates at column 1");
  CHECK(refusal("polygon_convexity", "--wkt", "POLYGON EMPTY") == "polygon: at least 3 vertices");
  CHECK(refusal("polygon_normal", "--wkt", "POLYGON Z EMPTY") == "polygon: at least 3 vertices");
  CHECK(refusal("point_in_polygon", "--wkt", "POLYGON ((0 0,9 0,9 9,0 0))") ==
        "line: a geometry for each field (polygon, point), got 1");
  CHECK(refusal("point_in_polygon", "--wkt", "POINT (0 0); POINT (0 0)") == "polygon: expected a Polygon, got Point");
  CHECK(refusal("sphere_sphere", "--wkt", "POINT (0 0); POINT (0 0)") ==
        "a: no geometry of WKT or GeoJSON is of its shape");
  CHECK(refusal("segment_segment", "--wkt", "LINESTRING (0 0,1 1,2 2); LINESTRING (0 0,1 1)") ==
        "a: two positions, got 3");
  CHECK(refusal("polygon_convexity", "--wkt", "POLYGON ((0 0,9 x,9 9,0 0))") ==
        "line: WKT: expected a number at column 17");
  CHECK(refusal("polygon_convexity", "--wkt", "POLYGON ((0 0,9 1-2,9 9,0 0))").starts_with("polygon[1][1]: "));
  CHECK(refusal("polygon_convexity", "--wkt", "POLYGON ((0 0,9 .,9 9,0 0))").starts_with("polygon[1][1]: "));
  CHECK(refusal("polygon_convexity", "--wkt", "POLYGON ((0 0,9 1e999,9 9,0 0))") == "polygon[1][1]: finite number");
  CHECK(refusal("polygon_convexity", "--wkt", "POLYGON ((0 0,9 0,9 9,0 0)") == "line: WKT: expected ) at column 27");
  CHECK(refusal("polygon_convexity", "--wkt", "{\"polygon\":[]}") ==
        "line: WKT: expected the name of a geometry at column 1");
  CHECK(refusal("polygon_convexity", "--wkt", "POLYGON ((0 0,9 0,9 9,0 0)) 5") ==
        "line: WKT: expected a semicolon or the end of the line at column 29");
  CHECK(refusal("polygon_convexity", "--geojson",
                R"({"type":"Polygon","coordinates":[[[0,0],[9,0],[9,9]],[[2,1],[3,1],[3,2]]]})") ==
        "polygon: a hole is not supported yet: ask about the outer ring and about each hole as polygons of their own");
  CHECK(refusal("polygon_convexity", "--geojson", R"({"type":"Polygon","coordinates":[[[0,0,1],[9,0,1],[9,9,1]]]})") ==
        "polygon: x and y alone, for its shape is in the plane: drop the third coordinate");
  CHECK(refusal("polygon_convexity", "--geojson", R"({"type":"MultiPolygon","coordinates":[]})") ==
        "polygon: one Polygon, got a MultiPolygon of 0: ask about each part on its own");
  CHECK(refusal("polygon_convexity", "--geojson", R"({"type":"Feature","geometry":null})").starts_with("geometry: "));
  CHECK(refusal("polygon_convexity", "--geojson",
                R"({"type":"FeatureCollection","features":[{"type":"Feature","geometry":null}]})")
            .starts_with("features[0].geometry: "));
  CHECK(refusal("polygon_convexity", "--geojson", R"({"type":"Polygon"})") ==
        "polygon: an object of GeoJSON with \"coordinates\"");
  CHECK(refusal("polygon_convexity", "--geojson", "[[0,0],[9,0]]").starts_with("line: "));
  CHECK(refusal("polygon_convexity", "--geojson", "{\"type\":\"Polygon\",\n") == "line: one JSON object");
  const TextFile file("both", "{}");
  CHECK(called({"ask", "polygon_convexity", "--wkt", "--geojson", file.path()}).code == bad_usage);
}

}  // namespace touchstone::proptests::geometries_tests
