// SPDX-License-Identifier: Apache-2.0
#include "audit/gate/baseline.h"

#include "audit/place.h"
#include "catalogue/operation/operation.h"

namespace touchstone::audit {

std::string baseline_json(const Baseline& baseline) {
  const Json head = {{"touchstone", 1}, {"kind", "baseline"}, {"engine", baseline.engine}, {"seed", baseline.seed}};
  std::string text = one_line(head), separator = "\n";
  text.pop_back();
  text += ",\"known\":[";
  for (const Found& known : baseline.known) {
    const double rate = static_cast<double>(known.findings) / static_cast<double>(known.cases);
    const Json entry = {{"operation", known.operation}, {"family", known.family}, {"cause", name_of(known.cause)},
                        {"findings", known.findings},   {"cases", known.cases},   {"rate", written(rate)}};
    text += separator + one_line(entry);
    separator = ",\n";
  }
  return text + "\n]}\n";
}

Baseline read_baseline(const std::string& text) {
  const Json json = parse_line(text);
  const Place file{json, ""};
  if (file.at("touchstone").count() != 1) throw InvalidInput("touchstone", "version 1");
  if (file.at("kind").text() != "baseline") throw InvalidInput("kind", "baseline");
  Baseline baseline;
  baseline.engine = file.at("engine").text();
  baseline.seed = file.at("seed").count();
  static const std::vector<std::string> words(cause_names.begin(), cause_names.end());
  file.at("known").each([&](const Place& place) {
    Found known;
    known.operation = place.at("operation").text();
    if (!find_operation(known.operation)) throw InvalidInput(place.at("operation").path, "operation of the catalogue");
    known.family = place.at("family").text();
    known.cause = static_cast<Cause>(place.at("cause").one_of(words));
    known.findings = place.at("findings").count();
    known.cases = place.at("cases").count();
    if (known.findings > known.cases) throw InvalidInput(place.at("findings").path, "no more than cases");
    baseline.known.push_back(std::move(known));
  });
  return baseline;
}

}  // namespace touchstone::audit
