// SPDX-License-Identifier: Apache-2.0
#include "program/runs/shard.h"

#include <fmt/format.h>

#include <charconv>
#include <optional>

#include "catalogue/codec/excerpt.h"
#include "geometry/int128.h"
#include "program/terminal/exit_codes.h"

namespace touchstone::program {
namespace {

constexpr const char *total_variable = "TOUCHSTONE_SHARDS", *option_name = "--shard";

Shard parsed(const std::string& text) {
  Shard shard{1, 1, option_name};
  const char* const end = text.data() + text.size();
  const auto [slash, no_index] = std::from_chars(text.data(), end, shard.index);
  const bool cut = no_index == std::errc() && slash != end && *slash == '/';
  const auto [rest, no_count] = std::from_chars(cut ? slash + 1 : end, end, shard.of);
  if (!cut || no_count != std::errc() || rest != end || shard.index < 1 || shard.index > shard.of)
    throw UsageError("--shard: expected I/N with 1 <= I <= N, got " + excerpt(text, 60));
  return shard;
}

/// nullopt if the variable is not set, or empty.
std::optional<std::uint64_t> number_in(const Variable& variable, const std::string& name) {
  const char* const value = variable(name.c_str());
  if (value == nullptr || *value == 0) return std::nullopt;
  const std::string text = value;
  std::uint64_t number = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || rest != text.data() + text.size())
    throw UsageError(name + ": expected an integer, got " + excerpt(text, 60));
  return number;
}

/// Task `index` of a launcher that counts from `least`.
Shard counted_from(std::uint64_t least, std::uint64_t index, std::uint64_t of, const std::string& from) {
  if (index < least || index - least >= of)
    throw UsageError(fmt::format("{}: expected an index from {} and below {} + {}, got {}; or give --shard I/N", from,
                                 least, least, of, index));
  return {index - least + 1, of, from};
}

std::optional<Shard> of_slurm(const Variable& variable) {
  const std::string from = "Slurm array";
  const auto id = number_in(variable, "SLURM_ARRAY_TASK_ID");
  if (!id) return std::nullopt;
  if (const auto total = number_in(variable, total_variable)) return counted_from(1, *id, *total, from);
  const std::uint64_t least = number_in(variable, "SLURM_ARRAY_TASK_MIN").value_or(0);
  const auto most = number_in(variable, "SLURM_ARRAY_TASK_MAX");
  if (!most) throw UsageError("SLURM_ARRAY_TASK_MAX: required with SLURM_ARRAY_TASK_ID; or give --shard I/N");
  const std::uint64_t count = number_in(variable, "SLURM_ARRAY_TASK_COUNT").value_or(*most - least + 1);
  if (*most < least || *most - least + 1 != count)
    throw UsageError(
        fmt::format("Slurm array: expected every task from {} to {}, got {} of them; set {} or give "
                    "--shard I/N",
                    least, *most, count, total_variable));
  return counted_from(least, *id, count, from);
}

struct Launcher {
  const char *name, *index, *count;
  std::uint64_t least;
};
constexpr Launcher launchers[]{
    {"Kubernetes indexed job", "JOB_COMPLETION_INDEX", total_variable, 0},
    {"GNU parallel", "PARALLEL_SEQ", total_variable, 1},
    {"Open MPI", "OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE", 0},
    {"PMI", "PMI_RANK", "PMI_SIZE", 0},
};

std::optional<Shard> of(const Launcher& launcher, const Variable& variable) {
  const auto index = number_in(variable, launcher.index), count = number_in(variable, launcher.count);
  if (!index || !count) return std::nullopt;
  return counted_from(launcher.least, *index, *count, launcher.name);
}

}  // namespace

Shard shard_of(const std::string& option, const Variable& variable) {
  if (!option.empty()) return parsed(option);
  Shard found;
  const auto take = [&](const std::optional<Shard>& shard) {
    if (!shard) return;
    if (found.of > 1 && shard->of > 1)
      throw UsageError(in_words(found) + " and " + in_words(*shard) + ": expected one launcher; give --shard I/N");
    if (!found.named() || shard->of > 1) found = *shard;
  };
  take(of_slurm(variable));
  for (const Launcher& launcher : launchers) take(of(launcher, variable));
  return found;
}

std::string in_words(const Shard& shard) { return "shard " + shard.text() + " (" + shard.from + ")"; }

void tell(const Shard& shard, std::ostream& err) {
  if (shard.named() && shard.from != option_name) err << "touchstone: " << in_words(shard) << '\n';
}

Share share_of(std::uint64_t total, const Shard& shard) {
  const auto bound = [&](std::uint64_t i) {
    return static_cast<std::uint64_t>(static_cast<UInt128>(total) * i / shard.of);
  };
  return {bound(shard.index - 1), bound(shard.index)};
}

std::string missing_shards(std::uint64_t shards, const std::vector<std::uint64_t>& done) {
  if (done.size() >= shards) return "";
  std::string list;
  const auto add = [&](std::uint64_t first, std::uint64_t last) {  // first <= shard < last
    if (first == last) return;
    list += (list.empty() ? "" : ", ") + fmt::format("{}", first);
    if (last - first > 1) list += fmt::format("-{}", last - 1);
  };
  std::uint64_t next = 1;
  for (const std::uint64_t shard : done) add(next, shard), next = shard + 1;
  add(next, shards + 1);
  return fmt::format("{} of {} shards are missing: {}", shards - done.size(), shards, list);
}

}  // namespace touchstone::program
