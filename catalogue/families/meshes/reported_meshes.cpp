// SPDX-License-Identifier: Apache-2.0
#include "catalogue/families/meshes/reported_meshes.h"

#include <algorithm>
#include <array>

#include "catalogue/families/meshes/cube_surface.h"
#include "catalogue/families/meshes/mesh_draws.h"

namespace touchstone::catalogue::reported {
namespace {

/// a, b, c counter-clockwise as seen from d.
Meshd tetrahedron(const Point3d& a, const Point3d& b, const Point3d& c, const Point3d& d) {
  return {{a, b, c, d}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

/// Corner number x + 2 y + 4 z.
constexpr std::array<Face, 12> box_faces{{{0, 2, 3},
                                          {0, 3, 1},
                                          {4, 5, 7},
                                          {4, 7, 6},
                                          {0, 1, 5},
                                          {0, 5, 4},
                                          {2, 6, 7},
                                          {2, 7, 3},
                                          {0, 4, 6},
                                          {0, 6, 2},
                                          {1, 3, 7},
                                          {1, 7, 5}}};

Meshd box(const Point3d& low, const Point3d& high) {
  Meshd mesh{{}, {box_faces.begin(), box_faces.end()}};
  for (const double z : {low.z, high.z}) {
    for (const double y : {low.y, high.y}) mesh.vertices.insert(mesh.vertices.end(), {{low.x, y, z}, {high.x, y, z}});
  }
  return mesh;
}

Meshd centred_cube(double half) { return box({-half, -half, -half}, {half, half, half}); }

constexpr std::array<Point3d, 5> base_and_tips_1656{{{-0.856016, 34.2002, -32.2128},
                                                     {-38.7507, -48.6049, 35.289},
                                                     {-2.36607, -39.6614, -41.2837},
                                                     {-2.22164, -18.9363, -7.25029},
                                                     {-19.3048, -17.6092, -15.2126}}};

}  // namespace

Meshd cgal_9486() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}},
          {{0, 1, 2}, {0, 2, 1}, {3, 4, 5}, {3, 5, 4}}};
}

SolidPair cgal_9192(int on) {
  const Point3d p = on == 0 ? Point3d{0, 0, 0} : on == 1 ? Point3d{3, 0, 0} : Point3d{2, 2, 0};
  // The first is above the plane z = 0, the second beneath it.
  return {tetrahedron({0, 0, 0}, {6, 0, 0}, {0, 6, 0}, {0, 0, 6}),
          tetrahedron(p, p + Vector3d{0, 6, -6}, p + Vector3d{6, 0, -6}, p + Vector3d{0, 0, -6})};
}

SolidPair manifold_1656() {
  const auto& [a, b, c, one, other] = base_and_tips_1656;
  return {tetrahedron(a, b, c, one), tetrahedron(a, c, b, other)};
}

Meshd manifold_1656_kept() {
  return {{base_and_tips_1656.begin(), base_and_tips_1656.end()},
          {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {0, 1, 2}, {0, 2, 4}, {0, 4, 1}, {2, 1, 4}}};
}

Meshd manifold_1656_united() {
  Meshd mesh = manifold_1656_kept();
  mesh.faces.erase(mesh.faces.begin() + 4), mesh.faces.erase(mesh.faces.begin());
  return mesh;
}

Meshd libigl_2381() {
  return {{{0.280039012432098, 0.82766300439834595, 0.46377500891685502},
           {0.33890101313590998, 0.78804200887680098, 0.48812699317932101},
           {0.31805300712585399, 0.76836401224136397, 0.49308800697326699},
           {0.30947001278400399, 0.80785250663757346, 0.47595100104808802},
           {0.299046009778976, 0.79801350831985496, 0.47843150794506101},
           {0.32847701013088199, 0.77820301055908248, 0.490607500076294},
           {0.29475451260805097, 0.81775775551795971, 0.46986300498247152},
           {0.28954251110553697, 0.81283825635910045, 0.47110325843095802},
           {0.32418551295995701, 0.79794725775718722, 0.48203899711370451},
           {0.33368901163339598, 0.78312250971794173, 0.48936724662780751},
           {0.30854950845241502, 0.78318876028060946, 0.485759757459164},
           {0.32326500862836799, 0.77328351140022322, 0.4918477535247805},
           {0.30425801128148999, 0.80293300747871421, 0.47719125449657451},
           {0.31897351145744302, 0.79302775859832797, 0.48327925056219101},
           {0.31376150995492902, 0.78810825943946872, 0.4845195040106775}},
          {{2, 11, 10},
           {1, 8, 9},
           {0, 7, 6},
           {3, 12, 13},
           {5, 14, 11},
           {3, 13, 8},
           {4, 12, 7},
           {4, 14, 12},
           {4, 10, 14},
           {5, 9, 13},
           {3, 6, 12},
           {5, 13, 14},
           {14, 10, 11},
           {13, 9, 8},
           {12, 6, 7},
           {14, 13, 12}}};
}

SolidPair vcad_6() { return {box({0, 0, 0}, {10, 10, 25}), box({0, 0, 25}, {10, 10, 60})}; }

Meshd vcad_6_kept() {
  auto [mesh, upper] = vcad_6();
  mesh.vertices.insert(mesh.vertices.end(), upper.vertices.begin() + 4, upper.vertices.end());
  for (const Face& f : box_faces) mesh.faces.push_back({f.a + 4, f.b + 4, f.c + 4});
  return mesh;
}

Meshd trimesh_2534() {
  Meshd hollow = centred_cube(0.05);
  for (Face& f : hollow.faces) std::swap(f.b, f.c);
  return together(centred_cube(0.5), hollow);
}

Meshd trimesh_242() {
  // Four cells of a quarter each in a row with a corner; the last has an edge in common with it.
  Meshd mesh = cube_surface({{0, 1, 1}, {1, 1, 1}, {1, 2, 1}, {2, 1, 2}});
  for (Point3d& p : mesh.vertices) p = {p.x / 48 - 0.5, p.y / 48 - 0.5, p.z / 48 - 0.5};
  return mesh;
}

Meshd edyn_155() { return centred_cube(1); }

Meshd parry_171() {
  return {{{0, 0, 0}, {4, 0, 0}, {4, 6, 0}, {0, 6, 0}, {2, 0, 2}, {2, 6, 2}},
          {{0, 2, 1}, {0, 3, 2}, {0, 1, 4}, {2, 3, 5}, {1, 2, 5}, {1, 5, 4}, {3, 0, 4}, {3, 4, 5}}};
}

SolidPair manifold_676(bool far) {
  const float side = 0.0999F;
  const auto cube = [side](double at) {
    const auto low = static_cast<float>(at), high = static_cast<float>(low + side);
    return box({low, 0, 0}, {high, side, side});
  };
  return far ? SolidPair{cube(0.0999 * 50), cube(0.0999 * 51)} : SolidPair{cube(0.0999), cube(0.0999 * 2)};
}

SolidPair openscad_3641(int common) {
  const Point3d p = common == 0 ? Point3d{1, 1, 0.5} : common == 1 ? Point3d{1, 1, 1} : Point3d{1, 0, 0.25};
  return {box({0, 0, 0}, {1, 1, 1}), box(p, p + Vector3d{1, 1, 1})};
}

}  // namespace touchstone::catalogue::reported
