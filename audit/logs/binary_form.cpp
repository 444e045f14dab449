// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>

#include "audit/logs/little_endian.h"
#include "audit/logs/log_form.h"
#include "catalogue/codec/expected.h"

namespace touchstone::audit {
namespace {

/// The counts of words and numbers of a value, if all calls of a declaration have the same.
struct Size {
  std::size_t words = 0, numbers = 0;
};

/// The meaning of one identifier: calls of one operation at one place with one kind of answer.
struct DeclaredSite {
  const Operation* operation = nullptr;  ///< nullptr: `refusal` says why its calls are not read
  std::optional<InvalidInput> refusal;
  std::size_t answer = 0;  ///< index in answer_names
  std::size_t site = 0;
  bool binary32 = false, stored_as_floats = false;
  std::optional<Size> question, answer_size;
  bool that_fits = false;  ///< values do not tell which alternative they are: the first that fits
  bool checked = false;    ///< every question has the right numbers and no words
};

std::optional<Size> read_size(const Json& declaration, const char* field) {
  if (!declaration.contains(field)) return std::nullopt;
  require_array(declaration[field], field, 2);
  return Size{read_index(declaration[field][0], field), read_index(declaration[field][1], field)};
}

template <std::size_t n>
std::size_t place_of(const Json& declaration, const char* field, const char* const (&names)[n]) {
  const Json& value = declaration.contains(field) ? declaration[field] : Json(nullptr);
  for (std::size_t i = 0; i < n; ++i) {
    if (value == names[i]) return i;
  }
  std::string rule;
  for (const char* name : names) rule += (rule.empty() ? "one of " : ", ") + std::string(name);
  throw InvalidInput(field, expected(rule, value));
}

std::string text_at(const Json& declaration, const char* field) {
  if (!declaration.contains(field)) return "";
  if (!declaration[field].is_string()) throw InvalidInput(field, expected("text", declaration[field]));
  return declaration[field].get<std::string>();
}

class BinaryForm : public LogForm {
 public:
  BinaryForm(std::string file, ByteSource& source, LogAccount& account) : LogForm(std::move(file), source, account) {}

  bool next(RecordedCall& call) override {
    while (true) {
      while (!at_.empty()) {
        const std::size_t before = at_.size();
        try {
          if (read_call(call)) return true;
        } catch (const InvalidInput& wrong) {
          refuse(place(before), wrong);
        } catch (const IncompleteBytes& missing) {
          remark(place(before), cut_ ? "the last record is incomplete"
                                     : std::string(missing.what()) + ": the rest of this block is not read");
          at_ = {};
        }
      }
      if (!next_frame()) {
        end_file(!stopped_);
        return false;
      }
    }
  }

 private:
  std::string place(std::size_t left) const { return ": byte " + std::to_string(source_.position() - left); }

  /// Reads everything before the calls of the next block. Returns false at the end.
  bool next_frame() {
    cut_ = false;
    if (stopped_ || source_.peek(1).empty()) return false;
    if (source_.peek(binary_magic.size()).substr(0, binary_magic.size()) == binary_magic) return begin_file();
    const std::string_view head = source_.peek(1 + longest_varint);
    std::string_view rest = head.substr(1);
    std::uint64_t size = 0;
    try {
      size = take_varint(rest);
    } catch (const IncompleteBytes&) {
      source_.skip(head.size());
      remark(place(0), "the last record is incomplete");
      return false;
    }
    if (size > ByteSource::most_bytes) return stop(place(0), "damaged: a block of " + std::to_string(size) + " bytes");
    const std::size_t begin = head.size() - rest.size();
    const auto kind = static_cast<Frame>(head[0]);
    at_ = source_.peek(begin + size).substr(begin);
    cut_ = at_.size() < size;
    at_ = at_.substr(0, size);
    source_.skip(begin + at_.size());
    if (kind == Frame::calls) return true;
    if (cut_) {
      remark(place(0), "the last record is incomplete");
      return at_ = {}, true;
    }
    const std::string text(at_);
    const std::string where = place(at_.size());
    at_ = {};
    return read_text_frame(kind, text, where);
  }

  bool stop(const std::string& where, const std::string& why) {
    remark(where, why + "; the rest of the log is not read");
    stopped_ = true;
    return false;
  }

  bool begin_file() {
    const std::string_view first = source_.peek(binary_magic.size() + 1);
    if (first.size() <= binary_magic.size()) throw LogError(file_, "the log ends before its version");
    const int version = static_cast<unsigned char>(first[binary_magic.size()]);
    if (version != log_version)
      throw LogError(file_, "expected version " + std::to_string(log_version) + " of the log, got version " +
                                std::to_string(version));
    source_.skip(binary_magic.size() + 1);
    declared_.clear();
    return true;
  }

  bool read_text_frame(Frame kind, const std::string& text, const std::string& where) {
    try {
      const Json json = parse_line(text);
      switch (kind) {
        case Frame::header: return begin_log(read_log_header(json)), true;
        case Frame::end: return end_log(read_log_end(json)), true;
        case Frame::declaration: return declare(json), true;
        default: return stop(where, "damaged: neither a header nor a declaration nor calls nor an end mark");
      }
    } catch (const InvalidInput& wrong) {
      return stop(where, std::string("damaged: ") + wrong.what());
    }
  }

  void declare(const Json& json) {
    require_fields(json, "",
                   {"id", "op", "site", "number", "stored", "answer", "question_size", "answer_size", "alternative"});
    const std::uint32_t id = read_index(json.contains("id") ? json["id"] : Json(nullptr), "id");
    if (id > most_declared) throw InvalidInput("id", "at most " + std::to_string(most_declared));
    DeclaredSite site;
    site.answer = place_of(json, "answer", answer_names);
    site.binary32 =
        json.contains("number") ? place_of(json, "number", number_names) == 1 : account_.header.declaration.binary32;
    site.stored_as_floats = json.contains("stored") ? place_of(json, "stored", number_names) == 1 : site.binary32;
    site.question = read_size(json, "question_size");
    site.answer_size = read_size(json, "answer_size");
    constexpr const char* alternatives[] = {"that_fits"};
    site.that_fits = json.contains("alternative") && place_of(json, "alternative", alternatives) == 0;
    try {
      site.site = site_of(text_at(json, "site"));
      site.operation = &recorded_operation(text_at(json, "op"));
      if (site.answer == word_alone) recorded_word(*site.operation, 0);
      const Shape& shape = site.operation->question_shape();
      site.checked = site.question && shape.fixed && shape.word_count == 0 && site.question->words == 0 &&
                     site.question->numbers == shape.numbers;
    } catch (const InvalidInput& wrong) {
      site.refusal = wrong;
      site.operation = nullptr;
    }
    if (declared_.size() <= id) declared_.resize(id + 1);
    declared_[id] = std::move(site);
  }

  void take_value(const std::optional<Size>& declared, bool floats, EncodedValue<double>& value) {
    const std::uint64_t words = declared ? declared->words : take_varint(at_);
    const std::uint64_t numbers = declared ? declared->numbers : take_varint(at_);
    const std::size_t bytes = floats ? 4 : 8;
    // Each word takes at least a byte: no memory is allocated for missing data.
    if (words > at_.size() || numbers > at_.size() / bytes) throw IncompleteBytes("fewer bytes than the record says");
    value.words.resize(words);
    for (Word& word : value.words) word = static_cast<Word>(take_varint(at_));
    value.numbers.resize(numbers);
    take_numbers(at_, floats, value.numbers.data(), numbers);
  }

  /// Returns false if no operation takes the call, which is counted.
  bool read_call(RecordedCall& call) {
    const std::uint64_t id = take_varint(at_);
    if (id >= declared_.size() || !declared_[id]) throw IncompleteBytes("damaged: a call that is not declared");
    const DeclaredSite& site = *declared_[id];
    RecordedAnswer& answer = call.answer;
    take_value(site.question, site.stored_as_floats, call.question);
    answer.text.clear();
    if (site.answer == word_alone || site.answer == static_cast<std::size_t>(RecordedAnswer::Kind::plain)) {
      answer.value.numbers.clear();
      answer.value.words.assign(1, static_cast<Word>(take_varint(at_)));
    } else if (is_text(site.answer)) {
      answer.value.clear();
      const std::uint64_t size = take_varint(at_);
      if (size > at_.size()) throw IncompleteBytes("fewer bytes than the record says");
      answer.text = at_.substr(0, size);
      at_.remove_prefix(size);
    } else {
      take_value(site.answer_size, site.stored_as_floats, answer.value);
    }
    if (site.operation == nullptr) throw InvalidInput(*site.refusal);
    call.operation = site.operation;
    call.site = site.site;
    call.binary32 = site.binary32;
    const Shape& shape = site.operation->question_shape();
    if (site.that_fits) say_alternative(shape, call.question);
    if (!site.checked) require_shape(shape, call.question.words, call.question.numbers.size(), "input");
    finish(site, answer);
    return true;
  }

  static bool is_text(std::size_t answer) {
    return answer == static_cast<std::size_t>(RecordedAnswer::Kind::text) ||
           answer == static_cast<std::size_t>(RecordedAnswer::Kind::error);
  }

  /// Determines its kind, once the bytes are read.
  static void finish(const DeclaredSite& site, RecordedAnswer& answer) {
    if (site.answer == word_alone) {
      answer = recorded_word(*site.operation, answer.value.words[0]);
      return;
    }
    answer.kind = static_cast<RecordedAnswer::Kind>(site.answer);
    switch (answer.kind) {
      case RecordedAnswer::Kind::plain:
        if (answer.value.words[0] > 1) throw InvalidInput("answer", "true or false: 1 or 0");
        return;
      case RecordedAnswer::Kind::whole:
      case RecordedAnswer::Kind::partial:
        if (site.that_fits) say_alternative(site.operation->answer_shape(), answer.value);
        return require_shape(site.operation->answer_shape(), answer.value.words, answer.value.numbers.size(), "answer",
                             answer.kind == RecordedAnswer::Kind::partial);
      case RecordedAnswer::Kind::text: parse_line(answer.text); return;
      case RecordedAnswer::Kind::error: return;
    }
  }

  static constexpr std::uint32_t most_declared = 1 << 20;
  std::vector<std::optional<DeclaredSite>> declared_;
  std::string_view at_;  ///< the rest of a block of calls
  bool stopped_ = false;
  bool cut_ = false;  ///< the file ends in that block
};

}  // namespace

std::unique_ptr<LogForm> binary_form(std::string file, ByteSource& source, LogAccount& account) {
  return std::make_unique<BinaryForm>(std::move(file), source, account);
}

}  // namespace touchstone::audit
