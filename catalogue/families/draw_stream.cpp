// SPDX-License-Identifier: Apache-2.0
#include "catalogue/families/draw_stream.h"

namespace touchstone::catalogue {
namespace {

// SplitMix64 (Steele, Lea, Flood 2014, "Fast splittable pseudorandom number generators"): the output function.
std::uint64_t mixed(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

constexpr std::uint64_t golden_gamma = 0x9e3779b97f4a7c15u;

/// Bytes that hold every k < n; n == 0 stands for 2^64.
std::size_t width(std::uint64_t n) {
  const std::uint64_t most = n - 1;
  return most < 0x100 ? 1 : most < 0x10000 ? 2 : most < 0x100000000 ? 4 : 8;
}

}  // namespace

DrawStream DrawStream::seeded(std::uint64_t seed, bool record) {
  DrawStream draws;
  draws.state_ = seed;
  draws.record_ = record;
  return draws;
}

DrawStream DrawStream::replayed(std::span<const std::uint8_t> bytes) {
  DrawStream draws;
  draws.source_ = Source::bytes;
  draws.bytes_ = bytes;
  return draws;
}

std::uint64_t DrawStream::next() { return mixed(state_ += golden_gamma); }

std::uint64_t DrawStream::recorded_below(std::uint64_t n) {
  std::uint64_t k = 0;
  if (source_ == Source::seeded) {
    k = n == 0 ? next() : next() % n;
    for (std::size_t i = 0; i < width(n); ++i) record_bytes_.push_back(static_cast<std::uint8_t>(k >> 8 * i));
    return k;
  }
  for (std::size_t i = 0; i < width(n) && i < bytes_.size(); ++i) k |= std::uint64_t{bytes_[i]} << 8 * i;
  bytes_ = bytes_.subspan(bytes_.size() < width(n) ? bytes_.size() : width(n));
  return n == 0 ? k : k % n;
}

std::uint64_t seed_of(std::uint64_t seed, const char* name, std::uint64_t index) {
  std::uint64_t state = mixed(seed + golden_gamma);
  for (; *name != 0; ++name) state = mixed(state ^ static_cast<std::uint8_t>(*name)) + golden_gamma;
  return mixed(state ^ index);
}

}  // namespace touchstone::catalogue
