// SPDX-License-Identifier: Apache-2.0
#include "robust/hulls/solid.h"

#include <bit>

#include "robust/hulls/faces.h"

namespace touchstone::robust::hulls {
namespace {

/// Makes both zeros one number.
std::uint64_t bits_of(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  return bits << 1 == 0 ? 0 : bits;
}

/// Any three odd multipliers whose bits are well mixed would do: two thirds, e and pi, in units of 2^-64 and below.
std::uint64_t mixed(const FramePoint& p) {
  const std::uint64_t sum =
      bits_of(p.x) * 0x9e3779b97f4a7c15u + bits_of(p.y) * 0xadf85458a2bb4a9bu + bits_of(p.z) * 0xc90fdaa22168c235u;
  return (sum ^ sum >> 32) * 0x9e3779b97f4a7c15u >> 16;
}

/// Starts from all points, wherever they lie.
Solid directly(const std::vector<Point3d>& points, Frame frame, Stage& latest) {
  Grain grain = grain_of(points, frame);
  if (grain == Grain::lossy) frame.enlarge_only(), grain = Grain::fine;
  Surface surface(frame, grain, latest);
  Seen seen(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const FramePoint p = framed(frame, points, i);
    if (seen.is_new(p, static_cast<std::int32_t>(surface.points.size()), surface.points)) surface.points.push_back(p);
  }
  if (const auto simplex = surface.start()) return {{}, *simplex};
  surface.grow();
  return {faces_of(surface), {}};
}

}  // namespace

Seen::Seen(std::size_t most) : slots_(std::bit_ceil(2 * most + 2), -1) {}

bool Seen::is_new(const FramePoint& p, std::int32_t number, const std::vector<FramePoint>& points) {
  for (std::size_t at = mixed(p) & (slots_.size() - 1);; at = (at + 1) & (slots_.size() - 1)) {
    if (slots_[at] < 0) {
      slots_[at] = number;
      return true;
    }
    if (points[static_cast<std::size_t>(slots_[at])].at(p)) return false;
  }
}

Solid solid_of(const std::vector<Point3d>& points, const Frame& frame, Stage& latest, std::size_t worth_looking,
               std::size_t threads) {
  if (points.size() >= worth_looking && frame.extents == 3) {
    Stage of_surface = latest;
    if (auto surface = surface_of_far_points(points, frame, of_surface, threads)) {
      surface->grow(threads);
      latest = of_surface;
      return {faces_of(*surface, threads), {}};
    }
  }
  return directly(points, frame, latest);
}

}  // namespace touchstone::robust::hulls
