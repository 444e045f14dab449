// SPDX-License-Identifier: Apache-2.0
#include "program/runs/counted_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "audit/place.h"
#include "catalogue/codec/plain.h"
#include "program/terminal/names.h"

namespace touchstone::program {
namespace {

std::uint64_t index_of(const Json& wrong) { return wrong["index"].get<std::uint64_t>(); }

Share read_share(const Place& place) {
  if (!place.value.is_array() || place.value.size() != 2) throw InvalidInput(place.path, "[first, last]");
  const Share share{Place{place.value[0], place.path + "[0]"}.count(),
                    Place{place.value[1], place.path + "[1]"}.count()};
  if (share.first >= share.last) throw InvalidInput(place.path, "first below last");
  return share;
}

Counts read_counts(const Place& place) {
  Counts counts;
  counts.operation = place.at("operation").text();
  place.at("counted").each([&](const Place& part) {
    Counts one;
    one.counted = {read_share(part)};
    counts.add(one);
  });
  place.at("outcomes").each_member([&](const std::string& word, const Place& n) { counts.outcomes[word] = n.count(); });
  if (place.value.contains("of_grid"))
    place.at("of_grid").each_member([&](const std::string& word, const Place& n) { counts.of_grid[word] = n.count(); });
  counts.wrong = place.at("wrong").count();
  counts.hash = place.at("hash").hexadecimal();
  std::uint64_t sum = 0;
  for (const auto& [word, n] : counts.outcomes) sum += n;
  if (sum != counts.cases()) throw InvalidInput(place.at("outcomes").path, "as many as were counted");
  if (counts.wrong > sum) throw InvalidInput(place.at("wrong").path, "no more than were counted");
  if (place.value.contains("first_wrong") != (counts.wrong > 0))
    throw InvalidInput(place.path + ".first_wrong", "present if and only if an answer is wrong");
  if (counts.wrong > 0) {
    counts.first_wrong = plain(place.at("first_wrong").value);
    counts.first_wrong["index"] = place.at("first_wrong").at("index").count();
  }
  return counts;
}

}  // namespace

std::uint64_t Counts::cases() const {
  std::uint64_t sum = 0;
  for (const Share& share : counted) sum += share.size();
  return sum;
}

void Counts::add(const Counts& other) {
  counted.insert(counted.end(), other.counted.begin(), other.counted.end());
  std::sort(counted.begin(), counted.end(), [](const Share& a, const Share& b) { return a.first < b.first; });
  std::vector<Share> joined;
  for (const Share& share : counted) {
    if (!joined.empty() && share.first < joined.back().last)
      throw InvalidInput("counted", fmt::format("duplicate case {}", share.first));
    if (!joined.empty() && share.first == joined.back().last) joined.back().last = share.last;
    else joined.push_back(share);
  }
  counted = std::move(joined);
  for (const auto& [word, n] : other.outcomes) outcomes[word] += n;
  for (const auto& [word, n] : other.of_grid) of_grid[word] += n;
  wrong += other.wrong;
  hash += other.hash;
  if (!other.first_wrong.is_null() && (first_wrong.is_null() || index_of(other.first_wrong) < index_of(first_wrong)))
    first_wrong = other.first_wrong;
}

std::uint64_t CountedRun::wrong() const {
  std::uint64_t sum = 0;
  for (const Counts& counts : operations) sum += counts.wrong;
  return sum;
}

void CountedRun::merge(const CountedRun& other) {
  const auto same = [](const char* field, const auto& a, const auto& b) {
    if (a != b) throw InvalidInput(field, "the same in every file");
  };
  same("kind", kind, other.kind);
  same("version", version, other.version);
  same("grid", grid, other.grid);
  same("seed", seed, other.seed);
  same("seconds", seconds, other.seconds);
  same("of", of, other.of);
  same("shards", shards, other.shards);
  same("operations", operations.size(), other.operations.size());
  for (std::size_t i = 0; i < operations.size(); ++i)
    same("operations", operations[i].operation, other.operations[i].operation);
  for (const std::uint64_t shard : other.done) {
    const auto at = std::lower_bound(done.begin(), done.end(), shard);
    if (at != done.end() && *at == shard) throw InvalidInput("done", fmt::format("duplicate shard {}", shard));
    done.insert(at, shard);
  }
  for (std::size_t i = 0; i < operations.size(); ++i) operations[i].add(other.operations[i]);
  if (done.size() == shards && seconds == 0) shards = 1, done = {1};
}

void require_shares(const CountedRun& run) {
  for (const Counts& counts : run.operations) {
    std::uint64_t found = 0;
    for (const std::uint64_t shard : run.done) {
      const Share share = share_of(run.of, {shard, run.shards});
      std::uint64_t of_it = 0;
      for (const Share& part : counts.counted) {
        const std::uint64_t first = std::max(part.first, share.first), last = std::min(part.last, share.last);
        if (first < last) of_it += last - first;
      }
      if (run.seconds == 0 && of_it != share.size())
        throw InvalidInput("counted",
                           fmt::format("of {} all of shard {} (from {} and below {}), got {} of {}", counts.operation,
                                       shard, share.first, share.last, of_it, share.size()));
      found += of_it;
    }
    if (found != counts.cases())
      throw InvalidInput("counted", fmt::format("for {} only cases of the shards done", counts.operation));
  }
}

void require_full_grid(const CountedRun& run) {
  if (run.shards > 1) return;
  for (const Counts& counts : run.operations) {
    if (counts.of_grid.empty()) continue;
    const Operation& operation = operation_named(counts.operation);
    const auto whole =
        operation.configurations_of_plain_grid(static_cast<int>(run.grid), operation.metadata().list_length);
    std::uint64_t sum = 0;
    for (const auto& [word, n] : counts.of_grid) sum += n;
    if (whole != sum) throw InvalidInput("of_grid", fmt::format("{} configurations, got {}", whole.value_or(0), sum));
  }
}

Json json_of(const CountedRun& run) {
  Json operations = Json::array();
  for (const Counts& counts : run.operations) {
    Json counted = Json::array(), outcomes = Json::object();
    for (const Share& share : counts.counted) counted.push_back({share.first, share.last});
    for (const auto& [word, n] : counts.outcomes) outcomes[word] = n;
    Json json = {{"operation", counts.operation},
                 {"counted", counted},
                 {"outcomes", outcomes},
                 {"wrong", counts.wrong},
                 {"hash", fmt::format("{:016x}", counts.hash)}};
    if (!counts.of_grid.empty()) json["of_grid"] = counts.of_grid;
    if (counts.wrong > 0) json["first_wrong"] = counts.first_wrong;
    operations.push_back(std::move(json));
  }
  Json json = {{"touchstone", 1}, {"kind", run.kind}, {"version", run.version}};
  if (run.kind == "decisions") json["grid"] = run.grid;
  else json["seed"] = run.seed, json["seconds"] = written(run.seconds);
  json["of"] = run.of, json["shards"] = run.shards, json["done"] = run.done, json["operations"] = operations;
  return json;
}

CountedRun read_counted_run(const Json& json) {
  const Place file{json, ""};
  CountedRun run;
  run.kind = std::vector<std::string>{"soak", "decisions"}[file.at("kind").one_of({"soak", "decisions"})];
  run.version = file.at("version").text();
  if (run.kind == "decisions") run.grid = file.at("grid").count();
  else run.seed = file.at("seed").count(), run.seconds = file.at("seconds").number();
  run.of = file.at("of").count();
  run.shards = file.at("shards").count();
  file.at("done").each([&](const Place& place) {
    const std::uint64_t shard = place.count();
    if (shard < 1 || shard > run.shards) throw InvalidInput(place.path, "one of the shards, counted from 1");
    if (!run.done.empty() && shard <= run.done.back()) throw InvalidInput(place.path, "ascending");
    run.done.push_back(shard);
  });
  file.at("operations").each([&](const Place& place) { run.operations.push_back(read_counts(place)); });
  return run;
}

}  // namespace touchstone::program
