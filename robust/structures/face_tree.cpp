// SPDX-License-Identifier: Apache-2.0
#include "robust/structures/face_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "robust/kernel/filters/control_word.h"

namespace touchstone::robust::structures {
namespace {

using Place = std::array<float, 3>;
constexpr float nothing = std::numeric_limits<float>::quiet_NaN();

Place rounded(const Point3d& p) { return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)}; }

struct Extent {
  Place low, high;
  void add(const Place& p) {
    for (std::size_t i = 0; i < 3; ++i) low[i] = std::min(low[i], p[i]), high[i] = std::max(high[i], p[i]);
  }
};

Extent around(const Meshd& mesh, const Face& f) {
  const Place a = rounded(mesh.vertices[f.a]);
  Extent found{a, a};
  found.add(rounded(mesh.vertices[f.b])), found.add(rounded(mesh.vertices[f.c]));
  return found;
}

std::vector<Index> all_of(const Meshd& mesh) {
  std::vector<Index> faces(mesh.faces.size());
  std::iota(faces.begin(), faces.end(), Index{0});
  return faces;
}

/// Spreads ten bits with two free bits after each.
std::uint32_t spread(std::uint32_t n) {
  n = (n | n << 16) & 0x030000ff, n = (n | n << 8) & 0x0300f00f;
  n = (n | n << 4) & 0x030c30c3, n = (n | n << 2) & 0x09249249;
  return n;
}

}  // namespace

/// Sorts by the midpoints' positions on Morton's curve. An estimate: a NaN is placed at 0. One block needs no order.
void FaceTree::sort_faces(const Meshd& mesh) {
  if (order_.size() <= 8) return;
  const Place first = rounded(mesh.vertices[mesh.faces[0].a]);
  Extent all{first, first};
  for (const Point3d& p : mesh.vertices) all.add(rounded(p));
  using Key = std::pair<std::uint32_t, Index>;
  std::vector<Key> keys(order_.size()), other(order_.size());
  Place scale;
  for (std::size_t k = 0; k < 3; ++k) scale[k] = 1023 / (all.high[k] / 2 - all.low[k] / 2);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const Extent box = around(mesh, mesh.faces[order_[i]]);
    std::uint32_t key = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const float at = (box.low[k] / 4 + box.high[k] / 4 - all.low[k] / 2) * scale[k];
      key = key << 1 | spread(at > 0 && at < 1024 ? static_cast<std::uint32_t>(at) : 0);
    }
    keys[i] = {key, order_[i]};
  }
  for (const int shift : {0, 10, 20}) {
    std::array<std::size_t, 1025> start{};
    for (const Key& key : keys) ++start[(key.first >> shift & 1023) + 1];
    for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
    for (const Key& key : keys) other[start[key.first >> shift & 1023]++] = key;
    keys.swap(other);
  }
  for (std::size_t i = 0; i < keys.size(); ++i) order_[i] = keys[i].second;
}

FaceTree::FaceTree(const Meshd& mesh) : FaceTree(mesh, all_of(mesh)) {}

FaceTree::FaceTree(const Meshd& mesh, std::vector<Index> faces) : order_(std::move(faces)) {
  const kernel::ControlWord guard;
  sort_faces(mesh);
  const auto add_level = [this](std::size_t size, const auto& extent) {
    std::vector<Block> blocks((size + 7) / 8);
    for (std::size_t i = 0; i < 8 * blocks.size(); ++i) {
      const Place none{nothing, nothing, nothing};
      const Extent box = i < size ? extent(i) : Extent{none, none};
      blocks[i / 8].set(i % 8, box.low, box.high);
    }
    levels_.push_back(std::move(blocks));
    return size;
  };
  std::size_t size = add_level(order_.size(), [&](std::size_t i) { return around(mesh, mesh.faces[order_[i]]); });
  while (size > 1) {
    const std::vector<Block>& below = levels_.back();
    size = add_level((size + 7) / 8, [&below](std::size_t i) {
      const Block& block = below[i];
      Extent box{{block.low[0][0], block.low[1][0], block.low[2][0]},
                 {block.high[0][0], block.high[1][0], block.high[2][0]}};
      for (std::size_t axis = 0; axis < 3; ++axis) {
        for (std::size_t lane = 1; lane < 8; ++lane) {
          if (block.low[axis][lane] < box.low[axis]) box.low[axis] = block.low[axis][lane];
          if (block.high[axis][lane] > box.high[axis]) box.high[axis] = block.high[axis][lane];
        }
      }
      return box;
    });
  }
}

float FaceTree::greatest() const {
  const Block& top = levels_.back()[0];
  float found = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    found = std::max({found, std::fabs(top.low[axis][0]), std::fabs(top.high[axis][0])});
  return found;
}

/// Numbers of vertices that no face names make it greater than it has to be.
float FaceTree::greatest_of(const Meshd& mesh) {
  float found = 0;
  for (const Point3d& p : mesh.vertices)
    for (const float x : rounded(p)) found = std::max(found, std::fabs(x));
  return found;
}

FaceTree::Stay FaceTree::stay_of(const Face& face, const Meshd& mesh, const Slabs& slabs) {
  const Extent box = around(mesh, face);
  Block block;
  block.set(0, box.low, box.high);
  return block.stay(slabs, 0);
}

FaceTree::Slabs::Slabs(const Ray3d& ray, float greatest, float radius) {
  const auto& [o, v] = ray;
  const Place origin = rounded(o);
  greatest = std::max(greatest, radius);
  for (const float x : origin) greatest = std::max(greatest, std::fabs(x));
  moderate = greatest >= 0x1p-60F && greatest <= 0x1p60F;
  const double length = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  exponent = validation::zero(length) ? 0 : std::ilogb(length);
  const Place direction =
      rounded({std::scalbn(v.x, -exponent), std::scalbn(v.y, -exponent), std::scalbn(v.z, -exponent)});
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float size = std::max(std::fabs(direction[axis]), 0x1p-40F), wider = radius + 0x1p-19F * greatest;
    falls[axis] = direction[axis] < 0;
    inverse[axis] = (falls[axis] ? -1 : 1) / size;
    from[axis] = falls[axis] ? origin[axis] - wider : origin[axis] + wider;
    until[axis] = falls[axis] ? origin[axis] + wider : origin[axis] - wider;
  }
}

FaceTree::Gaps::Gaps(const Point3d& p, float greatest) {
  const Place at = rounded(p);
  for (const float x : at) greatest = std::max(greatest, std::fabs(x));
  moderate = greatest >= 0x1p-50F && greatest <= 0x1p60F;
  const float more = greatest * 0x1p-20F;
  for (std::size_t axis = 0; axis < 3; ++axis) above[axis] = at[axis] + more, below[axis] = at[axis] - more;
}

}  // namespace touchstone::robust::structures
