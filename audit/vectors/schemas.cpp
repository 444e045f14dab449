// SPDX-License-Identifier: Apache-2.0
#include "audit/vectors/schemas.h"

#include <algorithm>
#include <cstring>

#include "audit/vectors/flags.h"

namespace touchstone::audit {
namespace {

constexpr const char* draft = "https://json-schema.org/draft/2020-12/schema";
// The same forms as in oracle/certificates/check_surd.h.
constexpr const char* rational = "-?(0|[1-9][0-9]*)(/[1-9][0-9]*)?";
constexpr const char* root =
    "([+-]?(0|[1-9][0-9]*)(/[1-9][0-9]*)?(?=[+-]))?[+-]?([1-9][0-9]*(/[1-9][0-9]*)?\\*)?sqrt\\([1-9][0-9]*\\)";

Json reference_to(const std::string& definition) { return {{"$ref", "#/$defs/" + definition}}; }

/// An object with these members and no others.
Json closed_object(const Json& properties, const std::vector<std::string>& required) {
  Json schema = Json::object();
  schema["type"] = "object";
  schema["properties"] = properties;
  schema["required"] = required;
  schema["additionalProperties"] = false;
  return schema;
}

/// The values of a shape, with numbers in the given definition; in inputs a mesh may be the name of a file.
Json schema_of(const Shape& shape, const std::string& number, bool input) {
  Json schema = Json::object();
  switch (shape.kind) {
    case Shape::Kind::number: return reference_to(number);
    case Shape::Kind::word: schema["enum"] = shape.words; return schema;
    case Shape::Kind::flag: schema["type"] = "boolean"; return schema;
    case Shape::Kind::index:
      schema["type"] = "integer";
      schema["minimum"] = 0;
      return schema;
    case Shape::Kind::optional: return schema_of(*shape.parts[0].shape, number, input);
    case Shape::Kind::list:
      schema["type"] = "array";
      schema["items"] = schema_of(*shape.parts[0].shape, number, input);
      return schema;
    case Shape::Kind::choice:
      for (const Shape::Part& part : shape.parts) schema["anyOf"].push_back(schema_of(*part.shape, number, input));
      return schema;
    case Shape::Kind::record: break;
  }
  if (shape.form == Form::bare) return schema_of(*shape.parts[0].shape, number, input);
  if (shape.form == Form::list) {
    schema["type"] = "array";
    for (const Shape::Part& part : shape.parts) schema["prefixItems"].push_back(schema_of(*part.shape, number, input));
    schema["items"] = false;
    schema["minItems"] = shape.parts.size();
    return schema;
  }
  Json properties = Json::object();
  std::vector<std::string> required;
  bool mesh = false;
  for (const Shape::Part& part : shape.parts) {
    properties[part.name] = schema_of(*part.shape, number, input);
    if (part.shape->kind != Shape::Kind::optional) required.emplace_back(part.name);
    mesh = mesh || std::strcmp(part.name, "faces") == 0;
  }
  if (shape.form == Form::mesh) {
    properties["cut"] = std::move(properties["faces"]);
    properties["faces"] = std::move(properties["polygons"]);
    properties["faces"]["items"]["minItems"] = 3;
    properties.erase("polygons"), required.pop_back();
  }
  schema = closed_object(properties, required);
  if (!input || !mesh) return schema;
  return {{"anyOf", Json::array({schema, reference_to("named_mesh")})}};
}

Json answer_schema(const Operation& operation, const std::string& number) {
  Json bare = schema_of(operation.answer_shape(), number, false);
  const std::string name = operation.metadata().answer;
  if (name.empty()) return bare;
  return closed_object({{name, std::move(bare)}}, {name});
}

Json pattern(const std::string& text) { return {{"type", "string"}, {"pattern", "^" + text + "$"}}; }

Json numbers() {
  Json defs = Json::object();
  defs["finite"] = {{"type", "number"}};
  defs["any_number"] = {{"anyOf", Json::array({reference_to("finite"), {{"enum", {"inf", "-inf", "nan"}}}})}};
  defs["double"] = {{"description", "The nearest double, ties to even; infinite beyond the range."},
                    {"anyOf", Json::array({reference_to("finite"), {{"enum", {"inf", "-inf"}}}})}};
  defs["rational"] = pattern(rational);
  defs["exact"] = pattern("(" + std::string(rational) + "|" + root + ")");
  defs["named_mesh"] = pattern("meshes/[a-z0-9_]+\\.json");
  defs["certificate"] = {{"type", "object"},
                         {"properties", {{"kind", pattern("[a-z_]+")}}},
                         {"required", {"kind"}},
                         {"additionalProperties", {{"type", "array"}, {"items", reference_to("fact")}}}};
  defs["fact"] = {{"anyOf", Json::array({reference_to("rational"), reference_to("certificate")})}};
  return defs;
}

/// The members of every line of the operation.
Json common_members(const Operation& operation, const std::vector<std::string>& families) {
  Json members = Json::object();
  members["touchstone"]["const"] = vector_version;
  members["id"] = pattern(operation.name() + "/[0-9a-f]{" + std::to_string(digits_of_id) + "}");
  members["op"]["const"] = operation.name();
  members["family"]["enum"] = families;
  return members;
}

Json answered(const Operation& operation) {
  Json members = common_members(operation, operation.families());
  members["input"] = schema_of(operation.question_shape(), "finite", true);
  members["truth"] = answer_schema(operation, "exact");
  members["rounded"] = answer_schema(operation, "double");
  if (operation.metadata().margin_degree != 0) members["margin"] = reference_to("rational");
  members["certificate"] = reference_to("certificate");
  Json flags = Json::array();
  for (const Flag& flag : vector_flags) {
    if (std::strcmp(flag.name, "refused") != 0) flags.push_back(flag.name);
  }
  members["flags"] = {{"type", "array"}, {"items", {{"enum", flags}}}, {"uniqueItems", true}};
  members["as_typed"] = answer_schema(operation, "exact");
  return closed_object(members,
                       {"touchstone", "id", "op", "family", "input", "truth", "rounded", "certificate", "flags"});
}

Json refused(const Operation& operation) {
  std::vector<std::string> families = operation.families();
  families.emplace_back(not_finite_family);
  Json members = common_members(operation, families);
  members["input"] = schema_of(operation.question_shape(), "any_number", true);
  const Json text{{"type", "string"}, {"minLength", 1}};
  members["refused"] = closed_object({{"field", text}, {"rule", text}}, {"field", "rule"});
  members["flags"]["const"] = {"refused"};
  return closed_object(members, {"touchstone", "id", "op", "family", "input", "refused", "flags"});
}

}  // namespace

Json vector_schema() {
  Json flags = Json::object();
  for (const Flag& flag : vector_flags) flags[flag.name] = {{"meaning", flag.meaning}, {"effect", flag.effect}};
  Json schema = Json::object();
  schema["$schema"] = draft;
  schema["title"] = "touchstone test vector";
  schema["description"] =
      "One JSON object a line; schemas/OPERATION.json says strictly what a line of an operation is. Exact numbers are "
      "\"p/q\" or \"p\", or roots \"p+q*sqrt(r)\"; of sines, cosines and angles a fraction within 2^-60 units in the "
      "last place stands there, and bounds in the certificate, of the kind \"enclosure\"; where nothing is decided "
      "there is no margin; input numbers are the doubles that the decimals "
      "round to. "
      "`rounded` is the truth with every number the nearest double, ties to even; where those are no right answer, "
      "because slabs are rounded outwards, what robust answers. In the family \"not_finite\" an "
      "input number is "
      "\"inf\", \"-inf\" or \"nan\". An input field \"meshes/NAME.json\" stands for the mesh in that file, "
      "relative to the file of vectors: {\"vertices\":[[x,y,z],..],\"faces\":[[i,j,k],..]}.";
  schema["type"] = "object";
  schema["required"] = {"touchstone", "id", "op", "family", "input", "flags"};
  schema["oneOf"] =
      Json::array({Json{{"required", {"truth", "rounded", "certificate"}}}, Json{{"required", {"refused"}}}});
  schema["properties"]["touchstone"]["const"] = vector_version;
  for (const char* name : {"id", "op", "family", "margin"}) schema["properties"][name]["type"] = "string";
  for (const char* name : {"input", "truth", "rounded", "certificate", "refused", "as_typed"})
    schema["properties"][name]["type"] = "object";
  schema["properties"]["flags"]["type"] = "array";
  schema["flags"] = flags;
  return schema;
}

Json vector_schema(const Operation& operation, bool recorded) {
  Json schema = Json::object();
  schema["$schema"] = draft;
  schema["title"] = "touchstone test vector: " + operation.name();
  schema["description"] =
      std::string(operation.metadata().question) + " What the fields and flags mean: ../schema.json.";
  schema["if"] = {{"required", {"refused"}}};
  schema["then"] = reference_to("refused");
  schema["else"] = reference_to("answered");
  schema["$defs"] = numbers();
  schema["$defs"]["answered"] = answered(operation);
  schema["$defs"]["refused"] = refused(operation);
  if (recorded) schema["$defs"]["answered"]["properties"]["family"] = {{"const", recorded_family}};
  return schema;
}

}  // namespace touchstone::audit
