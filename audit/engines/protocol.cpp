// SPDX-License-Identifier: Apache-2.0
#include "audit/engines/protocol.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "catalogue/codec/did_you_mean.h"
#include "catalogue/codec/excerpt.h"
#include "catalogue/codec/expected.h"

namespace touchstone::audit {
namespace {

constexpr std::array<const char*, 3> boundary_words{"closed", "open", "unspecified"};
constexpr std::array<const char*, 2> number_words{"binary64", "binary32"}, pairs_words{"conservative", "exact"},
    nearest_words{"any", "named"};

template <std::size_t n>
std::size_t word_index(const Json& value, const char* field, const std::array<const char*, n>& words) {
  std::string rule;
  for (std::size_t i = 0; i < n; ++i) {
    if (value == words[i]) return i;
    rule += (i == 0 ? "one of " : ", ") + std::string(words[i]);
  }
  const bool text = value.is_string() && !is_typed_number(value);
  const std::vector<const char*> known(words.begin(), words.end());
  throw InvalidInput(field,
                     expected(rule, value) + (text ? did_you_mean(value.get_ref<const std::string&>(), known) : ""));
}

/// True if engines are asked an operation. They need not know a method, another formula for an operation.
bool is_asked(const Operation& operation) { return !operation.metadata().is_implementation(); }

/// Remarks on unknown names, which may be of a newer version, or misspelt; and on those of methods.
std::vector<std::string> remarks_on(const Json& hello) {
  static const std::vector<const char*> fields{"engine", "ops",     "number",     "boundary", "tolerance",
                                               "pairs",  "nearest", "skew_boxes", "polygons", "alternatives"};
  std::vector<std::string> remarks, known;
  for (const auto& [key, value] : hello.items()) {
    if (std::find(fields.begin(), fields.end(), key) == fields.end())
      remarks.push_back(excerpt(key, most_of_a_key) + ": no such field" + did_you_mean(key, fields) + ", ignored");
  }
  for (const Operation* operation : all_operations()) {
    if (is_asked(*operation)) known.push_back(operation->name());
  }
  for (const Json& entry : hello["ops"]) {
    const std::string& name = entry.get_ref<const std::string&>();
    const Operation* const found = find_operation(name);
    if (found == nullptr)
      remarks.push_back("ops: " + excerpt(name, most_of_a_key) + ": no operation of the catalogue" +
                        did_you_mean(name, known) + ", never asked");
    else if (!is_asked(*found)) remarks.push_back("ops: " + why_never_asked(*found));
  }
  return remarks;
}

/// {"ray_aabb":[1]}. Unknown names get a remark where the operations are listed.
void read_alternatives(const Json& json, Declaration& declaration) {
  if (!json.is_object()) throw InvalidInput("alternatives", expected("an object of lists", json));
  for (const auto& [name, answered] : json.items()) {
    const std::string field = unknown_path("alternatives", name);
    const Operation* const operation = find_operation(name);
    if (operation == nullptr) continue;
    const std::size_t count = operation->zeros_of_alternatives().size();
    const std::string rule = "a list of places in the alternatives, counted from 0";
    if (!answered.is_array()) throw InvalidInput(field, expected(rule, answered));
    for (const Json& place : answered) {
      const double which = is_typed_number(place) ? read_double(place, field) : -1;
      if (!(which >= 0 && which < static_cast<double>(count) && which == std::trunc(which)))
        throw InvalidInput(field, expected(rule, answered));
      declaration.alternatives[name].insert(static_cast<std::size_t>(which));
    }
  }
}

std::uint64_t read_id(const Json& id) {
  // A language with a single number type, or one that reads every number as a double, writes 262.0.
  if (is_typed_number(id)) {
    const double value = read_double(id, "id");
    if (value >= 0 && value <= 0x1p53 && value == std::trunc(value)) return static_cast<std::uint64_t>(value);
  }
  throw InvalidInput("id", expected("the number of a question", id));
}

}  // namespace

std::string boundary_word(Declaration::Boundary boundary) { return boundary_words[static_cast<std::size_t>(boundary)]; }

std::string pairs_word(Declaration::Pairs pairs) { return pairs_words[static_cast<std::size_t>(pairs)]; }

std::string nearest_word(Declaration::Nearest nearest) { return nearest_words[static_cast<std::size_t>(nearest)]; }

std::string why_never_asked(const Operation& implementation) {
  return implementation.name() + ": a method of " + implementation.metadata().implementation_of +
         ", which engines are asked instead";
}

std::string greeting() {
  Json line = Json::object();
  line["touchstone"] = 1;
  for (const Operation* operation : all_operations()) {
    if (is_asked(*operation)) line["ops"].push_back(operation->name());
  }
  return one_line(line) + "\n";
}

Hello read_hello(const std::string& line) {
  const Json json = parse_line(line);
  if (!json.is_object()) throw InvalidInput("line", expected("one JSON object", json));
  const auto text_of = [](const Json& value, const char* field) {
    if (!value.is_string() || is_typed_number(value)) throw InvalidInput(field, expected("text", value));
    return value.get<std::string>();
  };
  Hello hello;
  if (!json.contains("engine")) throw InvalidInput("engine", "missing");
  hello.declaration.engine = excerpt(text_of(json["engine"], "engine"), 200);
  if (!json.contains("ops")) throw InvalidInput("ops", "missing");
  if (!json["ops"].is_array()) throw InvalidInput("ops", expected("an array of names", json["ops"]));
  for (const Json& entry : json["ops"]) {
    const std::string name = text_of(entry, "ops");
    const Operation* const operation = find_operation(name);
    if (operation == nullptr || is_asked(*operation)) hello.operations.insert(name);
  }
  if (json.contains("boundary")) {
    hello.declaration.boundary =
        static_cast<Declaration::Boundary>(word_index(json["boundary"], "boundary", boundary_words));
  }
  if (json.contains("number")) hello.declaration.binary32 = word_index(json["number"], "number", number_words) == 1;
  if (json.contains("tolerance")) {
    hello.declaration.tolerance = read_double(json["tolerance"], "tolerance");
    if (hello.declaration.tolerance < 0) throw InvalidInput("tolerance", expected("a number >= 0", json["tolerance"]));
  }
  if (json.contains("pairs"))
    hello.declaration.pairs = static_cast<Declaration::Pairs>(word_index(json["pairs"], "pairs", pairs_words));
  if (json.contains("nearest"))
    hello.declaration.nearest =
        static_cast<Declaration::Nearest>(word_index(json["nearest"], "nearest", nearest_words));
  const auto read_ability = [&json](const char* name, bool& ability) {
    if (!json.contains(name)) return;
    if (!json[name].is_boolean()) throw InvalidInput(name, expected("true or false", json[name]));
    ability = json[name].get<bool>();
  };
  if (json.contains("alternatives")) read_alternatives(json["alternatives"], hello.declaration);
  read_ability("skew_boxes", hello.declaration.skew_boxes);
  read_ability("polygons", hello.declaration.polygons);
  hello.remarks = remarks_on(json);
  return hello;
}

std::string written_hello(const Hello& hello) {
  Json line = Json::object();
  line["engine"] = hello.declaration.engine;
  line["ops"] = hello.operations;
  line["number"] = number_words[hello.declaration.binary32 ? 1 : 0];
  line["boundary"] = boundary_word(hello.declaration.boundary);
  line["tolerance"] = written(hello.declaration.tolerance);
  if (hello.declaration.pairs != Declaration::Pairs::conservative) line["pairs"] = pairs_word(hello.declaration.pairs);
  if (hello.declaration.nearest != Declaration::Nearest::any) line["nearest"] = nearest_word(hello.declaration.nearest);
  if (hello.declaration.skew_boxes) line["skew_boxes"] = true;
  if (hello.declaration.polygons) line["polygons"] = true;
  if (!hello.declaration.alternatives.empty()) line["alternatives"] = hello.declaration.alternatives;
  return one_line(line) + "\n";
}

void append_question_line(std::uint64_t id, const Metadata& metadata, const QuestionText& text,
                          const Question& question, std::string& lines) {
  lines += R"({"id":)";
  lines += std::to_string(id);
  lines += R"(,"op":")";
  lines += metadata.name;
  lines += R"(","input":)";
  text.write(question, lines);
  lines += "}\n";
}

std::optional<QuestionLine> split_question_line(std::string_view line) {
  const auto take = [&](std::string_view literal) {
    const bool there = line.substr(0, literal.size()) == literal;
    if (there) line.remove_prefix(literal.size());
    return there;
  };
  const auto take_while = [&](auto belongs) {
    std::size_t size = 0;
    while (size < line.size() && belongs(line[size])) ++size;
    const std::string_view taken = line.substr(0, size);
    line.remove_prefix(size);
    return taken;
  };
  QuestionLine parts;
  if (!take(R"({"id":)")) return std::nullopt;
  parts.id = take_while([](char c) { return c >= '0' && c <= '9'; });
  if (parts.id.empty() || !take(R"(,"op":")")) return std::nullopt;
  parts.operation = take_while([](char c) { return c != '"' && c != '\\'; });
  if (!take(R"(","input":)") || line.empty() || line.back() != '}') return std::nullopt;
  line.remove_suffix(1);
  parts.input = line;
  return parts;
}

bool meant_as_answer(std::string_view line) {
  const auto skip_blanks = [&] { line.remove_prefix(std::min(line.find_first_not_of(" \t\r"), line.size())); };
  skip_blanks();
  if (line.empty() || line[0] != '{') return false;
  line.remove_prefix(1);
  skip_blanks();
  // Also in single quotes, as Python prints a dictionary.
  constexpr std::array<std::string_view, 6> fields{R"("id")", R"("answer")", R"("error")",
                                                   "'id'",    "'answer'",    "'error'"};
  return line.empty() || std::any_of(fields.begin(), fields.end(),
                                     [&](std::string_view field) { return line.find(field) != line.npos; });
}

Reply read_reply(Json object) {
  Reply reply;
  if (object.contains("answer")) {
    reply.answer = std::move(object["answer"]);
  } else if (object.contains("error")) {
    const Json& error = object["error"];
    reply.kind = Reply::Kind::failed;
    reply.remark = "error: " + excerpt(error.is_string() ? error.get_ref<const std::string&>() : one_line(error), 200);
  } else if (object.contains("unsupported") && object["unsupported"] == true) {
    reply.kind = Reply::Kind::unsupported;
  } else {
    reply.kind = Reply::Kind::failed;
    reply.remark = R"(neither "answer" nor "error" nor "unsupported")";
  }
  return reply;
}

AnswerLine read_answer_line(const std::string& line) {
  Json json = parse_line(line);
  if (!json.is_object()) throw InvalidInput("line", expected("one JSON object", json));
  if (!json.contains("id")) throw InvalidInput("id", "missing");
  const std::uint64_t id = read_id(json["id"]);
  return {id, read_reply(std::move(json))};
}

}  // namespace touchstone::audit
