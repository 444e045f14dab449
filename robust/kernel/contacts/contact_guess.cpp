// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "robust/kernel/contacts/contact_system.h"

/// Nothing here has to be right: a wrong guess only costs time.
namespace touchstone::robust::kernel {
namespace {

using Rows = std::vector<std::map<std::size_t, double>>;

double largest(const Vector3d& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }
Vector3d over(const Vector3d& v, double size) { return {v.x / size, v.y / size, v.z / size}; }

/// The impulses that meet the demands of these contacts, 0 for a contact that depends on others, or nearly; by
/// elimination, the row with the fewest numbers first.
std::vector<double> balanced(Rows rows, std::vector<double> x, const std::vector<bool>& active) {
  const std::size_t size = rows.size();
  const Rows whole = rows;
  std::vector<std::size_t> order;
  std::vector<double> pivots;
  std::vector<bool> done(size);
  for (std::size_t i = 0; i < size; ++i) {
    if (active[i]) continue;
    for (const auto& [j, number] : whole[i]) rows[j].erase(i);
    rows[i].clear(), done[i] = true, x[i] = 0;
  }
  for (;;) {
    std::size_t row = size;
    for (std::size_t i = 0; i < size; ++i)
      if (!done[i] && (row == size || rows[i].size() < rows[row].size())) row = i;
    if (row == size) break;
    done[row] = true;
    double pivot = rows[row][row];
    rows[row].erase(row);
    const bool dependent = !(pivot > 0x1p-36 * whole[row].at(row));
    if (dependent) pivot = INFINITY;
    for (const auto& [j, left] : rows[row]) {
      rows[j].erase(row);
      if (dependent) continue;
      for (const auto& [k, right] : rows[row]) rows[j][k] -= left * right / pivot;
      x[j] -= left * x[row] / pivot;
    }
    order.push_back(row), pivots.push_back(pivot);
  }
  while (!order.empty()) {
    const std::size_t i = order.back();
    for (const auto& [j, number] : rows[i]) x[i] -= number * x[j];
    x[i] /= pivots.back();
    order.pop_back(), pivots.pop_back();
  }
  return x;
}

}  // namespace

/// Block principal pivoting (Judice, Pires): all contacts that would have to pull stop pushing, and all whose demand is
/// broken start, until none is wrong. If their number has not decreased for a while, only the last of them changes.
Contacts guessed(const std::vector<PointBodyd>& bodies, const std::vector<BodyContactd>& contacts, double e,
                 const Contacts& part) {
  constexpr int patience = 8;
  const std::size_t size = part.size();
  double mass = 0, speed = 0;
  for (const std::size_t i : part)
    for (const Index body : {contacts[i].a, contacts[i].b}) {
      mass = std::max(mass, bodies[body].inverse_mass);
      speed = std::max(speed, largest(bodies[body].velocity));
    }
  std::vector<Vector3d> normals;
  std::vector<double> wanted;
  std::map<Index, Contacts> touching;
  for (std::size_t i = 0; i < size; ++i) {
    const auto& [a, b, n] = contacts[part[i]];
    normals.push_back(over(n, largest(n)));
    const double parting = dot(normals[i], over(bodies[a].velocity, speed) - over(bodies[b].velocity, speed));
    wanted.push_back(parting < 0 ? -(1 + e) * parting : -parting);
    touching[a].push_back(i), touching[b].push_back(i);
  }
  Rows rows(size);
  for (const auto& [body, touched] : touching) {
    const double w = bodies[body].inverse_mass / mass;
    for (const std::size_t i : touched)
      for (const std::size_t j : touched) {
        const double sign = (contacts[part[i]].a == body) == (contacts[part[j]].a == body) ? w : -w;
        rows[i][j] += sign * dot(normals[i], normals[j]);
      }
  }
  std::vector<bool> active(size);
  for (std::size_t i = 0; i < size; ++i) active[i] = wanted[i] > 0;
  std::size_t fewest = size + 1;
  int left = patience;
  for (std::size_t round = 0; round < 2 * size + 40; ++round) {
    const std::vector<double> x = balanced(rows, wanted, active);
    Contacts wrong;
    for (std::size_t i = 0; i < size; ++i) {
      double surplus = -wanted[i], terms = std::fabs(wanted[i]);
      for (const auto& [j, number] : rows[i]) surplus += number * x[j], terms += std::fabs(number * x[j]);
      const bool pushes = active[i] ? x[i] > 0 : surplus < -0x1p-36 * terms;
      if (pushes != active[i]) wrong.push_back(i);
    }
    if (wrong.empty()) break;
    if (wrong.size() < fewest) fewest = wrong.size(), left = patience;
    else --left;
    if (left < 0) wrong = {wrong.back()};
    for (const std::size_t i : wrong) active[i] = !active[i];
  }
  Contacts result;
  for (std::size_t i = 0; i < size; ++i)
    if (active[i]) result.push_back(part[i]);
  return result;
}

}  // namespace touchstone::robust::kernel
