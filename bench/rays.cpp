// SPDX-License-Identifier: Apache-2.0
//
// Rays at the edges and corners of closed meshes, where plain formulas leak: bench/rays SECONDS [FOLDER [SEED]].
//
// Every ray starts inside or outside of the mesh and is aimed at a corner, or at a point of an edge, rounded to
// doubles. ray_triangle_relation decides for every face whether the ray meets it. If it meets the face at an edge or
// corner, the side of the ray on which that edge lies decides, as if the ray were moved by an infinitesimal step along
// x, a smaller one along y and a still smaller one along z: exact, and the same for both faces of an edge.
//   leak     from the inside no face is met;
//   parity   the number of faces that are crossed is even from the inside, or odd from outside;
//   twice    it is more than 1 from the inside of a convex mesh, or more than 2 from outside.
// The meshes are random tetrahedra, the catalogue's meshes, and those in FOLDER (.obj) that are closed. Prints the
// number of rays for each; exits with 1 if any of these defects occurred.

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "catalogue/codec/nearest_double.h"
#include "catalogue/families/draw_stream.h"
#include "catalogue/families/meshes/named_meshes.h"
#include "robust/kernel/integers/integers.h"
#include "robust/kernel/shapes/plane.h"
#include "robust/mixed/ray_triangle.h"
#include "robust/polyhedra/point_in_polyhedron.h"

namespace touchstone::bench {
namespace {

using catalogue::DrawStream;
using Clock = std::chrono::steady_clock;

struct Target {
  std::string name;
  Meshd mesh;
  bool convex;
  double share = 1;  ///< of the time
  double rays = 0, crossed = 0, leaks = 0, parity = 0, twice = 0;
};

/// The signs of (a - o) x (b - o) . d, for an edge a, b, and of its change if the origin moves by e, e . (d x (b - a)),
/// for e along each axis: the first that is not 0. It is 0 only if the edge is along the ray.
template <class Integer>
int side_of_edge(const std::array<Integer, 12>& n) {
  using robust::kernel::multiply, robust::kernel::sign_of;
  const auto projected = [&n](std::size_t i) {
    return Vector3<Integer>{Integer(n[i] - n[0]), Integer(n[i + 1] - n[1]), Integer(n[i + 2] - n[2])};
  };
  const auto across = [](const Vector3<Integer>& v, const Vector3<Integer>& w) {
    return Vector3<robust::kernel::Second<Integer>>{multiply(v.y, w.z) - multiply(v.z, w.y),
                                                    multiply(v.z, w.x) - multiply(v.x, w.z),
                                                    multiply(v.x, w.y) - multiply(v.y, w.x)};
  };
  const Vector3<Integer> d{n[3], n[4], n[5]}, v = projected(6), w = projected(9);
  const auto normal = across(v, w), change = across(d, Vector3<Integer>(w - v));
  using Third = robust::kernel::Third<Integer>;
  const int side = sign_of(Third(multiply(normal.x, d.x) + multiply(normal.y, d.y) + multiply(normal.z, d.z)));
  if (side != 0) return side;
  for (const auto& x : {change.x, change.y, change.z})
    if (sign_of(x) != 0) return sign_of(x);
  return 0;
}

/// The side of the ray on which the edge a, b lies.
int side_of_edge(const Ray3d& ray, const Point3d& a, const Point3d& b) {
  const auto& [o, d] = ray;
  const auto sign = robust::filters::RayAndTriangle<double>(o, d, a, b, b).beside_ab();
  if (sign != robust::filters::Sign::unknown) return sign == robust::filters::Sign::negative ? 1 : -1;
  const auto lattice = robust::kernel::lattice_of(o.x, o.y, o.z, d.x, d.y, d.z, a.x, a.y, a.z, b.x, b.y, b.z);
  if (lattice) return side_of_edge(lattice->at);
  return side_of_edge(robust::kernel::integers_of(o.x, o.y, o.z, d.x, d.y, d.z, a.x, a.y, a.z, b.x, b.y, b.z).at);
}

bool crosses(const Ray3d& ray, const Triangle3d& t) {
  const int ab = side_of_edge(ray, t.a, t.b);
  return ab != 0 && ab == side_of_edge(ray, t.b, t.c) && ab == side_of_edge(ray, t.c, t.a);
}

double between(DrawStream& draws, double low, double high) {
  const double part = static_cast<double>(draws.below(1 << 30)) * 0x1p-30;
  return low + part * (high - low);
}

/// Rounds to twelve digits.
double short_number(double x) {
  int exponent = 0;
  std::frexp(x, &exponent);
  return std::ldexp(std::nearbyint(std::ldexp(x, 12 - exponent)), exponent - 12);
}

/// A point in the mesh's box enlarged by a quarter on each side.
Point3d point_near(DrawStream& draws, const Meshd& mesh) {
  Point3d p;
  for (double Point3d::*axis : {&Point3d::x, &Point3d::y, &Point3d::z}) {
    double low = mesh.vertices[0].*axis, high = low;
    for (const Point3d& vertex : mesh.vertices) low = std::min(low, vertex.*axis), high = std::max(high, vertex.*axis);
    const double more = (high - low) / 4, x = between(draws, low - more, high + more);
    p.*axis = draws.one_in(2) ? x : short_number(x);
  }
  return p;
}

/// A corner, the middle of an edge, or another point of it.
Point3d aim(DrawStream& draws, const Meshd& mesh) {
  const Face& face = mesh.faces[draws.below(mesh.faces.size())];
  const Point3d &a = mesh.vertices[face.a], &b = mesh.vertices[face.b];
  const std::uint64_t kind = draws.below(4);
  if (kind == 0) return a;
  const double part = kind == 1 ? 0.5 : between(draws, 0, 1);
  return a + part * (b - a);
}

void cast(Target& target, const Ray3d& ray, bool inside) {
  std::size_t met = 0, crossed = 0;
  for (const Face& face : target.mesh.faces) {
    const auto& at = target.mesh.vertices;
    const Triangle3d triangle{at[face.a], at[face.b], at[face.c]};
    const auto relation = robust::ray_triangle_relation(ray, triangle);
    met += relation != SegmentTriangleRelation::none;
    if (relation == SegmentTriangleRelation::point) crossed += crosses(ray, triangle);
  }
  target.rays += 1, target.crossed += static_cast<double>(crossed);
  target.leaks += inside && met == 0;
  target.parity += (crossed % 2 == 1) != inside;
  target.twice += target.convex && crossed > (inside ? 1U : 2U);
}

Meshd tetrahedron(DrawStream& draws) {
  Meshd mesh{{}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
  for (int i = 0; i < 4; ++i) {
    const double x = between(draws, -1, 1), y = between(draws, -1, 1), z = between(draws, -1, 1);
    mesh.vertices.push_back({x, y, z});
  }
  return mesh;
}

/// Casts some rays from one origin.
void cast_some(Target& target, DrawStream& draws) {
  if (target.mesh.faces.size() == 4) target.mesh = tetrahedron(draws);
  const Point3d origin = point_near(draws, target.mesh);
  const Location location = robust::point_in_polyhedron(target.mesh, origin);
  if (location == Location::boundary) return;
  for (int i = 0; i < 100; ++i) {
    const Vector3d displacement = aim(draws, target.mesh) - origin;
    if (displacement.x != 0 || displacement.y != 0 || displacement.z != 0)
      cast(target, {origin, displacement}, location == Location::inside);
  }
}

Meshd read_obj(const std::filesystem::path& path) {
  Meshd mesh;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string kind, a, b, c;
    words >> kind >> a >> b >> c;
    const auto number = [](const std::string& word) { return catalogue::nearest_double(word).value(); };
    if (kind == "v") mesh.vertices.push_back({number(a), number(b), number(c)});
    const auto index = [](const std::string& word) { return static_cast<Index>(std::stoul(word) - 1); };
    if (kind == "f") mesh.faces.push_back({index(a), index(b), index(c)});
  }
  return mesh;
}

std::vector<Target> targets(const char* folder, DrawStream& draws) {
  std::vector<Target> all;
  all.push_back({"tetrahedra, another for each origin", tetrahedron(draws), true, 100});
  for (const auto& [name, mesh] : catalogue::named_meshes()) all.push_back({name, mesh, true});
  for (const auto& [name, mesh] : catalogue::named_solids()) all.push_back({name, mesh, false});
  if (folder == nullptr || !std::filesystem::is_directory(folder)) {
    std::printf("no folder of meshes: only those of the catalogue\n");
    return all;
  }
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".obj") continue;
    Target target{entry.path().stem().string(), read_obj(entry.path()), false};
    try {
      robust::point_in_polyhedron(target.mesh, {0, 0, 0});
      all.push_back(std::move(target));
    } catch (const InvalidInput& refused) {
      std::printf("%s is left out: %s\n", target.name.c_str(), refused.what());
    }
  }
  return all;
}

int run(double seconds, const char* folder, std::uint64_t seed) {
  DrawStream draws = DrawStream::seeded(catalogue::seed_of(seed, "rays", 0));
  std::vector<Target> all = targets(folder, draws);
  const auto start = Clock::now();
  const auto elapsed = [start] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  while (elapsed() < seconds) {
    for (Target& target : all) {
      const double until = elapsed() + target.share * std::min(0.02, seconds / 1000);
      do cast_some(target, draws);
      while (elapsed() < until);
    }
  }
  Target sum{"all", {}, false, 0};
  const auto row = [](const Target& t) {
    std::printf("%-36s %5zu faces %14.0f rays %14.0f crossings %4.0f leaks %4.0f parity %4.0f twice\n", t.name.c_str(),
                t.mesh.faces.size(), t.rays, t.crossed, t.leaks, t.parity, t.twice);
  };
  for (const Target& t : all) {
    row(t);
    sum.rays += t.rays, sum.crossed += t.crossed, sum.leaks += t.leaks, sum.parity += t.parity, sum.twice += t.twice;
  }
  row(sum);
  return sum.leaks + sum.parity + sum.twice > 0;
}

}  // namespace
}  // namespace touchstone::bench

int main(int argc, char** argv) {
  const double seconds = argc < 2 ? 0 : touchstone::catalogue::nearest_double(argv[1]).value_or(0);
  if (argc > 4 || !(seconds > 0)) {
    std::fprintf(stderr, "usage: rays SECONDS [FOLDER [SEED]]\n");
    return 2;
  }
  return touchstone::bench::run(seconds, argc > 2 ? argv[2] : nullptr,
                                argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1);
}
