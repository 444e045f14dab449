// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <cstdlib>

#include "audit/engines/adapter.h"

namespace touchstone::audit {

/// Whether a verdict stops the fuzzing: a finding, or one of the verdicts that the environment names with commas.
inline bool stops_fuzzing(Verdict verdict) {
  static const char* const only = std::getenv("TOUCHSTONE_FUZZ_ONLY");
  if (only == nullptr || *only == 0) return is_finding(verdict);
  const std::string names = "," + std::string(only) + ",", name = "," + std::string(name_of(verdict)) + ",";
  return verdict != Verdict::agree && names.find(name) != std::string::npos;
}

/// One libFuzzer input: its first byte chooses the family, the others are the choices that draw a question of it.
/// Aborts with one line where the engine's answer is a finding (with TOUCHSTONE_FUZZ_ONLY=algorithm,invalid: one of these). A crash of the engine is libFuzzer's to report.
template <class Engine, class Row>
int fuzz_engine(const unsigned char* bytes, std::size_t size) {
  static Engine engine{};
  static const Declaration declaration = declaration_of<Engine>();
  static const Operation& operation = *find_operation(Row::card().name);
  Choices choices = Choices::replayed({bytes, size});
  const std::size_t family = choices.below(operation.families().size());
  Question question = operation.draw(choices, family);
  if (declaration.binary32) question = operation.in_binary32(question);
  std::unique_ptr<Examination> examination;
  try {
    examination = operation.examine(question);
  } catch (const InvalidInput&) {
    return -1;  // outside the contract: not to be kept in the corpus
  }
  Judgement judgement;
  Json answer;
  try {
    const auto said = ask_engine<Row>(engine, question);
    if (!said) return -1;
    answer = *said;
    // Read back as if it had come through the pipe: the judge takes numbers as they were written.
    judgement = examination->judge_engine(parse_line(one_line(answer)), declaration);
  } catch (const std::exception& thrown) {
    judgement = {Verdict::invalid, 0, thrown.what()};
  }
  if (!stops_fuzzing(judgement.verdict)) return 0;
  std::fprintf(stderr, "%s: %s (%s%s%s) on %s: it says %s, the truth is %s\n", declaration.engine.c_str(),
               operation.card().name, name_of(judgement.verdict), judgement.remark.empty() ? "" : ": ",
               judgement.remark.c_str(), one_line(operation.print_hexadecimal(question)).c_str(),
               one_line(answer).c_str(), one_line(examination->truth()).c_str());
  std::abort();
}

}  // namespace touchstone::audit

/// A libFuzzer target that looks for a wrong answer of the engine to one operation.
#define TOUCHSTONE_ENGINE_FUZZ(EngineType, operation)                                                       \
  extern "C" int LLVMFuzzerTestOneInput(const unsigned char* bytes, std::size_t size) {                     \
    return ::touchstone::audit::fuzz_engine<EngineType, ::touchstone::audit::rows::operation>(bytes, size); \
  }
