// SPDX-License-Identifier: Apache-2.0
#include "fuzz/driver/target.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>

#include "catalogue/judge/environment.h"
#include "catalogue/operation/judgement.h"
#include "catalogue/operation/probes/array_mismatch.h"
#include "catalogue/operation/probes/explained.h"

namespace touchstone::fuzz {
namespace {

std::unique_ptr<Target> chosen;

/// FNV-1a: the bytes of an input alone decide what else is done with it.
std::uint64_t scattered(Bytes data) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const std::uint8_t byte : data) hash = (hash ^ byte) * 0x100000001b3u;
  return hash ^ hash >> 29;
}

}  // namespace

const Target& target() { return *chosen; }

void choose_target(int& argc, char** argv) {
  const std::string by_name = std::filesystem::path(argv[0]).filename().string();
  const catalogue::Operation* operation = catalogue::find_operation(by_name);
  if (operation == nullptr && argc > 1 && (operation = catalogue::find_operation(argv[1])) != nullptr) {
    std::move(argv + 2, argv + argc + 1, argv + 1);
    --argc;
  }
  if (operation == nullptr) {
    std::fprintf(stderr, "usage: %s OPERATION ... (touchstone ops lists them)\n", argv[0]);
    std::_Exit(2);
  }
  chosen = std::make_unique<Target>(*operation);
}

void Target::decode(Bytes data, Question& question) const {
  if (data.empty()) {
    question = operation_.zeros(0);
  } else if (data[0] < operation_.families().size()) {
    catalogue::DrawStream draws = catalogue::DrawStream::replayed(data.subspan(1));
    question = operation_.draw(draws, data[0]);
  } else {
    fuzz::decode(operation_.question_shape(), data.subspan(1), data[0] == finite_numbers_follow, question);
  }
}

std::string Target::complaint(Bytes data) const {
  static thread_local Question question;
  decode(data, question);
  return judged(question, scattered(data));
}

/// If the decision can be had without numbers, only every 16th input is examined in full, and the certificate of every
/// 256th of those is checked; otherwise that of every 16th input: JSON is slower than everything else together.
std::string Target::judged(const Question& question, std::uint64_t hash) const {
  const catalogue::RowFunctions& row = operation_.row();
  const std::size_t environment = hash % 2 == 0 ? 0 : hash / 2 % catalogue::environment_count;
  const bool quick = row.decide_by_oracle != nullptr;
  const auto in_words = [&] { return " (" + catalogue::environment_name(environment) + ")"; };
  try {
    if (quick) {
      const catalogue::Word decision = row.decide(question, environment);
      if (decision != row.decide_by_oracle(question)) return "robust and oracle decide differently" + in_words();
      if (hash / 32 % 4 == 0) {
        const std::string wrong = catalogue::array_mismatch(operation_, question, decision, environment, hash >> 16);
        if (!wrong.empty()) return wrong + in_words();
      }
      if (hash / 32 % 16 != 0) return "";
    }
    const catalogue::Examination examination(operation_, question);
    const catalogue::Judgement judgement = examination.judge_robust(environment);
    if (judgement.verdict != catalogue::Verdict::agree)
      return "robust and oracle differ: " + std::string(name_of(judgement.verdict)) + " " + judgement.remark +
             in_words();
    if (!quick && row.batch.decide != nullptr) {
      const catalogue::Word decision = row.robust(question, environment).words.at(0);
      const std::string wrong = catalogue::array_mismatch(operation_, question, decision, environment, hash >> 16);
      if (!wrong.empty()) return wrong + in_words();
    }
    if (examination.margin()) {
      const std::size_t count = std::min<std::size_t>(question.numbers.size(), 16);
      report_margin(*examination.margin(), operation_.metadata().margin_degree, {question.numbers.data(), count},
                    outcome_number(operation_.answer_shape(), examination.solution().answer.words));
    }
    if (hash / 512 % (quick ? 256 : 16) != 0) return "";
    for (const std::string& wrong : {broken_promise(examination), residual_complaint(examination)}) {
      if (!wrong.empty()) return wrong;
    }
    return catalogue::certificate_complaint(examination);
  } catch (const InvalidInput& refused) {
    const std::string mismatch = operation_.refusal_mismatch(question, environment);
    if (!mismatch.empty()) return mismatch;
    return catalogue::array_refusal_mismatch(operation_, question, refused.what(), environment, hash >> 16);
  }
}

std::string Target::shown(Bytes data) const {
  Question question;
  decode(data, question);
  const std::string exact = catalogue::one_line(operation_.print_hexadecimal(question));
  return catalogue::one_line(operation_.print(question)) + "\n" + exact + "\necho '" + exact + "' | touchstone ask " +
         operation_.name() + " -";
}

std::vector<std::pair<std::string, std::vector<std::uint8_t>>> Target::seeds() const {
  std::vector<std::pair<std::string, std::vector<std::uint8_t>>> made;
  const auto& names = operation_.families();
  for (std::size_t family = 0; family < names.size(); ++family) {
    if (names[family].find('+') != std::string::npos) continue;  // the mutator moves by ulps itself
    catalogue::DrawStream draws = catalogue::DrawStream::seeded(catalogue::seed_of(1, names[family].c_str(), 0), true);
    operation_.draw(draws, family);
    std::vector<std::uint8_t> bytes{static_cast<std::uint8_t>(family)};
    bytes.insert(bytes.end(), draws.recorded().begin(), draws.recorded().end());
    made.emplace_back(names[family], std::move(bytes));
  }
  return made;
}

}  // namespace touchstone::fuzz
