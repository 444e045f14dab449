// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <utility>

#include "catalogue/families/meshes/cube_surface.h"
#include "catalogue/families/meshes/mesh_draws.h"
#include "catalogue/families/meshes/part_draws.h"
#include "catalogue/families/meshes/polygon_draws.h"
#include "catalogue/families/meshes/reported_meshes.h"
#include "catalogue/families/meshes/solid_draws.h"
#include "catalogue/families/space_draws.h"
#include "catalogue/operation/digits.h"
#include "catalogue/operation/row.h"
#include "oracle/polyhedra/polyhedron_polyhedron.h"
#include "reference/polyhedra/polyhedron_polyhedron.h"
#include "robust/polyhedra/polyhedron_polyhedron.h"

namespace touchstone::catalogue::rows {

struct polyhedron_polyhedron {
  TOUCHSTONE_MODULES(polyhedron_polyhedron)
  using stages = ::touchstone::robust::stages::polyhedron_polyhedron;
  using Question = std::tuple<Meshd, Meshd>;
  using decision = NoDecision;

  static const Metadata& metadata() {
    static const Metadata metadata{
        .name = "polyhedron_polyhedron",
        .chapter = "polyhedra",
        .pages = "25, 52-54",
        .question = "Do two polyhedra collide, convex or not, and which step of the test tells?",
        .kind = Kind::decision,
        .fields = {"a", "b"},
        .margin_degree = 2,
        .cost = 1000,
        .time = grows(Growth::quadratic),
        .list_length = 5};
    return metadata;
  }

  static std::vector<HardCase<Question>> hard_cases() {
    return {
        {"lattice",
         [](DrawStream& c) -> Question {
           const Meshd a = lattice_solid(c), b = lattice_solid(c);
           return {a, moved(b, c, 12, 3)};
         }},
        {"feature_to_feature",
         [](DrawStream& c) -> Question {
           const Meshd a = lattice_solid(c), b = lattice_solid(c);
           const Point3d p = on_a_face_plane(a, c), q = on_a_face_plane(b, c);
           return {a, shifted(b, p - q)};
         }},
        {"convex",
         [](DrawStream& c) -> Question {
           const Meshd a = lattice_polyhedron(c), b = lattice_polyhedron(c);
           const Point3d p = on_a_face_plane(a, c), q = on_a_face_plane(b, c);
           return {a, shifted(b, p - q)};
         }},
        {"equal",
         [](DrawStream& c) -> Question {
           // Or cut in other triangles, turned inside out, a little way off.
           const Meshd a = lattice_solid(c);
           Meshd b = a;
           if (c.below(2) == 1) b = with_flat_vertex(b, c);
           if (c.below(2) == 1) {
             for (Face& face : b.faces) std::swap(face.b, face.c);
           }
           return {a, moved(b, c, 6, 1)};
         }},
        {"one_within",
         [](DrawStream& c) -> Question {
           const Meshd a = lattice_solid(c), b = lattice_polyhedron(c);
           return {scaled(a, 3), moved(b, c, 12, 4)};
         }},
        {"interlocked",
         [](DrawStream& c) -> Question {
           // Links of a chain, or crossing sticks: no vertex is within the other.
           const Meshd a = link(c), b = mapped(link(c), [](const Point3d&p) { return Point3d{p.y, p.z, p.x}; });
           return {a, moved(b, c, 6, 3)};
         }},
        {"cubes",
         [](DrawStream& c) -> Question {
           const Meshd a = cube_surface(cells(c)), b = cube_surface(cells(c));
           return {a, moved(b, c, 12, 2)};
         }},
        {"tetrahedra",
         [](DrawStream& c) -> Question {
           const Meshd a = tetrahedra_together(c), b = tetrahedra_together(c);
           return {a, moved(b, c, 12, 1)};
         }},
        {"needless_faces",
         [](DrawStream& c) -> Question {
           Meshd a = scaled(lattice_solid(c), 6);
           a = with_needless_faces(a, c);
           const double size = 1 + static_cast<double>(c.below(6));
           const Meshd b = scaled(lattice_polyhedron(c), size);
           const Point3d p = c.below(2) == 0 ? on_a_face_plane(a, c) : a.vertices.back();
           return {a, shifted(b, p - between_vertices(b, c))};
         }},
        {"mapped",
         [](DrawStream& c) -> Question {
           const Meshd a = lattice_polyhedron(c), b = dented_tetrahedron(24, {6, 6, 6});
           const Point3d p = on_a_face_plane(a, c), q = on_a_face_plane(b, c);
           return split(a, shifted(b, p - q), [&c](Meshd& all) {
             Point3d none{0, 0, 0};
             map_linearly(all, none, c);
           });
         }},
        {"stretched",
         [](DrawStream& c) -> Question {
           // Each axis by its own power of two: past any lattice, past the filters' guards, to both ends of the range.
           const Meshd a = lattice_polyhedron(c), b = dented_tetrahedron(24, {6, 6, 6});
           const Point3d p = on_a_face_plane(a, c), q = on_a_face_plane(b, c);
           static constexpr int exponents[] = {0, 60, 255, -170, 300, -300, 1013, -1074};
           const int x = exponents[c.below(8)], y = exponents[c.below(8)], z = exponents[c.below(8)];
           const auto stretch = [=](const Point3d& v) {
             return Point3d{std::ldexp(v.x, x), std::ldexp(v.y, y), std::ldexp(v.z, z)};
           };
           return {mapped(a, stretch), mapped(shifted(b, p - q), stretch)};
         }},
        {"rounded_onto",
         [](DrawStream& c) -> Question {
           // A corner of one, as far as doubles can tell, on a face of the other.
           const Meshd a = ordinary_solid(c), b = ordinary_solid(c);
           const auto& [p, q, r] = std::array{a.vertices[1], a.vertices[2], a.vertices[4]};
           const double s = std::fabs(ordinary(c)) / 2, t = std::fabs(ordinary(c)) / 2;
           const Point3d onto = p + (s * (q - p)) + (t * (r - p));
           return {a, shifted(b, onto - b.vertices[c.below(5)])};
         }},
        {"opened",
         [](DrawStream& c) -> Question {
           const Meshd a = lattice_solid(c), b = lattice_solid(c);
           if (c.below(2) == 0) return {opened(a, c), b};
           return {a, opened(b, c)};
         }},
        {"named_solid",
         [](DrawStream& c) -> Question {
           const Meshd& a = named_solid(c);
           const Meshd b = dented_tetrahedron(24, {6, 6, 6});
           const Point3d p = c.below(3) == 2 ? between_vertices(a, c) : on_a_face_plane(a, c);
           return {a, shifted(b, p - on_a_face_plane(b, c))};
         },
         /*unscaled=*/true},
        {"reported_manifold_1656", [](DrawStream& c) -> Question { return either_first(reported::manifold_1656(), c); },
         /*unscaled=*/true},
        {"reported_vcad_6", [](DrawStream& c) -> Question { return either_first(reported::vcad_6(), c); },
         /*unscaled=*/true},
        {"reported_cgal_9192",
         [](DrawStream& c) -> Question {
           const auto on = static_cast<int>(c.below(3));
           return either_first(reported::cgal_9192(on), c);
         },
         /*unscaled=*/true},
        {"reported_manifold_676",
         [](DrawStream& c) -> Question {
           const bool far = c.below(2) == 0;
           return either_first(reported::manifold_676(far), c);
         },
         /*unscaled=*/true},
        {"reported_openscad_3641",
         [](DrawStream& c) -> Question {
           const auto common = static_cast<int>(c.below(3));
           return either_first(reported::openscad_3641(common), c);
         },
         /*unscaled=*/true},
        {"needless_vertex_inside",
         [](DrawStream& c) -> Question {
           // Solids that are apart or touch, but for a needless face of one, which reaches into the other.
           Meshd a = lattice_solid(c);
           const Meshd other = lattice_polyhedron(c);
           const double gap = 12 * static_cast<double>(c.below(3));
           const Meshd b = shifted(other, {greatest_x(a) - least_x(other) + gap, 0, 0});
           const Face face = a.faces[c.below(a.faces.size())];
           const auto added = static_cast<Index>(a.vertices.size());
           a.vertices.push_back(between_vertices(b, c));
           a.faces.insert(a.faces.end(), {{face.a, face.b, added}, {added, face.b, face.a}});
           return c.below(2) == 0 ? Question{a, b} : Question{b, a};
         },
         /*unscaled=*/true},
        {"polygons",
         [](DrawStream& c) -> Question {
           const Meshd a = solid_of_polygons(c), b = convex_solid_of_polygons(c);
           const Meshd asked = c.below(6) == 5 ? with_broken_polygons(a, c) : a;
           return {asked, moved(b, c, 12, 3)};
         },
         /*unscaled=*/true},
        {"within_shells",
         [](DrawStream& c) -> Question {
           // A solid, or one with a hollow of its own; alone, or after a part that is far away. Its faces lie between
           // two shells or are those of a shell.
           const Meshd shape = around_the_mean(lattice_polyhedron(c)), a = shells(shape, c);
           const auto size = static_cast<double>(1 + c.below(3));
           Meshd b = scaled(shape, size);
           if (c.below(2) == 1) {
             const auto more = static_cast<double>(1 + c.below(4));
             b = together(b, scaled(shape, size + more));
           }
           if (c.below(2) == 1) b = together(shifted(lattice_polyhedron(c), {0x1p14, 0, 0}), b);
           return c.below(2) == 1 ? Question{b, a} : Question{a, b};
         },
         /*unscaled=*/true},
        {"body_in_recess",
         [](DrawStream& c) -> Question {
           const auto [solid, body, middle] = body_in_recess(c);
           return c.below(2) == 1 ? Question{body, solid} : Question{solid, body};
         },
         /*unscaled=*/true},
        {"crossing_boxes",
         [](DrawStream& c) -> Question {
           const Meshd a = crossing_boxes(c);
           const auto from = [&c] { return 6 * static_cast<double>(c.below(8)); };
           const double x = from(), y = from(), z = from(), size = 6 * static_cast<double>(1 + c.below(2));
           const Meshd b = box_mesh({x, y, z}, {x + size, y + size, z + size});
           return c.below(2) == 1 ? Question{b, a} : Question{a, b};
         },
         /*unscaled=*/true},
        {"unnamed_vertices",
         [](DrawStream& c) -> Question {
           // They may lie within the other solid, or widen a box.
           const Meshd a = lattice_solid(c), b = moved(lattice_polyhedron(c), c, 12, 3);
           const Meshd marked = with_unnamed_vertices(a, between_vertices(b, c), c);
           return c.below(2) == 1 ? Question{b, marked} : Question{marked, b};
         },
         /*unscaled=*/true}};
  }

  static void repair(Question& question) { make_solid(std::get<0>(question)), make_solid(std::get<1>(question)); }

  /// Two tetrahedra of size 12, the first with a dent or a spike: it and the other's place run over the numbers from 0
  /// in thirds of 12.
  static std::uint64_t domain_count(int size) { return configurations_of_digits(size, 6); }
  static Question domain_at(int size, std::uint64_t index) {
    Digits digit(size, index);
    const double x = digit(), y = digit(), z = digit(), u = digit(), v = digit(), w = digit();
    Meshd b{{{0, 0, 0}, {12, 0, 0}, {0, 12, 0}, {0, 0, 12}}, {}};
    make_tetrahedron(b);
    return {dented_tetrahedron(12, {4 * x, 4 * y, 4 * z}), shifted(b, {4 * u, 4 * v, 4 * w})};
  }

  /// A corner at the end of a dent: moves the dent.
  static Question map_centre() {
    const Meshd spike{{{2, 2, 2}, {22, 10, 10}, {10, 22, 10}, {10, 10, 22}},
                      {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
    return {spike, dented_tetrahedron(12, {2, 2, 2})};
  }

  /// Open solids that touch are disjoint.
  static std::optional<PolyhedronPolyhedron> as_open_sets(const PolyhedronPolyhedron& truth, const Question&) {
    if (truth.relation != Contact::touching) return std::nullopt;
    return PolyhedronPolyhedron{Contact::disjoint, truth.decided_by};
  }

  static Hooks<polyhedron_polyhedron> hooks() {
    return {.as_open_sets = as_open_sets,
            .repair = repair,
            .map_centre = map_centre,
            .domain_count = domain_count,
            .domain_at = domain_at,
            .laws = {.maps = Laws::Maps::axes, .scales = true, .exchanges = {{0, 1}}}};
  }

 private:
  template <class Change>
  static Meshd mapped(Meshd mesh, const Change& change) {
    for (Point3d& p : mesh.vertices) p = change(p);
    return mesh;
  }
  static Meshd shifted(const Meshd& mesh, const Vector3d& by) {
    return mapped(mesh, [&by](const Point3d& p) { return p + by; });
  }
  static Meshd scaled(const Meshd& mesh, double factor) {
    return mapped(mesh, [factor](const Point3d& p) { return Point3d{factor * p.x, factor * p.y, factor * p.z}; });
  }
  static double least_x(const Meshd& mesh) {
    double least = mesh.vertices[0].x;
    for (const Point3d& p : mesh.vertices) least = std::min(least, p.x);
    return least;
  }
  static double greatest_x(const Meshd& mesh) {
    double greatest = mesh.vertices[0].x;
    for (const Point3d& p : mesh.vertices) greatest = std::max(greatest, p.x);
    return greatest;
  }
  /// Faces in any order.
  static Question either_first(const reported::SolidPair& solids, DrawStream& c) {
    const Meshd a = relisted(solids.first, c), b = relisted(solids.second, c);
    return c.below(2) == 0 ? Question{a, b} : Question{b, a};
  }
  static Meshd moved(const Meshd& mesh, DrawStream& c, double unit, int most) {
    const double x = unit * small_integer(c, most), y = unit * small_integer(c, most);
    return shifted(mesh, {x, y, unit * small_integer(c, most)});
  }

  /// Both in one list of vertices, and again in two.
  template <class Change>
  static Question split(Meshd a, Meshd b, const Change& change) {
    Meshd all{a.vertices, {}};
    all.vertices.insert(all.vertices.end(), b.vertices.begin(), b.vertices.end());
    change(all);
    const auto middle = all.vertices.begin() + static_cast<std::ptrdiff_t>(a.vertices.size());
    a.vertices.assign(all.vertices.begin(), middle), b.vertices.assign(middle, all.vertices.end());
    return {a, b};
  }

  static std::vector<Whole> cells(DrawStream& c) {
    std::vector<Whole> drawn{{0, 0, 0}};
    for (const Whole& cell : {Whole{1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}})
      if (c.below(2) == 1) drawn.push_back(cell);
    return drawn;
  }

  /// A ring of cubes, or three in a row, its bars of another width and height.
  static Meshd link(DrawStream& c) {
    std::vector<Whole> of_cells;
    const bool ring = c.below(3) > 0;
    for (long i = 0; i < 9; ++i)
      if (ring ? i != 4 : i / 3 == 1) of_cells.push_back({i % 3, i / 3, 0});
    const double bar = 6 * static_cast<double>(2 - c.below(2)), height = 6 * static_cast<double>(1 + c.below(2));
    const auto narrowed = [bar](double n) { return n == 12 ? bar : n == 24 ? 36 - bar : n; };
    return mapped(cube_surface(of_cells), [=](const Point3d& p) {
      return Point3d{narrowed(p.x), narrowed(p.y), p.z == 0 ? 0 : height};
    });
  }

  static Meshd ordinary_solid(DrawStream& c) {
    Meshd mesh;
    for (int i = 0; i < 5; ++i) {
      const double x = ordinary(c), y = ordinary(c), z = ordinary(c);
      mesh.vertices.push_back({x, y, z});
    }
    make_solid(mesh);
    return mesh;
  }
};

}  // namespace touchstone::catalogue::rows
