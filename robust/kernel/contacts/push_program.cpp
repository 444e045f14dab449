// SPDX-License-Identifier: Apache-2.0
#include "robust/kernel/contacts/push_program.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace touchstone::robust::kernel {
namespace {

template <class Number>
class ActiveSet {
  using Column = std::vector<Number>;

 public:
  explicit ActiveSet(const PushProgram<Number>& program) : program_(program) {}

  Column found() {
    for (std::size_t i = 0; i < program_.wanted.size(); ++i)
      if (sign(program_.wanted[i]) > 0) active_.push_back(i);
    for (Column x = pushing();; x = *solved(program_.wanted)) {
      Column all(program_.wanted.size());
      for (std::size_t k = 0; k < active_.size(); ++k) all[active_[k]] = std::move(x[k]);
      const auto broken = broken_by(all);
      if (!broken) return all;
      enforce(*broken);
    }
  }

 private:
  /// Returns the impulses of the active contacts that separate them by `wanted`; none if a contact depends on those
  /// before it, which is then `dependent_`.
  std::optional<Column> solved(const Column& wanted) {
    const std::size_t n = active_.size();
    Column rows(n * (n + 1));
    const auto at = [&rows, n](std::size_t i, std::size_t j) -> Number& { return rows[i * (n + 1) + j]; };
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j) at(i, j) = program_.effects[active_[i]][active_[j]];
      at(i, n) = wanted[active_[i]];
    }
    // A positive definite matrix has no pivot of 0.
    for (std::size_t k = 0; k < n; ++k) {
      if (sign(at(k, k)) == 0) {
        dependent_ = k;
        return std::nullopt;
      }
      for (std::size_t i = k + 1; i < n; ++i) {
        const Number times = at(i, k) / at(k, k);
        for (std::size_t j = k + 1; j <= n; ++j) at(i, j) = at(i, j) - times * at(k, j);
      }
    }
    Column x(n);
    for (std::size_t k = n; k-- > 0;) {
      Number rest = at(k, n);
      for (std::size_t j = k + 1; j < n; ++j) rest = rest - at(k, j) * x[j];
      x[k] = rest / at(k, k);
    }
    return x;
  }

  /// Removes contacts until they are independent and none would have to pull.
  Column pushing() {
    for (;;) {
      std::optional<Column> x = solved(program_.wanted);
      if (!x) {
        active_.erase(active_.begin() + static_cast<std::ptrdiff_t>(dependent_));
        continue;
      }
      std::vector<std::size_t> kept;
      for (std::size_t k = 0; k < active_.size(); ++k)
        if (sign((*x)[k]) >= 0) kept.push_back(active_[k]);
      if (kept.size() == active_.size()) return std::move(*x);
      active_ = std::move(kept);
    }
  }

  /// Looks at the contacts that do not push: the others hold.
  std::optional<std::size_t> broken_by(const Column& all) const {
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (std::find(active_.begin(), active_.end(), i) != active_.end()) continue;
      Number lacking = program_.wanted[i];
      for (const std::size_t j : active_) lacking = lacking - program_.effects[i][j] * all[j];
      if (sign(lacking) > 0) return i;
    }
    return std::nullopt;
  }

  /// The same as in contact_system.cpp: with an impulse t at p the active ones are x - t d.
  void enforce(std::size_t p) {
    for (;;) {
      const Column x = *solved(program_.wanted), d = *solved(program_.effects[p]);
      Number lacking = program_.wanted[p], own = program_.effects[p][p];
      std::optional<std::size_t> first;  // first to lose its push: x / d is least
      for (std::size_t k = 0; k < active_.size(); ++k) {
        const Number& effect = program_.effects[p][active_[k]];
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

  const PushProgram<Number>& program_;
  std::vector<std::size_t> active_;
  std::size_t dependent_ = 0;
};

}  // namespace

std::vector<OneRoot> impulses_of(const PushProgram<OneRoot>& program) { return ActiveSet(program).found(); }
std::vector<Sure> impulses_of(const PushProgram<Sure>& program) { return ActiveSet(program).found(); }

}  // namespace touchstone::robust::kernel
