// SPDX-License-Identifier: Apache-2.0
// The compiled part of the Python module: the functions of touchstone_robust.h over buffers, and those of touchstone.h.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <atomic>
#include <cstring>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "c/touchstone.h"
#include "robust/c/array_forms.h"
#include "robust/structures/polygon_mesh.h"

namespace touchstone::python {
namespace {

namespace py = pybind11;

[[noreturn]] void raise_refusal(const std::string& field, const std::string& rule) {
  const py::object type = py::module_::import("touchstone._errors").attr("InvalidInput");
  PyErr_SetObject(type.ptr(), type(field, rule).ptr());
  throw py::error_already_set();
}

[[noreturn]] void raise_error(int code, const touchstone_error& error) {
  if (code == TOUCHSTONE_OUT_OF_MEMORY) throw std::bad_alloc();
  if (code == TOUCHSTONE_FAILED) throw std::runtime_error(std::string("a defect of touchstone: ") + error.rule);
  if (code == TOUCHSTONE_REFUSED) {
    PyErr_SetString(py::module_::import("touchstone._errors").attr("CertificateRefused").ptr(), error.rule);
    throw py::error_already_set();
  }
  std::string field = error.field;
  if (error.question != TOUCHSTONE_NO_QUESTION) field = "questions[" + std::to_string(error.question) + "]." + field;
  raise_refusal(field, error.rule);
}

/// The operands that Python passes, one after the other: arrays, each with its number of axes other than rows. The
/// caller has checked shapes and alignment, and names the fields; the checks here keep a wrong caller from reading out
/// of bounds.
class Operands {
 public:
  Operands(const py::sequence& arrays, std::size_t count) {
    for (std::size_t i = 0; i + 1 < arrays.size(); i += 2) {
      held_.push_back(py::cast<py::buffer>(arrays[i]).request());
      const auto axes = py::cast<py::ssize_t>(arrays[i + 1]);
      if (axes == matrix_axes) matrices_.push_back(held_.size() - 1);
      else add_columns(held_.back(), axes, count);
    }
  }

  template <class Shape>
  Shape next() {
    if constexpr (std::is_same_v<Shape, touchstone_polygon2>) {
      const py::buffer_info& vertices = matrix("d", 2);
      return {static_cast<const double*>(vertices.ptr), static_cast<std::size_t>(vertices.shape[0])};
    } else if constexpr (std::is_same_v<Shape, touchstone_mesh>) {
      const py::buffer_info& vertices = matrix("d", 3);
      const py::buffer_info& faces = matrix("I", 3);
      return {static_cast<const double*>(vertices.ptr), static_cast<std::size_t>(vertices.shape[0]),
              static_cast<const std::uint32_t*>(faces.ptr), static_cast<std::size_t>(faces.shape[0])};
    } else {
      // A shape consists of columns and nothing else.
      static_assert(sizeof(Shape) % sizeof(touchstone_column) == 0 && std::is_trivially_copyable_v<Shape>);
      if (columns_.size() - column_ < sizeof(Shape) / sizeof(touchstone_column))
        throw std::invalid_argument("fewer columns than operands have");
      Shape shape;
      std::memcpy(&shape, columns_.data() + column_, sizeof shape);
      column_ += sizeof(Shape) / sizeof(touchstone_column);
      return shape;
    }
  }
  void require_end() const {
    if (column_ != columns_.size() || matrix_ != matrices_.size())
      throw std::invalid_argument("more columns than operands have");
  }

 private:
  static constexpr py::ssize_t matrix_axes = -1;  ///< of one polygon or mesh shared by all rows

  /// Adds the columns of an array: its first axis holds the rows if there is one more axis, otherwise all rows share
  /// it.
  void add_columns(const py::buffer_info& array, py::ssize_t axes, std::size_t count) {
    bool right = array.format == "d" && (array.ndim == axes || array.ndim == axes + 1) &&
                 reinterpret_cast<std::uintptr_t>(array.ptr) % alignof(double) == 0;
    for (const py::ssize_t stride : array.strides) right = right && stride % 8 == 0;
    if (!right) throw std::invalid_argument("an array of aligned float64 was expected");
    const auto rows_axis = static_cast<std::size_t>(array.ndim - axes);
    const bool shared = rows_axis == 0 || array.shape[0] == 1;
    if (!shared && static_cast<std::size_t>(array.shape[0]) != count)
      throw std::invalid_argument("an array has another number of rows than there are answers");
    const std::ptrdiff_t stride = shared ? 0 : array.strides[0] / 8;
    std::vector<std::ptrdiff_t> places{0};
    for (std::size_t axis = rows_axis; axis < array.shape.size(); ++axis) {
      std::vector<std::ptrdiff_t> finer;
      for (const std::ptrdiff_t place : places) {
        for (py::ssize_t i = 0; i < array.shape[axis]; ++i) finer.push_back(place + i * (array.strides[axis] / 8));
      }
      places = std::move(finer);
    }
    for (const std::ptrdiff_t place : places)
      columns_.push_back({static_cast<const double*>(array.ptr) + place, stride});
  }
  const py::buffer_info& matrix(const char* format, py::ssize_t columns) {
    if (matrix_ == matrices_.size()) throw std::invalid_argument("fewer matrices than operands have");
    const py::buffer_info& rows = held_[matrices_[matrix_++]];
    if (rows.format != format || rows.ndim != 2 || rows.shape[1] != columns ||
        (rows.size > 0 && (rows.strides[1] != rows.itemsize || rows.strides[0] != rows.itemsize * columns)))
      throw std::invalid_argument("a contiguous matrix was expected");
    return rows;
  }

  std::vector<py::buffer_info> held_;
  std::vector<touchstone_column> columns_;
  std::vector<std::size_t> matrices_;
  std::size_t column_ = 0, matrix_ = 0;
};

std::atomic<std::size_t> threads = 1;  // of each call

/// Calls form(error) while other threads may run, and raises its error.
template <class Call>
void call(const Call& form) {
  touchstone_error error{};
  int code = TOUCHSTONE_OK;
  {
    const py::gil_scoped_release others_may_run;
    touchstone_use_threads(threads);
    code = form(&error);
  }
  if (code != TOUCHSTONE_OK) raise_error(code, error);
}

/// Calls a function of touchstone_robust.h: operands..., count, answers, error.
template <class... Arguments>
void decide_by(int (*form)(Arguments...), const py::sequence& arrays, std::size_t count, std::uint8_t* answers) {
  using Passed = std::tuple<Arguments...>;
  constexpr std::size_t shapes = sizeof...(Arguments) - 3;
  Passed passed;
  Operands operands(arrays, count);
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    ((std::get<i>(passed) = operands.next<std::tuple_element_t<i, Passed>>()), ...);
  }
  (std::make_index_sequence<shapes>());
  operands.require_end();
  std::get<shapes>(passed) = count;
  std::get<shapes + 1>(passed) = answers;
  call([&](touchstone_error* error) {
    std::get<shapes + 2>(passed) = error;
    return std::apply(form, passed);
  });
}

using Decide = void (*)(const py::sequence& arrays, std::size_t count, std::uint8_t* answers);
#define TOUCHSTONE_ENTRY(name)                                                       \
  {#name, [](const py::sequence& arrays, std::size_t count, std::uint8_t* answers) { \
     decide_by(touchstone_##name, arrays, count, answers);                           \
   }},
const std::map<std::string, Decide> decisions{TOUCHSTONE_ARRAY_FORMS(TOUCHSTONE_ENTRY)};

/// A shape of touchstone_robust.h that was validated once, and what makes and frees it.
template <class Shape>
class Prepared {
 public:
  template <class Given>
  Prepared(int (*make)(Given, Shape**, touchstone_error*), void (*release)(Shape*), const py::sequence& arrays)
      : release_(release) {
    Operands operands(arrays, 0);
    const auto given = operands.next<Given>();
    operands.require_end();
    call([&](touchstone_error* error) { return make(given, &shape_, error); });
  }
  ~Prepared() { release_(shape_); }
  Prepared(const Prepared&) = delete;
  Prepared& operator=(const Prepared&) = delete;

  template <class Points>
  void decide(int (*form)(const Shape*, Points, std::size_t, std::uint8_t*, touchstone_error*),
              const py::sequence& arrays, std::size_t count, std::uint8_t* answers) const {
    Operands operands(arrays, count);
    const auto points = operands.next<Points>();
    operands.require_end();
    call([&](touchstone_error* error) { return form(shape_, points, count, answers, error); });
  }

 private:
  Shape* shape_ = nullptr;
  void (*release_)(Shape*);
};

/// Decides by a prepared shape if one of the operands is one that the decision takes.
bool decided_of_prepared(const std::string& decision, const py::sequence& arrays, std::size_t count,
                         std::uint8_t* answers) {
  const auto is_array = [](const py::handle& operand) { return py::isinstance<py::buffer>(operand); };
  std::size_t place = 0;
  while (place < arrays.size() && is_array(arrays[place])) place += 2;
  if (place >= arrays.size()) return false;
  py::list others;
  for (std::size_t i = 0; i < arrays.size(); ++i)
    if (i / 2 != place / 2) others.append(arrays[i]);
#define TOUCHSTONE_DECIDED(name, Shape, shape)                                                                    \
  if (decision == #name && py::isinstance<Prepared<shape>>(arrays[place])) {                                      \
    py::cast<const Prepared<shape>&>(arrays[place]).decide(touchstone_##name##_prepared, others, count, answers); \
    return true;                                                                                                  \
  }
  TOUCHSTONE_PREPARED_FORMS(TOUCHSTONE_DECIDED)
  return false;
}

void add_prepared(py::module_& module) {
#define TOUCHSTONE_ADDED(name, Shape, shape)                                                \
  py::class_<Prepared<shape>>(module, #Shape).def(py::init([](const py::sequence& arrays) { \
    return std::make_unique<Prepared<shape>>(shape##_make, shape##_free, arrays);           \
  }));
  TOUCHSTONE_PREPARED_FORMS(TOUCHSTONE_ADDED)
}

void decide(const std::string& name, const py::sequence& arrays, const py::buffer& out) {
  const py::buffer_info answers = out.request(/*writable=*/true);
  if (answers.format != "B" || answers.ndim != 1 || (answers.shape[0] > 1 && answers.strides[0] != 1))
    throw std::invalid_argument("out: contiguous uint8 was expected");
  const auto count = static_cast<std::size_t>(answers.shape[0]);
  auto* const to = static_cast<std::uint8_t*>(answers.ptr);
  if (!decided_of_prepared(name, arrays, count, to)) decisions.at(name)(arrays, count, to);
}

/// Cuts polygons into triangles; `sizes` gives the number of `corners` of each polygon.
py::array_t<std::uint32_t> cut(const py::array_t<double>& vertices, const py::array_t<std::uint32_t>& corners,
                               const py::array_t<std::int64_t>& sizes) {
  const auto points = vertices.unchecked<2>();
  const auto places = corners.unchecked<1>();
  const auto lengths = sizes.unchecked<1>();
  std::vector<Point3d> positions;
  for (py::ssize_t i = 0; i < points.shape(0); ++i) positions.push_back({points(i, 0), points(i, 1), points(i, 2)});
  std::vector<std::vector<Index>> polygons;
  py::ssize_t next = 0;
  for (py::ssize_t i = 0; i < lengths.shape(0); ++i) {
    if (lengths(i) < 0 || lengths(i) > places.shape(0) - next)
      throw std::invalid_argument("fewer corners than sizes say");
    std::vector<Index>& polygon = polygons.emplace_back();
    for (const py::ssize_t end = next + lengths(i); next < end; ++next) polygon.push_back(places(next));
  }
  std::vector<Face> faces;
  try {
    const py::gil_scoped_release others_may_run;
    faces = robust::polygon_mesh(std::move(positions), std::move(polygons)).faces;
  } catch (const InvalidInput& refused) {
    raise_refusal(refused.field(), refused.rule());
  }
  py::array_t<std::uint32_t> triangles({static_cast<py::ssize_t>(faces.size()), py::ssize_t{3}});
  auto written = triangles.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < written.shape(0); ++i) {
    const auto& [a, b, c] = faces[static_cast<std::size_t>(i)];
    written(i, 0) = a, written(i, 1) = b, written(i, 2) = c;
  }
  return triangles;
}

/// Returns the text that a function of touchstone.h produces.
template <class Call>
std::string text_of(const Call& producing) {
  char* result = nullptr;
  call([&](touchstone_error* error) { return producing(&result, error); });
  const std::string text = result;
  touchstone_free(result);
  return text;
}

}  // namespace
}  // namespace touchstone::python

using touchstone::python::text_of;
namespace py = pybind11;

PYBIND11_MODULE(_touchstone, module) {
  touchstone::python::add_prepared(module);
  module.def("decide", touchstone::python::decide);
  module.def("cut", touchstone::python::cut);
  module.def("use_threads", [](std::size_t count) { touchstone::python::threads = count; });
  module.def("answer", [](const std::string& operation, const std::string& question) {
    return text_of([&](char** result, touchstone_error* error) {
      return touchstone_answer(operation.c_str(), question.c_str(), result, error);
    });
  });
  module.def("truth", [](const std::string& operation, const std::string& question) {
    return text_of([&](char** result, touchstone_error* error) {
      return touchstone_truth(operation.c_str(), question.c_str(), result, error);
    });
  });
  module.def("certify", [](const std::string& claim) {
    touchstone::python::call([&](touchstone_error* error) { return touchstone_certify(claim.c_str(), error); });
  });
  module.def("draw",
             [](const std::string& operation, const std::string& families, std::uint64_t cases, std::uint64_t seed) {
               return text_of([&](char** result, touchstone_error* error) {
                 return touchstone_draw(operation.c_str(), families.c_str(), cases, seed, result, error);
               });
             });
  module.def("operations", [] { return text_of(touchstone_operations); });
}
