// SPDX-License-Identifier: Apache-2.0
#include "audit/meshes/surface.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <optional>

namespace touchstone::audit::meshes {
namespace {

/// Disjoint sets of numbers, each number with or against its set's root.
class Joined {
 public:
  explicit Joined(std::size_t count) : up_(count), against_(count), torn_(count) {
    std::iota(up_.begin(), up_.end(), std::size_t{0});
  }
  std::size_t root(std::size_t i) {
    std::size_t top = i;
    bool against = false;  // i relative to top
    while (up_[top] != top) against = against != against_[top], top = up_[top];
    while (up_[i] != top && i != top) {
      const std::size_t next = up_[i];
      const bool rest = against != against_[i];
      up_[i] = top, against_[i] = against;
      i = next, against = rest;
    }
    return top;
  }
  bool against(std::size_t i) { return root(i) != i && against_[i]; }
  /// A set is torn if two of its numbers must be both with and against one another.
  bool torn(std::size_t i) { return torn_[root(i)]; }
  void join(std::size_t i, std::size_t j, bool against = false) {
    const std::size_t p = root(i), q = root(j);
    const bool differ = (this->against(i) != this->against(j)) != against;
    if (p == q) {
      torn_[p] = torn_[p] || differ;
      return;
    }
    const auto [low, high] = std::minmax(p, q);
    torn_[low] = torn_[low] || torn_[high];
    up_[high] = low, against_[high] = differ;
  }

 private:
  std::vector<std::size_t> up_;
  std::vector<bool> against_, torn_;
};

/// A side of a face: a corner and the next; the corners of all faces are numbered consecutively.
struct Side {
  Index low, high;
  std::size_t corner, next, face;
  bool along;  ///< from low to high
  std::size_t at(bool lower) const { return along == lower ? corner : next; }
};

std::vector<Side> sides_of(const std::vector<Corners>& faces) {
  std::vector<Side> sides;
  std::size_t first = 0;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const Corners& corners = faces[i];
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const std::size_t then = (k + 1) % corners.size();
      const Index from = corners[k], to = corners[then];
      if (from != to) sides.push_back({std::min(from, to), std::max(from, to), first + k, first + then, i, from < to});
    }
    first += corners.size();
  }
  std::sort(sides.begin(), sides.end(), [](const Side& s, const Side& t) {
    return s.low != t.low ? s.low < t.low : s.high != t.high ? s.high < t.high : s.corner < t.corner;
  });
  return sides;
}

/// Numbers the sets in the order of their first faces. Returns their number.
std::size_t number(Joined& sets, const std::vector<std::size_t>& member_of_face, std::vector<std::size_t>& numbers,
                   std::size_t size) {
  std::vector<std::optional<std::size_t>> known(size);
  std::size_t count = 0;
  for (const std::size_t member : member_of_face) {
    auto& one = known[sets.root(member)];
    if (!one) one = count++;
    numbers.push_back(*one);
  }
  return count;
}

}  // namespace

Surface::Surface(const std::vector<Corners>& faces, std::size_t vertices_of_file) {
  std::size_t corner_count = 0;
  for (const Corners& corners : faces) corner_count += corners.size();
  const std::vector<Side> sides = sides_of(faces);
  Joined parts(vertices_of_file), fans(corner_count), sheets(faces.size());
  std::vector<std::size_t> rims;  // faces that have an edge of only one face
  std::vector<std::pair<std::size_t, std::size_t>> crowds;
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
    const Side& one = sides[first];
    std::int64_t along = 0;
    for (; last < sides.size() && sides[last].low == one.low && sides[last].high == one.high; ++last) {
      along += sides[last].along ? 1 : 0;
      fans.join(one.at(true), sides[last].at(true)), fans.join(one.at(false), sides[last].at(false));
    }
    const auto count = static_cast<std::int64_t>(last - first);
    const EdgeOfFile edge{one.low, one.high, one.face};
    ++edges;
    if (count % 2 != 0) open.push_back(edge);
    if (std::abs(2 * along - count) > 1) turned.push_back(edge);
    if (count > 2) crowded.push_back(edge), crowds.emplace_back(first, last);
    if (count == 1) rims.push_back(one.face);
    if (count == 2 && one.face != sides[first + 1].face)
      sheets.join(one.face, sides[first + 1].face, one.along == sides[first + 1].along);
    parts.join(one.low, one.high);
  }

  std::vector<std::optional<std::size_t>> fan(vertices_of_file);  // of the first corner
  std::vector<bool> noted(vertices_of_file);
  std::size_t corner = 0;
  for (const Corners& corners : faces) {
    for (const Index v : corners) {
      const std::size_t root = fans.root(corner++);
      if (!fan[v]) fan[v] = root, ++vertices;
      else if (*fan[v] != root && !noted[v]) noted[v] = true, pinched.push_back(v);
    }
  }
  std::sort(pinched.begin(), pinched.end());

  std::vector<std::size_t> firsts, places(faces.size());
  for (const Corners& corners : faces) firsts.push_back(corners[0]);
  std::iota(places.begin(), places.end(), std::size_t{0});
  components = number(parts, firsts, component, vertices_of_file);
  const std::size_t count = number(sheets, places, sheet, faces.size());
  one_sided.resize(count), closed.assign(count, true);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    one_sided[sheet[i]] = sheets.torn(i);
    against.push_back(sheets.against(i));
  }
  for (const std::size_t face : rims) closed[sheet[face]] = false;
  for (const auto& [first, last] : crowds) {
    std::vector<std::size_t> here;
    for (std::size_t k = first; k < last; ++k) here.push_back(sheet[sides[k].face]);
    std::sort(here.begin(), here.end());
    for (std::size_t k = 0, next = 0; k < here.size(); k = next) {
      next = static_cast<std::size_t>(std::upper_bound(here.begin(), here.end(), here[k]) - here.begin());
      if ((next - k) % 2 != 0) closed[here[k]] = false;
    }
  }
}

}  // namespace touchstone::audit::meshes
