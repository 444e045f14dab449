// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "catalogue/families/draw_stream.h"
#include "geometry/polygons.h"

/// Rings of as many vertices as one likes.
namespace touchstone::proptests {

/// A simple ring whose distance from the origin goes up and down.
inline Polygon2d wavy_ring(std::size_t n) {
  Polygon2d ring;
  for (std::size_t i = 0; i < n; ++i) {
    const double u = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(n);
    const double r = 1 + 0.3 * std::sin(9 * u);
    ring.vertices.push_back({r * std::cos(u), r * std::sin(u)});
  }
  return ring;
}

/// Vertices anywhere in a square: almost every edge crosses many others.
inline Polygon2d random_ring(std::size_t n) {
  catalogue::DrawStream draws = catalogue::DrawStream::seeded(n);
  const auto number = [&draws] { return static_cast<double>(draws.any_bits() >> 11); };
  Polygon2d ring;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = number();
    ring.vertices.push_back({x, number()});
  }
  return ring;
}

/// Long teeth along an axis, and a way back beside them; simple.
inline Polygon2d comb(std::size_t n, bool along_x) {
  Polygon2d ring;
  const auto put = [&](double along, double across) {
    ring.vertices.push_back(along_x ? Point2d{along, across} : Point2d{across, along});
  };
  for (std::size_t i = 0; i + 2 < n; ++i) put(i % 2 == 0 ? 1 : 1000, static_cast<double>(i));
  put(0, static_cast<double>(n)), put(0, -1);
  return ring;
}

/// The same ring with two vertices exchanged near its end.
inline Polygon2d spoilt_at_the_end(Polygon2d ring) {
  const std::size_t n = ring.size();
  std::swap(ring.vertices[n - 8], ring.vertices[n - 5]);
  return ring;
}

}  // namespace touchstone::proptests
