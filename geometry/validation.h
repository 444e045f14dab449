// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "geometry/invalid_input.h"
#include "geometry/polygons.h"
#include "geometry/polyhedra.h"
#include "geometry/rules.h"
#include "geometry/volumes.h"

/// Validation: what is valid input, for every shape by its members and rules, and for every number type. Each
/// `validate` throws InvalidInput naming the field and the rule, or returns.
///
/// The order of rules is one for all operations (docs/judging.md): first the numbers of all fields, `validate_numbers`;
/// then the rules of each field, `validate`; then those that tie several fields.
namespace touchstone::validation {

template <class T>
concept List = requires(const T& value) {
  value.begin();
  value.size();
};
template <class T>
concept Choice = requires(const T& value) {
  value.valueless_by_exception();
};

/// Decides whether a value has a number that is NaN or infinite. An int, so that many numbers make one branch; only
/// doubles can be so.
template <class T>
constexpr int not_finite(const T& value) {
  if constexpr (std::is_same_v<T, double>) {
    return static_cast<int>(!finite(value));
  } else if constexpr (Composite<T>) {
    return with_members(value, [](const auto&... member) { return (not_finite(member) | ...); });
  } else if constexpr (List<T>) {
    int found = 0;
    for (const auto& element : value) found |= not_finite(element);
    return found;
  } else if constexpr (Choice<T>) {
    return std::visit([](const auto& alternative) { return not_finite(alternative); }, value);
  } else {
    return 0;
  }
}
template <class... T>
bool all_finite(const T&... values) {
  return (not_finite(values) | ...) == 0;
}

/// Decides whether a value keeps its rules: its own, or those of all its parts.
template <class T, class Check>
bool keeps_rules(const T& value, const Check& check) {
  if constexpr (requires { value.rules(check); }) {
    return value.rules(check);
  } else if constexpr (Composite<T>) {
    std::size_t i = 0;
    return with_members(value, [&](const auto&... member) { return (check.part(T::members.at(i++), member) && ...); });
  } else if constexpr (List<T>) {
    for (std::size_t i = 0; i < value.size(); ++i)
      if (!check.part({"", i}, value[i])) return false;
    return true;
  } else if constexpr (Choice<T>) {
    return std::visit([&](const auto& alternative) { return keeps_rules(alternative, check); }, value);
  } else {
    return true;
  }
}
/// Says whether rules hold.
struct Asking {
  bool operator()(const Where&, const rule::Outcome& outcome) const { return outcome.holds; }
  template <class T>
  bool part(const Where&, const T& value) const {
    return keeps_rules(value, *this);
  }
};

/// Decides whether a value is valid. Names of fields cost more than the geometry, so they are made only for invalid
/// values.
template <class T>
bool valid(const T& value) {
  return all_finite(value) && keeps_rules(value, Asking());
}
/// And whether it keeps one more rule, which its type does not say.
template <class T, class Rule>
bool valid(const T& value, const Rule& rule) {
  return all_finite(value) && keeps_rules(value, Asking()) && rule(value).holds;
}

inline std::string named(const std::string& field, const Where& where) {
  std::string name = field + (*where.name == 0 ? "" : ".") + where.name;
  for (const std::size_t index : {where.i, where.j})
    if (index != Where::none) name += "[" + std::to_string(index) + "]";
  return name;
}
/// Refuses the first rule that does not hold.
struct Refusing {
  std::string field;
  bool operator()(const Where& where, const rule::Outcome& outcome) const {
    if (!outcome.holds) throw InvalidInput(named(field, where), outcome.words);
    return true;
  }
  template <class T>
  bool part(const Where& where, const T& value) const {
    return keeps_rules(value, Refusing{named(field, where)});
  }
};

/// Refuses the first number that is not finite.
template <class T>
void validate_numbers(const std::string& field, const T& value) {
  if (not_finite(value) == 0) return;
  if constexpr (Composite<T>) {
    std::size_t i = 0;
    with_members(value,
                 [&](const auto&... member) { (validate_numbers(named(field, T::members.at(i++)), member), ...); });
  } else if constexpr (List<T>) {
    for (std::size_t i = 0; i < value.size(); ++i)
      if (not_finite(value[i]) != 0) validate_numbers(named(field, {"", i}), value[i]);
  } else if constexpr (Choice<T>) {
    std::visit([&](const auto& alternative) { validate_numbers(field, alternative); }, value);
  } else {
    throw InvalidInput(field, "finite number");
  }
}
template <class T>
void validate(const std::string& field, const T& value) {
  if (valid(value)) return;
  validate_numbers(field, value);
  keeps_rules(value, Refusing{field});
}
template <class T, class Rule>
void validate(const std::string& field, const T& value, const Rule& rule) {
  validate(field, value);
  Refusing{field}("", rule(value));
}
/// A value that has to keep a rule of the operation besides its own.
template <class T, class Rule>
struct Under {
  const T& value;
  const Rule& rule;
};
template <class T, class Rule>
Under<T, Rule> under(const Rule& rule, const T& value) {
  return {value, rule};
}
template <class T, class Rule>
void validate_numbers(const std::string& field, const Under<T, Rule>& ruled) {
  validate_numbers(field, ruled.value);
}
template <class T, class Rule>
void validate(const std::string& field, const Under<T, Rule>& ruled) {
  validate(field, ruled.value, ruled.rule);
}

inline void validate_all_numbers() {}
template <class T, class... Others>
void validate_all_numbers(const char* field, const T& value, const Others&... others) {
  validate_numbers(field, value), validate_all_numbers(others...);
}
inline void validate_each() {}
template <class T, class... Others>
void validate_each(const char* field, const T& value, const Others&... others) {
  validate(field, value), validate_each(others...);
}
/// The numbers of all fields, and then the rules of each: validate_all("ray", ray, "e", under(rule::restitution, e)).
template <class... FieldsAndValues>
void validate_all(const FieldsAndValues&... fields_and_values) {
  validate_all_numbers(fields_and_values...), validate_each(fields_and_values...);
}
/// Refuses a value by a rule that was decided in exact arithmetic.
[[noreturn]] inline void refuse(const std::string& field, const rule::Exact& rule) {
  throw InvalidInput(named(field, rule.member), rule.words);
}

/// A polygon without the position that closes it; it has to outlive this.
template <class Polygon>
class OpenRing {
 public:
  explicit OpenRing(const Polygon& given) : given_(given) {
    if (closed(given.vertices)) dropped_ = {{given.vertices.begin(), given.vertices.end() - 1}};
  }
  const Polygon& operator*() const { return dropped_.vertices.empty() ? given_ : dropped_; }

 private:
  const Polygon& given_;
  Polygon dropped_;
};

/// The reason why a ring is not simple: edge `first` has length zero (and `second` is the same), or meets edge `second`
/// > first elsewhere than in a vertex that neighbours share. Edge i goes from vertex i to the next. The defect with the
/// least `first` counts, edges of length zero before all others, then the least `second`.
struct RingDefect {
  std::size_t first, second;
};

/// Refuses a ring of so many vertices.
[[noreturn]] inline void refuse(const std::string& field, const RingDefect& defect, std::size_t vertices) {
  const std::string vertex = field + "[" + std::to_string(defect.first) + "]";
  const std::string next = std::to_string((defect.first + 1) % vertices);
  if (defect.first == defect.second)
    throw InvalidInput(vertex, "different from vertex " + next + ": drop one of the two");
  throw InvalidInput(vertex, "simple: its edge must not meet edge " + std::to_string(defect.second));
}

/// The reason why simple rings make no region: the first hole that is not within the outer ring or has more than single
/// points of its boundary in common with it (`other` is the hole itself); or that has more than such points in common
/// with hole `other`, the first before it; the outer ring comes before these.
struct HoleDefect {
  std::size_t hole, other;
};
[[noreturn]] inline void refuse(const std::string& field, const HoleDefect& defect) {
  const std::string named_hole = named(field, {"holes", defect.hole});
  if (defect.hole == defect.other)
    throw InvalidInput(named_hole, "inside the outer ring, which it may touch in single points only");
  throw InvalidInput(named_hole,
                     "outside hole " + std::to_string(defect.other) + ", which it may touch in single points only");
}

/// Why a polygon is not convex, in this order: an edge of length zero; all vertices on one line; a RingDefect; the
/// first vertex at which the ring turns against its direction.
[[noreturn]] inline void refuse_flat(const std::string& field) {
  throw InvalidInput(field, "convex: vertices on one line have no inside");
}
[[noreturn]] inline void refuse_reflex(const std::string& field, std::size_t vertex) {
  throw InvalidInput(field + "[" + std::to_string(vertex) + "]",
                     "convex: the ring must not turn against its direction");
}

/// A mesh named by polygons, in this order: a corner names no vertex; the triangles are not as many as a cut of them
/// has; the corners of a face are not in one plane; the triangles of a face do not cut it.
[[noreturn]] inline void refuse_cut(const std::string& field) { refuse(field, Meshd::cut_of_faces); }
[[noreturn]] inline void refuse_askew(const std::string& field, std::size_t polygon) {
  throw InvalidInput(field + ".faces[" + std::to_string(polygon) + "]", "planar");
}

[[noreturn]] inline void refuse_ring(const std::string& field, std::size_t polygon) {
  throw InvalidInput(field + ".faces[" + std::to_string(polygon) + "]",
                     "a polygon that encloses one area and does not cross itself");
}

/// The face of which that triangle is a part.
template <class Real>
[[noreturn]] void refuse_face(const std::string& field, const Mesh<Real>& mesh, std::size_t triangle,
                              const std::string& rule) {
  throw InvalidInput(field + ".faces[" + std::to_string(named_face_of_each(mesh)[triangle]) + "]", rule);
}

/// The rules of every surface of triangles around a solid that take no arithmetic.
template <class Real>
void validate_triangles(const std::string& field, const Mesh<Real>& mesh) {
  for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
    const Face& f = mesh.faces[i];
    if (f.a == f.b || f.b == f.c || f.c == f.a) refuse_face(field, mesh, i, "three different vertices");
  }
  if (named_faces(mesh) < 4) throw InvalidInput(field, "at least 4 faces");
}

/// The reason why a mesh is no closed convex surface, in this order: an edge of a face that another face has in the
/// same direction or that none has in the opposite one; a face of area zero; all vertices on one plane; a vertex beyond
/// the plane of a face. The first such face counts, and in it the first edge (a to b, b to c, c to a) or the first
/// vertex.
template <class Real>
[[noreturn]] void refuse_edge(const std::string& field, const Mesh<Real>& mesh, std::size_t triangle, Index from,
                              Index to) {
  const std::string a = std::to_string(from), b = std::to_string(to);
  refuse_face(field, mesh, triangle,
              "closed: edge " + a + " -> " + b + " must occur once, and " + b + " -> " + a + " once");
}
template <class Real>
[[noreturn]] void refuse_area(const std::string& field, const Mesh<Real>& mesh, std::size_t triangle) {
  refuse_face(field, mesh, triangle, "nonzero area");
}
[[noreturn]] inline void refuse_flat_mesh(const std::string& field) {
  throw InvalidInput(field, "convex: vertices on one plane have no inside");
}
template <class Real>
[[noreturn]] void refuse_beyond(const std::string& field, const Mesh<Real>& mesh, std::size_t triangle,
                                std::size_t vertex) {
  refuse_face(field, mesh, triangle, "convex: vertex " + std::to_string(vertex) + " must not lie beyond its plane");
}

}  // namespace touchstone::validation
