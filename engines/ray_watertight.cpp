// SPDX-License-Identifier: Apache-2.0
// Rays that do not leak through common edges, after Woop, Benthin and Wald (2013), over plain doubles, as peer.

#include <touchstone/geometry/rays.h>
#include <touchstone/program/engine_main.h>

#include <array>
#include <cmath>
#include <utility>

using namespace touchstone;

/// The paper promises that no ray leaks between two triangles with a common edge; not that each answer is right. It
/// turns to twice the precision where an edge's function is 0, as here to long double.
struct RayWatertight {
  static constexpr const char* name = "Watertight ray and triangle of Woop, Benthin and Wald";
  static constexpr auto boundary = Boundary::closed;

  RayTriangle<double> ray_triangle(const Ray3d& ray, const Triangle3d& triangle) {
    const auto t = first(ray, triangle);
    if (!t) return {SegmentTriangleRelation::none, {}, {}, {}};
    return {SegmentTriangleRelation::point, *t, {}, {}};
  }

 private:
  using Numbers = std::array<double, 3>;

  static std::optional<double> first(const Ray3d& ray, const Triangle3d& triangle) {
    const Numbers v{ray.direction.x, ray.direction.y, ray.direction.z};
    std::size_t z = 0;
    for (std::size_t k = 1; k < 3; ++k)
      if (std::abs(v[k]) > std::abs(v[z])) z = k;
    std::size_t x = (z + 1) % 3, y = (x + 1) % 3;
    if (v[z] < 0) std::swap(x, y);
    const double shear_x = v[x] / v[z], shear_y = v[y] / v[z], scale = 1 / v[z];
    struct Sheared {
      double x, y, z;
    };
    const auto sheared = [&](const Point3d& p) {
      const Numbers n{p.x - ray.origin.x, p.y - ray.origin.y, p.z - ray.origin.z};
      return Sheared{n[x] - shear_x * n[z], n[y] - shear_y * n[z], scale * n[z]};
    };
    const Sheared a = sheared(triangle.a), b = sheared(triangle.b), c = sheared(triangle.c);
    double u = c.x * b.y - c.y * b.x, w = b.x * a.y - b.y * a.x, s = a.x * c.y - a.y * c.x;
    if (u == 0 || s == 0 || w == 0) {
      const auto longer = [](double p, double q, double r, double t) {
        return static_cast<double>(static_cast<long double>(p) * q - static_cast<long double>(r) * t);
      };
      u = longer(c.x, b.y, c.y, b.x), s = longer(a.x, c.y, a.y, c.x), w = longer(b.x, a.y, b.y, a.x);
    }
    if ((u < 0 || s < 0 || w < 0) && (u > 0 || s > 0 || w > 0)) return std::nullopt;
    const double determinant = u + s + w;
    if (determinant == 0) return std::nullopt;
    const double t = (u * a.z + s * b.z + w * c.z) / determinant;
    if (!(t >= 0)) return std::nullopt;
    return t;
  }
};

TOUCHSTONE_ENGINE_MAIN(RayWatertight)
