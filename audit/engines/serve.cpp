// SPDX-License-Identifier: Apache-2.0
#include "audit/engines/serve.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <vector>

namespace touchstone::audit {
namespace {

/// Complete lines of standard input; `before_waiting` is called when the next line is not available yet.
class InputLines {
 public:
  template <class BeforeWaiting>
  bool next(std::string& line, const BeforeWaiting& before_waiting) {
    std::size_t end;
    while ((end = inbox_.find('\n', begin_)) == std::string::npos) {
      inbox_.erase(0, begin_);
      begin_ = 0;
      before_waiting();
      char piece[1 << 16];
      const ssize_t count = ::read(STDIN_FILENO, piece, sizeof piece);
      if (count > 0) inbox_.append(piece, static_cast<std::size_t>(count));
      if (count == 0 || (count < 0 && errno != EINTR)) return false;
    }
    line.assign(inbox_, begin_, end - begin_);
    begin_ = end + 1;
    return true;
  }

 private:
  std::string inbox_;
  std::size_t begin_ = 0;
};

void write_all(int descriptor, std::string& outbox) {
  constexpr std::size_t most_at_once = std::size_t{1} << 30;  // Windows counts in 32 bits
  std::size_t written = 0;
  while (written < outbox.size()) {
    const auto size = static_cast<unsigned>(std::min(outbox.size() - written, most_at_once));
    const ssize_t count = ::write(descriptor, outbox.data() + written, size);
    if (count > 0) written += static_cast<std::size_t>(count);
    if (count < 0 && errno != EINTR) break;
  }
  outbox.clear();
}

/// Parses a question by the codec if its line is not in the program's own form.
Question read_slowly(const Served& engine, const std::string& line, std::string& id, const ServedOperation*& asked) {
  const Json question = parse_line(line);
  if (!question.is_object()) throw InvalidInput("line", "one JSON object");
  for (const char* field : {"id", "op", "input"}) {
    if (!question.contains(field)) throw InvalidInput(field, "missing");
  }
  if (!is_typed_number(question["id"])) throw InvalidInput("id", "number");
  if (!question["op"].is_string()) throw InvalidInput("op", "text");
  id = question["id"].get_ref<const std::string&>().substr(1);
  const auto found = engine.operations.find(question["op"].get_ref<const std::string&>());
  asked = found == engine.operations.end() ? nullptr : &found->second;
  return asked != nullptr ? asked->operation.parse(question["input"]) : Question{};
}

void append_answer_line(const Served& engine, const std::string& line, std::string& outbox) {
  std::string id = "0";
  Json rest = Json::object();
  try {
    Question question;
    const ServedOperation* asked = nullptr;
    const auto parts = split_question_line(line);
    if (const auto found = parts ? engine.operations.find(parts->operation) : engine.operations.end();
        found != engine.operations.end() && found->second.text.read(parts->input, question)) {
      id = parts->id;
      asked = &found->second;
    } else {
      question = read_slowly(engine, line, id, asked);
    }
    if (auto answer = asked != nullptr ? asked->answer(question) : std::nullopt) {
      rest["answer"] = std::move(*answer);
    } else {
      rest["unsupported"] = true;
    }
  } catch (const std::exception& thrown) {
    rest = {{"error", thrown.what()}};
  } catch (...) {
    rest = {{"error", "an exception that is no std::exception"}};
  }
  outbox += R"({"id":)";
  outbox += id;
  outbox += ',';
  outbox += one_line(rest).substr(1);
  outbox += '\n';
}

}  // namespace

int serve(const Served& engine) {
  const int output = dup(STDOUT_FILENO);
  if (output < 0 || dup2(STDERR_FILENO, STDOUT_FILENO) < 0) {
    std::perror("standard output");
    return 1;
  }
  InputLines input;
  std::string line, outbox;
  const auto flush = [&] { write_all(output, outbox); };
  if (!input.next(line, [] {})) return 0;
  outbox = written_hello(engine.hello);
  while (input.next(line, flush)) append_answer_line(engine, line, outbox);
  close(output);
  return 0;
}

}  // namespace touchstone::audit
