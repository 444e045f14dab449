// SPDX-License-Identifier: Apache-2.0
#include "audit/engines/fuzz.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "audit/engines/serve.h"
#include "catalogue/operation/probes/fitted.h"

namespace touchstone::audit {
namespace {

/// The verdicts that stop the fuzzing: those named, separated by commas; by default the findings. Throws InvalidInput
/// if a name is not a verdict, or is agree: such a name would never stop anything.
class StoppingVerdicts {
 public:
  explicit StoppingVerdicts(const char* names) {
    std::stringstream list(names == nullptr ? "" : names);
    for (std::string name; std::getline(list, name, ',');) {
      const auto found = std::find(verdict_names.begin() + 1, verdict_names.end(), name);
      if (found == verdict_names.end())
        throw InvalidInput("TOUCHSTONE_FUZZ_ONLY", "verdicts separated by commas, not " + name);
      named_.push_back(static_cast<Verdict>(found - verdict_names.begin()));
    }
  }
  bool contain(Verdict verdict) const {
    return named_.empty() ? is_finding(verdict) : std::find(named_.begin(), named_.end(), verdict) != named_.end();
  }
  /// As named in the environment; the program ends if it names unknown ones.
  static StoppingVerdicts of_environment() {
    try {
      return StoppingVerdicts(std::getenv("TOUCHSTONE_FUZZ_ONLY"));
    } catch (const InvalidInput& wrong) {
      std::fprintf(stderr, "%s\n", wrong.what());
      std::_Exit(2);
    }
  }

 private:
  std::vector<Verdict> named_;
};

/// An engine as it is fuzzed, once for each.
struct FuzzedEngine {
  StoppingVerdicts stopping = StoppingVerdicts::of_environment();
  Served asked;

  static const FuzzedEngine& of(const EngineMembers& engine) {
    static std::map<const EngineMembers*, FuzzedEngine> all;
    const auto found = all.find(&engine);
    return found != all.end() ? found->second
                              : all.emplace(&engine, FuzzedEngine{.asked = served(engine)}).first->second;
  }
};

}  // namespace

int fuzz_member(const EngineMembers& engine, const char* operation_name, const unsigned char* bytes, std::size_t size) {
  const auto& [stopping, asked] = FuzzedEngine::of(engine);
  const Declaration& declaration = engine.declaration;
  const ServedOperation& member = asked.operations.at(operation_name);
  const Operation& operation = member.operation;
  DrawStream draws = DrawStream::replayed({bytes, size});
  const std::size_t family = draws.below(operation.families().size());
  Question question = operation.draw(draws, family);
  question = fitted(operation, question, declaration);
  std::unique_ptr<Examination> examination;
  try {
    examination = operation.examine(question);
  } catch (const InvalidInput&) {
    return -1;  // outside the contract: not for the corpus
  }
  Judgement judgement;
  Json answer;
  try {
    const auto said = member.answer(question);
    if (!said) return -1;
    answer = *said;
    // Parsed as if it had come through the pipe: the judge takes numbers as they were written.
    judgement = examination->judge_engine(parse_line(one_line(answer)), declaration);
  } catch (const std::exception& thrown) {
    judgement = {Verdict::invalid, 0, thrown.what()};
  }
  if (!stopping.contain(judgement.verdict)) return 0;
  std::fprintf(stderr, "%s: %s (%s%s%s) on %s: it says %s, the truth is %s\n", declaration.engine.c_str(),
               operation.metadata().name, name_of(judgement.verdict), judgement.remark.empty() ? "" : ": ",
               judgement.remark.c_str(), one_line(operation.print_hexadecimal(question)).c_str(),
               one_line(answer).c_str(), one_line(examination->truth()).c_str());
  std::abort();
}

}  // namespace touchstone::audit
