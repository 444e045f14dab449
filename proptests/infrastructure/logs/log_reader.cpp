// SPDX-License-Identifier: Apache-2.0
#include "audit/logs/log_reader.h"

#include <sstream>

#include "proptests/catch.h"
#include "proptests/infrastructure/logs/read_log.h"

namespace touchstone::proptests::log_reader_tests {
namespace {

using namespace audit;
using Kind = RecordedAnswer::Kind;

const std::string header = R"({"touchstone_log":1,"engine":"game","number":"binary32"})"
                           "\n";
const std::string on =
    R"({"op":"orientation","input":{"p0":[0,0],"p1":[1,0],"p":[2,0]},"answer":{"side":"on"},"site":"a.c:1"})"
    "\n";
const std::string end = R"({"end":{"seen":3,"written":2,"sampled_out":1,"lost":0}})"
                        "\n";

std::string in_binary(const std::string& lines) {
  const ReadLog log(lines);
  std::ostringstream out;
  const auto to = binary_writer(out);
  if (log.account.logs > 0) to->header(log.account.header);
  for (const RecordedCall& call : log.calls) to->write(call, log.account.sites[call.site]);
  if (log.account.cut < log.account.logs) to->end(log.account.end);
  else to->flush();
  return out.str();
}

TEST_CASE("log reader: header, calls and end mark are read from either form") {
  for (const std::string& bytes : {header + on + on + end, in_binary(header + on + on + end)}) {
    const ReadLog log(bytes);
    REQUIRE(log.calls.size() == 2);
    REQUIRE(log.calls[1].ordinal == 1);
    REQUIRE(log.calls[1].operation->name() == "orientation");
    REQUIRE(log.calls[1].question == Question{{0, 0, 1, 0, 2, 0}, {}});
    REQUIRE(log.calls[1].answer.kind == Kind::whole);
    REQUIRE(log.calls[1].answer.value.words == std::vector<Word>{1});  // left, on, right
    REQUIRE(log.calls[1].binary32);
    REQUIRE(log.account.sites[log.calls[1].site] == "a.c:1");
    REQUIRE(log.account.header.declaration.engine == "game");
    REQUIRE(log.account.end == LogEnd{3, 2, 1, 0});
    REQUIRE(log.account.remarks.empty());
    REQUIRE(log.account.cut == 0);
  }
}

TEST_CASE("log reader: a log without its end mark was cut, which is told, and its calls are read") {
  for (const std::string& bytes : {header + on + on, in_binary(header + on + on)}) {
    const ReadLog log(bytes);
    REQUIRE(log.calls.size() == 2);
    REQUIRE(log.account.cut == 1);
    REQUIRE(log.account.remarks.size() == 1);
    REQUIRE_THAT(log.account.remarks[0], ContainsSubstring("no end mark"));
  }
}

TEST_CASE("log reader: wherever a log is cut, the calls before the cut are read, and the incomplete record is told") {
  const std::string lines = header + on + on + end, binary = in_binary(lines);
  for (const std::string& bytes : {lines, binary}) {
    std::size_t most = 0;
    for (std::size_t size = 8; size < bytes.size(); ++size) {
      if (bytes[0] == '{' && size < header.size()) continue;  // half a header is no log
      INFO(size << " of " << bytes.size());
      const ReadLog log(bytes.substr(0, size));
      REQUIRE(log.calls.size() >= most);
      most = log.calls.size();
      REQUIRE((log.account.cut == 1 || log.account.logs == 0 || bytes[size] == '\n'));
      if (bytes[0] == '{') REQUIRE(most == std::min<std::size_t>(2, (size + 1 - header.size()) / on.size()));
    }
    REQUIRE(most == 2);
  }
}

TEST_CASE("log reader: a line that no operation takes is counted by reason and costs nothing else") {
  const ReadLog log(R"({"op":"orientatoin","input":{},"answer":true})"
                    "\n"
                    R"({"op":"orientation","input":{"p0":[0,0],"p1":[1,0]},"answer":true})"
                    "\n"
                    R"({"op":"orientation","input":{"p0":[0,0],"p1":[1]},"answer":true})"
                    "\n"
                    R"({"op":"orientation","input":{"p0":[0,0],"p1":[1,"x"],"p":[2,0]},"answer":true})"
                    "\n"
                    R"({"op":"orientation","input":{"p0":[0,0],"p1":[1,"y"],"p":[2,0]},"answer":true})"
                    "\n"
                    R"({"op":"orientation","input":{"p0":[0,0],"p1":[1,0],"p":[2,0]}})"
                    "\n"
                    "no JSON\n\n" +
                    on);
  REQUIRE(log.calls.size() == 1);
  REQUIRE(log.account.logs == 0);
  REQUIRE(log.account.remarks.empty());
  const auto of = [&](const std::string& part) {
    std::uint64_t count = 0;
    for (const auto& [reason, refused] : log.account.refused)
      if (reason.find(part) != reason.npos) count += refused.count;
    return count;
  };
  REQUIRE(of("orientatoin: no operation of the catalogue (did you mean \"orientation\"?)") == 1);
  REQUIRE(of("missing") == 2);
  REQUIRE(of("expected an array of 2") == 1);
  REQUIRE(of("expected a number") == 2);
  std::uint64_t all = 0;
  for (const auto& [reason, refused] : log.account.refused) all += refused.count;
  REQUIRE(all == 7);
  REQUIRE(log.account.refused.at("missing").first == ":2: p: missing");
}

TEST_CASE("log reader: a call of an operation that nobody knows is counted in the binary form too") {
  std::string bytes = in_binary(header + on + on + end);
  bytes.replace(bytes.find("orientation"), 11, "orientatoin");
  const ReadLog log(bytes);
  REQUIRE(log.calls.empty());
  REQUIRE(log.account.refused.size() == 1);
  REQUIRE(log.account.refused.begin()->second.count == 2);
}

TEST_CASE("log reader: a log of another version is refused by name") {
  REQUIRE_THROWS_WITH(ReadLog(R"({"touchstone_log":2})"
                              "\n"),
                      EndsWith("expected version 1 of the log, got version 2"));
  std::string bytes = in_binary(header + on + end);
  bytes[binary_magic.size()] = 7;
  REQUIRE_THROWS_WITH(ReadLog(bytes), EndsWith("expected version 1 of the log, got version 7"));
}

TEST_CASE("log reader: damaged bytes cost what cannot be read, which is told or counted") {
  const std::string bytes = in_binary(header + on + on + end);
  for (std::size_t i = binary_magic.size() + 1; i < bytes.size(); ++i) {
    for (const int flipped : {0x01, 0x40, 0x80, 0xff}) {
      INFO("byte " << i << " flipped by " << flipped);
      std::string damaged = bytes;
      damaged[i] = static_cast<char>(damaged[i] ^ flipped);
      const ReadLog log(damaged);
      REQUIRE(log.calls.size() <= 2);
      REQUIRE((log.calls.size() == 2 || !log.account.remarks.empty() || !log.account.refused.empty()));
    }
  }
}

TEST_CASE("log reader: gzip and zstd are read by their first bytes, and a cut one is told") {
  for (const std::string program : {"gzip", "zstd"}) {
    const TextFile lines("lines", header + on + on + end), packed("packed", "");
    if (std::system(("command -v " + program + " > /dev/null").c_str()) != 0) continue;
    REQUIRE(std::system((program + " -q -c " + lines.path() + " > " + packed.path()).c_str()) == 0);
    LogReader log(packed.path());
    RecordedCall call;
    REQUIRE((log.next(call) && log.next(call) && !log.next(call)));
    REQUIRE(log.account().end.seen == 3);
    std::filesystem::resize_file(packed.path(), std::filesystem::file_size(packed.path()) - 12);
    LogReader cut(packed.path());
    while (cut.next(call)) continue;
    REQUIRE_FALSE(cut.account().remarks.empty());
  }
}

TEST_CASE("log reader: the end marks of several logs in one file are added up") {
  const ReadLog log(header + on +
                    R"({"end":{"seen":5,"written":1,"sampled_out":2,"lost":2}})"
                    "\n" +
                    header + on + end);
  REQUIRE(log.account.logs == 2);
  REQUIRE(log.account.end == LogEnd{8, 3, 3, 2});
  REQUIRE(log.calls.size() == 2);
}

TEST_CASE("log reader: a call has an answer or an error, not both") {
  const ReadLog log(R"({"op":"orientation","input":{"p0":[0,0],"p1":[1,0],"p":[2,0]},"answer":true,"error":"none"})"
                    "\n");
  REQUIRE(log.calls.empty());
  REQUIRE(log.account.refused.size() == 1);
}

TEST_CASE("log reader: a question with words that its operation does not have is refused in the binary form too") {
  const auto frame = [](char kind, const std::string& text) {
    return std::string(1, kind) + static_cast<char>(text.size()) + text;
  };
  for (const int words : {0, 1}) {
    const ReadLog log(std::string(binary_magic) + '\x01' +
                      frame('D', R"({"id":0,"op":"orientation","answer":"plain","question_size":[)" +
                                     std::to_string(words) + ",6]}") +
                      frame('C', std::string(1 + words + 48, '\0') + '\x01'));
    REQUIRE(log.calls.size() == (words == 0 ? 1 : 0));
    REQUIRE(log.account.refused.size() == (words == 0 ? 0 : 1));
  }
}

}  // namespace
}  // namespace touchstone::proptests::log_reader_tests
