// SPDX-License-Identifier: Apache-2.0
#include "robust/hulls/frame.h"

#include <algorithm>
#include <cmath>

#include "robust/kernel/machine/parallel.h"

// The two passes over all points are compiled for each vector width of the processor: three times as fast as for the
// narrowest. (Only if a function can be compiled several times, and not with sanitizers, which are not ready when the
// version is chosen.)
#if defined(__x86_64__) && defined(__gnu_linux__) && defined(__OPTIMIZE__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define TOUCHSTONE_FOR_EACH_VECTOR_WIDTH __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define TOUCHSTONE_FOR_EACH_VECTOR_WIDTH
#endif

namespace touchstone::robust::hulls {
namespace {

struct Bounds {
  std::array<double, 3> low, high;
  bool finite;
};

/// Processes eight points at a time. 0 * x is 0 if x is finite, otherwise NaN.
TOUCHSTONE_FOR_EACH_VECTOR_WIDTH
void extend(const double* numbers, std::size_t count, Bounds& bounds) {
  constexpr std::size_t lanes = 24;
  double low[lanes], high[lanes], zero[lanes];
  for (std::size_t l = 0; l < lanes; ++l) low[l] = high[l] = numbers[l % 3], zero[l] = 0;
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes) {
    for (std::size_t l = 0; l < lanes; ++l) {
      const double x = numbers[i + l];
      low[l] = x < low[l] ? x : low[l];
      high[l] = x > high[l] ? x : high[l];
      zero[l] += x * 0;
    }
  }
  for (std::size_t l = 0; i < count; ++i, ++l) {
    const double x = numbers[i];
    low[l] = std::min(low[l], x), high[l] = std::max(high[l], x), zero[l] += x * 0;
  }
  double all = 0;
  for (std::size_t k = 0; k < 3; ++k) bounds.low[k] = low[k], bounds.high[k] = high[k];
  for (std::size_t l = 0; l < lanes; ++l) {
    bounds.low[l % 3] = std::min(bounds.low[l % 3], low[l]), bounds.high[l % 3] = std::max(bounds.high[l % 3], high[l]);
    all += zero[l];
  }
  bounds.finite = all == 0;
}

/// Returns bit 0: not narrow; bit 1: not wide; bit 2: lossy. Adding and subtracting 3/2 times 2^52 units rounds to
/// units.
TOUCHSTONE_FOR_EACH_VECTOR_WIDTH
int directions(const double* __restrict numbers, int count, const Frame& frame, int k, Directions& found) {
  const double origin_x = frame.origin[0], origin_y = frame.origin[1], origin_z = frame.origin[2];
  const double scale_x = frame.scale[0], scale_y = frame.scale[1], scale_z = frame.scale[2];
  const double back_x = 1 / scale_x, back_y = 1 / scale_y, back_z = 1 / scale_z;
  const double centre_x = frame.centre[0], centre_y = frame.centre[1], centre_z = frame.centre[2];
  constexpr double narrow = 0x1.8p37, wide = 0x1.8p14;
  const double half = 0.5 * k;
  std::int32_t* __restrict cell = found.cell.data();
  double* __restrict distance = found.distance.data(), * __restrict squared = found.squared.data();
  int flags = 0;
  for (int i = 0; i < count; ++i) {
    const double dx = numbers[3 * i] - origin_x, dy = numbers[3 * i + 1] - origin_y, dz = numbers[3 * i + 2] - origin_z;
    double x = dx * scale_x, y = dy * scale_y, z = dz * scale_z;
    const int off_narrow = ((x + narrow) - narrow != x) | ((y + narrow) - narrow != y) | ((z + narrow) - narrow != z);
    const int off_wide = ((x + wide) - wide != x) | ((y + wide) - wide != y) | ((z + wide) - wide != z);
    const int lost = (x * back_x != dx) | (y * back_y != dy) | (z * back_z != dz);
    flags |= off_narrow | off_wide << 1 | lost << 2;
    x -= centre_x, y -= centre_y, z -= centre_z;
    const double size_y = std::fabs(y), size_z = std::fabs(z);
    double size = std::fabs(x), ahead = x, across = y, up = z, face = 0;
    const bool by_y = size_y > size;
    ahead = by_y ? y : ahead, across = by_y ? z : across, up = by_y ? x : up, face = by_y ? 2 : face;
    size = by_y ? size_y : size;
    const bool by_z = size_z > size;
    ahead = by_z ? z : ahead, across = by_z ? x : across, up = by_z ? y : up, face = by_z ? 4 : face;
    size = by_z ? size_z : size;
    face += ahead < 0 ? 1 : 0;
    const double per_size = half / (size > 1e-300 ? size : 1e-300);
    double u = across * per_size + half, v = up * per_size + half;
    u = u < k - 1 ? u : k - 1, v = v < k - 1 ? v : k - 1;
    cell[i] = (static_cast<std::int32_t>(face) * k + static_cast<std::int32_t>(u)) * k + static_cast<std::int32_t>(v);
    distance[i] = size;
    squared[i] = x * x + y * y + z * z;
  }
  return flags;
}

const double* numbers_of(const Point3d* points) {
  static_assert(sizeof(Point3d) == 3 * sizeof(double));
  return &points->x;
}

}  // namespace

std::optional<Frame> frame_of(const std::vector<Point3d>& points, std::size_t threads) {
  const kernel::ThreadParts parts(threads, points.size(), 1U << 16);
  std::vector<Bounds> of_parts(parts.size());
  parts.each([&](std::size_t part, std::size_t first, std::size_t last) {
    extend(numbers_of(points.data() + first), 3 * (last - first), of_parts[part]);
  });
  Bounds bounds = of_parts[0];
  for (const Bounds& own : of_parts) {
    for (std::size_t k = 0; k < 3; ++k)
      bounds.low[k] = std::min(bounds.low[k], own.low[k]), bounds.high[k] = std::max(bounds.high[k], own.high[k]);
    bounds.finite = bounds.finite && own.finite;
  }
  if (!bounds.finite) return std::nullopt;
  Frame frame{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double low = bounds.low[k], high = bounds.high[k];
    // Within a factor of two differences are exact (Sterbenz).
    const double origin = low > 0 && high / 2 <= low ? low : high < 0 && low / 2 >= high ? high : 0;
    const double most = std::max(std::fabs(low - origin), std::fabs(high - origin));
    const double scale = most > 0 ? std::ldexp(1.0, -std::clamp(std::ilogb(most), -1022, 1023)) : 1;
    frame.origin[k] = origin, frame.scale[k] = scale, frame.reach[k] = most * scale;
    frame.centre[k] = ((low - origin) * scale) / 2 + ((high - origin) * scale) / 2;
    frame.extents += low < high;
  }
  return frame;
}

void Frame::enlarge_only() {
  for (std::size_t k = 0; k < 3; ++k) {
    if (scale[k] < 1) reach[k] /= scale[k], centre[k] /= scale[k], scale[k] = 1;
  }
}

Grain directions_of(const Point3d* points, std::size_t count, const Frame& frame, int k, Directions& found) {
  const int flags = directions(numbers_of(points), static_cast<int>(count), frame, k, found);
  if ((flags & 4) != 0) return Grain::lossy;
  return (flags & 1) == 0 ? Grain::narrow : (flags & 2) == 0 ? Grain::wide : Grain::fine;
}

Grain grain_of(const std::vector<Point3d>& points, const Frame& frame) {
  Directions unused;
  Grain coarsest = Grain::narrow;
  for (std::size_t i = 0; i < points.size(); i += Directions::most) {
    const std::size_t count = std::min(Directions::most, points.size() - i);
    coarsest = std::max(coarsest, directions_of(points.data() + i, count, frame, 1, unused));
  }
  return coarsest;
}

}  // namespace touchstone::robust::hulls
