// SPDX-License-Identifier: Apache-2.0
#include "audit/logs/recorded_call.h"

#include <algorithm>

#include "audit/engines/protocol.h"
#include "catalogue/codec/expected.h"
#include "catalogue/codec/plain.h"

namespace touchstone::audit {
namespace {

/// Copies a partial reading without the flags that tell whether a number is present. Returns false if one is missing.
bool completed(const Shape& shape, Cursor<double>& at, bool partial, EncodedValue<double>& whole) {
  const auto all_parts = [&](bool partial_too) {
    return std::all_of(shape.parts.begin(), shape.parts.end(),
                       [&](const Shape::Part& part) { return completed(*part.shape, at, partial_too, whole); });
  };
  switch (shape.kind) {
    case Shape::Kind::number:
      if (partial && *at.word++ == 0) return false;
      whole.numbers.push_back(*at.number++);
      return true;
    case Shape::Kind::record: return all_parts(partial && shape.form != Form::mesh);
    default: break;
  }
  const Word word = *at.word++;
  whole.words.push_back(word);
  switch (shape.kind) {
    case Shape::Kind::optional: return word == 0 || completed(*shape.parts[0].shape, at, partial, whole);
    case Shape::Kind::choice: return completed(*shape.parts[word].shape, at, partial, whole);
    case Shape::Kind::list:
      for (Word i = 0; i < word; ++i) {
        if (!completed(*shape.parts[0].shape, at, partial, whole)) return false;
      }
      return true;
    default: return true;
  }
}

/// The JSON of a partial reading; null if it is empty.
Json json_of_partial(const Shape& shape, Cursor<double>& at) {
  switch (shape.kind) {
    case Shape::Kind::number: return *at.word++ != 0 ? written(*at.number++) : Json(nullptr);
    case Shape::Kind::optional: {
      if (*at.word++ == 0) return nullptr;
      Json value = json_of_partial(*shape.parts[0].shape, at);
      return value.is_null() ? Json::object() : value;
    }
    case Shape::Kind::choice: {
      const Word which = *at.word++;
      return json_of_partial(*shape.parts[which].shape, at);
    }
    case Shape::Kind::list: {
      Json list = Json::array();
      for (Word left = *at.word++; left > 0; --left) list.push_back(json_of_partial(*shape.parts[0].shape, at));
      return list;
    }
    case Shape::Kind::record: break;
    default: return catalogue::json_of<double>(shape, at, [](const double& number) { return written(number); });
  }
  if (shape.form == Form::mesh)
    return catalogue::json_of<double>(shape, at, [](const double& number) { return written(number); });
  if (shape.form == Form::bare) return json_of_partial(*shape.parts[0].shape, at);
  Json record = shape.form == Form::list ? Json::array() : Json::object();
  bool any = false;
  for (const Shape::Part& part : shape.parts) {
    Json value = json_of_partial(*part.shape, at);
    any = any || !value.is_null();
    if (shape.form == Form::list) record.push_back(std::move(value));
    else if (!value.is_null()) record[part.name] = std::move(value);
  }
  return any || shape.parts.empty() ? record : Json(nullptr);
}

/// The reading position in words and numbers that may be too few.
struct Supply {
  const Word *word, *end;
  std::size_t numbers;
};

bool take(const Shape& shape, Supply& from, bool partial) {
  const auto take_word = [&from](std::size_t below) { return from.word != from.end && *from.word++ < below; };
  switch (shape.kind) {
    case Shape::Kind::number:
      if (partial && !take_word(2)) return false;
      return (partial && from.word[-1] == 0) || (from.numbers != 0 && from.numbers-- != 0);
    case Shape::Kind::word: return take_word(shape.words.size());
    case Shape::Kind::flag: return take_word(2);
    case Shape::Kind::index: return take_word(std::size_t{1} << 32);
    case Shape::Kind::optional:
      return take_word(2) && (from.word[-1] == 0 || take(*shape.parts[0].shape, from, partial));
    case Shape::Kind::choice:
      return take_word(shape.parts.size()) && take(*shape.parts[from.word[-1]].shape, from, partial);
    case Shape::Kind::list:
      if (!take_word(std::size_t{1} << 32)) return false;
      for (Word left = from.word[-1]; left > 0; --left) {
        if (!take(*shape.parts[0].shape, from, partial)) return false;
      }
      return true;
    case Shape::Kind::record: break;
  }
  return std::all_of(shape.parts.begin(), shape.parts.end(), [&](const Shape::Part& part) {
    return take(*part.shape, from, partial && shape.form != Form::mesh);
  });
}

std::uint64_t read_count(const Json& json, const char* field) {
  constexpr double most = 0x1p53;
  const double count = json.contains(field) ? read_double(json[field], field) : 0;
  if (!(count >= 0 && count <= most && count == static_cast<double>(static_cast<std::uint64_t>(count))))
    throw InvalidInput(member_path("end", field), expected("a count", json[field]));
  return static_cast<std::uint64_t>(count);
}

bool fits(const Shape& shape, const std::vector<Word>& words, std::size_t numbers, bool partial) {
  Supply from{words.data(), words.data() + words.size(), numbers};
  return take(shape, from, partial) && from.word == from.end && from.numbers == 0;
}

/// Appends a missing value of a shape, if it can be omitted.
void leave_out(const Shape& shape, std::vector<Word>& words) {
  if (shape.kind != Shape::Kind::record) return words.push_back(0);
  for (const Shape::Part& part : shape.parts) leave_out(*part.shape, words);
}

}  // namespace

RecordedAnswer recorded_answer(const Operation& operation, const Json& answer) {
  RecordedAnswer recorded;
  if (answer.is_boolean()) {
    recorded.value.words.push_back(answer.get<bool>() ? 1 : 0);
    return recorded;
  }
  const Shape& shape = operation.answer_shape();
  const char* const name = operation.metadata().answer;
  const bool named = name[0] != 0;
  try {
    if (!answer.is_object()) throw InvalidInput("answer", expected("an object", answer));
    if (named && (answer.size() != 1 || !answer.contains(name))) throw InvalidInput(name, "missing");
    EncodedValue<double> partial;
    read_json<double>(shape, named ? answer[name] : answer, "answer", partial, read_answer_number, true);
    recorded.kind = RecordedAnswer::Kind::whole;
    Cursor<double> at(partial);
    if (completed(shape, at, true, recorded.value)) return recorded;
    recorded.kind = RecordedAnswer::Kind::partial;
    recorded.value = std::move(partial);
  } catch (const InvalidInput&) {
    recorded = {RecordedAnswer::Kind::text, {}, one_line(plain(answer))};
  }
  return recorded;
}

RecordedAnswer recorded_word(const Operation& operation, Word word) {
  const Shape& shape = operation.answer_shape();
  RecordedAnswer partial;
  partial.kind = RecordedAnswer::Kind::partial;
  std::size_t enumerators = 0;
  const auto append = [&](const Shape& part) {
    if (part.kind == Shape::Kind::word) {
      if (++enumerators == 1 && word >= part.words.size())
        throw InvalidInput("answer", "one of " + std::to_string(part.words.size()) + " enumerators, counted from 0");
      partial.value.words.push_back(word);
    } else if (can_be_left_out(part, true)) {
      leave_out(part, partial.value.words);
    } else {
      enumerators = 2;
    }
  };
  if (shape.kind != Shape::Kind::record) append(shape);
  else
    for (const Shape::Part& part : shape.parts) append(*part.shape);
  if (enumerators != 1)
    throw InvalidInput("answer", "no enumerator alone: " + one_line(operation.answer_description()));
  RecordedAnswer whole;
  whole.kind = RecordedAnswer::Kind::whole;
  Cursor<double> at(partial.value);
  return completed(shape, at, true, whole.value) ? whole : partial;
}

Json answer_json(const Operation& operation, const RecordedAnswer& answer) {
  // The judge takes numbers as parse_line leaves them.
  const auto as_read = [](const Json& json) { return parse_line(one_line(json)); };
  switch (answer.kind) {
    case RecordedAnswer::Kind::plain: return answer.value.words[0] != 0;
    case RecordedAnswer::Kind::whole: return as_read(operation.answer_json(answer.value));
    case RecordedAnswer::Kind::text: return parse_line(answer.text);
    case RecordedAnswer::Kind::error: return nullptr;
    case RecordedAnswer::Kind::partial: break;
  }
  Cursor<double> at(answer.value);
  Json bare = json_of_partial(operation.answer_shape(), at);
  if (bare.is_null()) bare = Json::object();
  const char* const name = operation.metadata().answer;
  if (name[0] == 0) return as_read(bare);
  Json named = Json::object();
  named[name] = std::move(bare);
  return as_read(named);
}

Reply reply_of(const RecordedCall& call) {
  Reply reply;
  if (call.answer.kind == RecordedAnswer::Kind::error)
    reply.kind = Reply::Kind::failed, reply.remark = call.answer.text;
  else reply.answer = answer_json(*call.operation, call.answer);
  return reply;
}

void require_shape(const Shape& shape, const std::vector<Word>& words, std::size_t numbers, const char* field,
                   bool partial) {
  if (!fits(shape, words, numbers, partial))
    throw InvalidInput(field, "expected the numbers and words of " + one_line(catalogue::json_of(shape)));
}

void say_alternative(const Shape& shape, EncodedValue<double>& value) {
  const auto takes = [&value](const Shape& part) { return fits(part, value.words, value.numbers.size(), false); };
  if (shape.kind != Shape::Kind::choice || takes(shape)) return;
  Word which = 0;
  for (const Shape::Part& part : shape.parts) {
    if (takes(*part.shape)) break;
    ++which;
  }
  value.words.insert(value.words.begin(), which);
}

LogHeader read_log_header(const Json& fields) {
  if (!fields.is_object() || !fields.contains("touchstone_log"))
    throw InvalidInput("touchstone_log", "missing: the version of the log");
  const double version = read_double(fields["touchstone_log"], "touchstone_log");
  if (version != log_version)
    throw InvalidInput("touchstone_log", "expected version " + std::to_string(log_version) +
                                             " of the log, got version " + decimal(version));
  LogHeader header;
  Json hello = fields;
  hello.erase("touchstone_log");
  hello.erase("sampled");
  if (!hello.contains("engine")) hello["engine"] = "";
  hello["ops"] = Json::array();
  Hello read = read_hello(one_line(plain(hello)));
  if (!read.remarks.empty()) throw InvalidInput("header", read.remarks[0]);
  header.declaration = std::move(read.declaration);
  header.fields = plain(fields);
  return header;
}

LogEnd read_log_end(const Json& fields) {
  require_fields(fields, "end", {"seen", "written", "sampled_out", "lost"});
  return {read_count(fields, "seen"), read_count(fields, "written"), read_count(fields, "sampled_out"),
          read_count(fields, "lost")};
}

Json json_of(const LogEnd& end) {
  return {{"seen", end.seen}, {"written", end.written}, {"sampled_out", end.sampled_out}, {"lost", end.lost}};
}

}  // namespace touchstone::audit
