// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/systems/impulses_at_a_root.h"

#include <gmpxx.h>

#include <algorithm>
#include <optional>
#include <stdexcept>

namespace touchstone::oracle {
namespace {

using Rough = mpf_class;
constexpr int rough_bits = 1024, rough_digits = 512;
Rough rough(const OverRoot& x) {
  Rough p(0, rough_bits), q(0, rough_bits), r(0, rough_bits);
  p = x.p, q = x.q;
  if (x.r != nullptr) r = *x.r;
  return p + q * sqrt(r);
}

bool is_better_pivot(const OverRoot& x, const OverRoot& y) { return sgn(y) == 0 && sgn(x) != 0; }
bool is_better_pivot(const Rough& x, const Rough& y) { return abs(x) > abs(y); }

template <class Number>
Number magnitude(const Number& x) {
  return sgn(x) < 0 ? Number(-x) : x;
}

/// True if x, a sum of numbers of that size, is negative beyond its rounding.
bool is_negative(const OverRoot& x, const OverRoot&) { return sgn(x) < 0; }
bool is_negative(const Rough& x, const Rough& size) {
  Rough bound(size, rough_bits);
  mpf_div_2exp(bound.get_mpf_t(), bound.get_mpf_t(), rough_digits);
  return x + bound < 0;
}

/// The solution of a system of equations, or nullopt if they are dependent.
template <class Number>
std::optional<std::vector<Number>> solved(std::vector<std::vector<Number>> rows) {
  const std::size_t n = rows.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i)
      if (is_better_pivot(rows[i][k], rows[pivot][k])) pivot = i;
    if (sgn(rows[pivot][k]) == 0) return std::nullopt;
    std::swap(rows[k], rows[pivot]);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k || sgn(rows[i][k]) == 0) continue;
      const Number times = rows[i][k] / rows[k][k];
      for (std::size_t j = k; j <= n; ++j) rows[i][j] = rows[i][j] - times * rows[k][j];
    }
  }
  std::vector<Number> result;
  for (std::size_t k = 0; k < n; ++k) result.push_back(rows[k][n] / rows[k][k]);
  return result;
}

/// Each row: effects, then the demand. The impulses if those in the set push and no others.
template <class Number>
std::optional<std::vector<Number>> pushed_by(unsigned set, const std::vector<std::vector<Number>>& rows,
                                             const Number& zero) {
  const std::size_t n = rows.size();
  std::vector<std::size_t> pushing;
  for (std::size_t i = 0; i < n; ++i)
    if ((set >> i & 1) != 0) pushing.push_back(i);
  std::vector<std::vector<Number>> part;
  for (const std::size_t i : pushing) {
    std::vector<Number>& row = part.emplace_back();
    for (const std::size_t j : pushing) row.push_back(rows[i][j]);
    row.push_back(rows[i][n]);
  }
  const std::optional<std::vector<Number>> found = solved(std::move(part));
  if (!found) return std::nullopt;
  std::vector<Number> all(n, zero);
  for (std::size_t k = 0; k < pushing.size(); ++k) {
    if (sgn((*found)[k]) < 0) return std::nullopt;
    all[pushing[k]] = (*found)[k];
  }
  for (const std::vector<Number>& row : rows) {
    Number surplus = zero - row[n], size = magnitude(row[n]);
    for (std::size_t j = 0; j < n; ++j) {
      const Number change = row[j] * all[j];
      surplus = surplus + change, size = size + magnitude(change);
    }
    if (is_negative(surplus, size)) return std::nullopt;
  }
  return all;
}

}  // namespace

std::vector<OverRoot> impulses_at_a_root(const ImpulsesWanted& wanted) {
  const std::size_t n = wanted.demands.size();
  std::vector<std::vector<OverRoot>> rows = wanted.effects;
  std::vector<std::vector<Rough>> roughly(n);
  for (std::size_t i = 0; i < n; ++i) {
    rows[i].push_back(wanted.demands[i]);
    for (const OverRoot& x : rows[i]) roughly[i].push_back(rough(x));
  }
  std::vector<unsigned> sets;
  for (unsigned set = 1; set < 1u << n; ++set) sets.push_back(set);
  const Rough nothing(0, rough_bits);
  std::stable_partition(sets.begin(), sets.end(),
                        [&](unsigned set) { return pushed_by(set, roughly, nothing).has_value(); });
  for (const unsigned set : sets)
    if (const auto found = pushed_by(set, rows, OverRoot())) return *found;
  throw std::logic_error("-e v meets every demand");
}

}  // namespace touchstone::oracle
