// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/contacts/pushes_at_a_root.h"

#include <optional>
#include <utility>

namespace touchstone::robust::kernel {
namespace {

using Column = std::vector<OneRoot>;

class ActiveSet {
 public:
  explicit ActiveSet(const PushesAtARoot& program) : program_(program) {}

  Column found() {
    for (;;) {
      const Column x = solved(program_.wanted);
      Column all(program_.wanted.size());
      for (std::size_t k = 0; k < active_.size(); ++k) all[active_[k]] = x[k];
      const auto broken = broken_by(all);
      if (!broken) return all;
      enforce(*broken);
    }
  }

 private:
  /// Returns the impulses of the active contacts that separate them by `wanted`; they are independent.
  Column solved(const Column& wanted) const {
    const std::size_t n = active_.size();
    std::vector<Column> rows;
    for (const std::size_t i : active_) {
      Column& row = rows.emplace_back();
      for (const std::size_t j : active_) row.push_back(program_.effects[i][j]);
      row.push_back(wanted[i]);
    }
    // A positive definite matrix has no pivot of 0.
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t i = k + 1; i < n; ++i) {
        const OneRoot times = rows[i][k] / rows[k][k];
        for (std::size_t j = k; j <= n; ++j) rows[i][j] = rows[i][j] - times * rows[k][j];
      }
    Column x(n);
    for (std::size_t k = n; k-- > 0;) {
      OneRoot rest = rows[k][n];
      for (std::size_t j = k + 1; j < n; ++j) rest = rest - rows[k][j] * x[j];
      x[k] = rest / rows[k][k];
    }
    return x;
  }

  std::optional<std::size_t> broken_by(const Column& all) const {
    for (std::size_t i = 0; i < all.size(); ++i) {
      OneRoot lacking = program_.wanted[i];
      for (const std::size_t j : active_) lacking = lacking - program_.effects[i][j] * all[j];
      if (sign(lacking) > 0) return i;
    }
    return std::nullopt;
  }

  /// The same as in contact_system.cpp: with an impulse t at p the active ones are x - t d.
  void enforce(std::size_t p) {
    for (;;) {
      const Column x = solved(program_.wanted), d = solved(program_.effects[p]);
      OneRoot lacking = program_.wanted[p], own = program_.effects[p][p];
      std::optional<std::size_t> first;  // first to lose its push: x / d is least
      for (std::size_t k = 0; k < active_.size(); ++k) {
        const OneRoot& effect = program_.effects[p][active_[k]];
        lacking = lacking - effect * x[k], own = own - effect * d[k];
        if (sign(d[k]) > 0 && (!first || sign(x[k] * d[*first] - x[*first] * d[k]) < 0)) first = k;
      }
      if (!first || (sign(own) != 0 && sign(lacking * d[*first] - x[*first] * own) <= 0)) {
        active_.push_back(p);
        return;
      }
      active_.erase(active_.begin() + static_cast<std::ptrdiff_t>(*first));
    }
  }

  const PushesAtARoot& program_;
  std::vector<std::size_t> active_;
};

}  // namespace

std::vector<OneRoot> impulses_of(const PushesAtARoot& program) { return ActiveSet(program).found(); }

}  // namespace touchstone::robust::kernel
