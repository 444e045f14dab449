// SPDX-License-Identifier: Apache-2.0
#include "simulate/engine_run.h"

#include <algorithm>

#include "catalogue/codec/excerpt.h"

namespace touchstone::simulate {
namespace {

State<double> in_number_of(const EngineHello& hello, State<double> state) {
  if (!hello.binary32) return state;
  for (auto& [p, v] : state)
    for (double* x : {&p.x, &p.y, &p.z, &v.x, &v.y, &v.z}) *x = static_cast<double>(static_cast<float>(*x));
  return state;
}

}  // namespace

EngineRun::EngineRun(std::unique_ptr<EngineLines> lines, EngineHello hello, const std::string& failure,
                     const Scene& scene)
    : Run(hello.engine, scene), played_(scene), lines_(std::move(lines)), hello_(std::move(hello)) {
  const std::string missing = lacking(hello_, scene);
  unsupported_ = failure.empty() && !missing.empty();
  if (!failure.empty() || unsupported_) end(unsupported_ ? "unsupported: " + missing : failure);
  begin(in_number_of(hello_, scene.start()));
}

Stepped<double> EngineRun::own_step() {
  ++steps_;
  EngineStep answer = read_engine_step(lines_->answer_to(engine_question(steps_)), played_, steps_);
  tells_contacts_ = tells_contacts_ && answer.tells_contacts;
  return {std::move(answer.state), std::move(answer.impacts)};
}

std::unique_ptr<EngineRun> engine_run(std::unique_ptr<EngineLines> lines, const std::string& command,
                                      const Scene& scene, const std::vector<std::string>& taken) {
  EngineHello hello{.engine = catalogue::excerpt(command, 60)};
  std::string failure;
  try {
    hello = read_engine_hello(lines->answer_to(engine_greeting(scene)));
  } catch (const EngineFailure& failed) {
    failure = failed.what();
  } catch (const InvalidInput& wrong) {
    failure = "first line: " + std::string(wrong.what());
  }
  // Names are keys of a trajectory's lines.
  const auto is_taken = [&] {
    return hello.engine == "step" || hello.engine == "parted" || hello.engine == "ended" ||
           std::find(taken.begin(), taken.end(), hello.engine) != taken.end();
  };
  while (is_taken()) hello.engine += " again";
  return std::make_unique<EngineRun>(std::move(lines), std::move(hello), failure, scene);
}

}  // namespace touchstone::simulate
