// SPDX-License-Identifier: Apache-2.0
#include "catalogue/operation/probes/shrink.h"

namespace touchstone::catalogue {
namespace {

class Shrinker {
 public:
  Shrinker(std::vector<std::uint8_t> draws, const std::function<bool(const std::vector<std::uint8_t>&)>& interesting,
           int budget)
      : best_(std::move(draws)), interesting_(interesting), budget_(budget) {}

  std::vector<std::uint8_t> run() {
    for (bool better = true; better && budget_ > 0;) {
      better = false;
      for (std::size_t length = best_.size() / 2; length > 0 && budget_ > 0; length /= 2)
        better = blocks(length) || better;
      better = single_bytes() || better;
    }
    while (!best_.empty() && best_.back() == 0) best_.pop_back();  // past the end every choice is 0
    return best_;
  }

 private:
  bool accept(const std::vector<std::uint8_t>& candidate) {
    if (candidate == best_ || budget_-- <= 0 || !interesting_(candidate)) return false;
    best_ = candidate;
    return true;
  }

  /// Sets runs of bytes to zero, then removes them.
  bool blocks(std::size_t length) {
    bool better = false;
    for (std::size_t at = 0; at + length <= best_.size();) {
      std::vector<std::uint8_t> zeroed = best_, cut = best_;
      for (std::size_t i = at; i < at + length; ++i) zeroed[i] = 0;
      cut.erase(cut.begin() + static_cast<std::ptrdiff_t>(at), cut.begin() + static_cast<std::ptrdiff_t>(at + length));
      if (accept(cut)) {
        better = true;
        continue;
      }
      better = accept(zeroed) || better;
      at += length;
    }
    return better;
  }

  bool single_bytes() {
    bool better = false;
    for (std::size_t at = 0; at < best_.size(); ++at) {
      for (const int lessened : {best_[at] / 2, best_[at] - 2, best_[at] - 1}) {
        if (lessened < 0 || lessened >= best_[at]) continue;
        std::vector<std::uint8_t> candidate = best_;
        candidate[at] = static_cast<std::uint8_t>(lessened);
        better = accept(candidate) || better;
      }
    }
    return better;
  }

  std::vector<std::uint8_t> best_;
  const std::function<bool(const std::vector<std::uint8_t>&)>& interesting_;
  int budget_;
};

}  // namespace

std::vector<std::uint8_t> shrunk(std::vector<std::uint8_t> draws,
                                 const std::function<bool(const std::vector<std::uint8_t>&)>& interesting, int budget) {
  return Shrinker(std::move(draws), interesting, budget).run();
}

}  // namespace touchstone::catalogue
