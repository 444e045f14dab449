// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/codec/json.h"
#include "catalogue/numbers/true_number.h"
#include "catalogue/shape/shape.h"

/// Conversion of values to and from JSON, by their shapes.
namespace touchstone::catalogue {

template <class Real>
using WriteNumber = Json (*)(const Real&);
template <class Real>
using ReadNumber = Real (*)(const Json&, const std::string& field);

inline Json written(const TrueNumber& value) { return value.text(); }

/// Double, mpq_class, or the truth's numbers.
template <class Real>
Json json_of(const Shape& shape, Cursor<Real>& at, WriteNumber<Real> write);
template <class Real>
Json json_of(const Shape& shape, const EncodedValue<Real>& encoded, WriteNumber<Real> write) {
  Cursor<Real> at(encoded);
  return json_of(shape, at, write);
}

/// True if a value may be omitted in the input: it is optional, or all its parts are.
bool can_be_left_out(const Shape& shape, bool partial);

/// Appends the value to the encoded value. Throws InvalidInput naming the path and the rule. In a partial reading any
/// number may be omitted: each is preceded in the encoded value by a flag that tells whether it is present. Double or
/// mpq_class.
template <class Real>
void read_json(const Shape& shape, const Json& json, const std::string& path, EncodedValue<Real>& encoded,
               ReadNumber<Real> read, bool partial = false);

/// The shape itself: "number", "on | off", ["number", "number"], {"t?": "number"}. A name that ends in ? may be
/// omitted.
Json json_of(const Shape& shape);

/// A typed value in JSON: numbers may be doubles or rationals.
template <class T>
Json to_json(const T& value) {
  using Real = number_of_t<T>;
  return json_of<Real>(shape_of<rebound_t<T, double>>(), packed_as<Real>(value),
                       [](const Real& number) { return written(number); });
}
template <class T>
void read(const Json& json, const std::string& path, T& value, ReadNumber<double> read_number) {
  EncodedValue<double> encoded;
  read_json(shape_of<T>(), json, path, encoded, read_number);
  value = unpacked<T>(encoded);
}

}  // namespace touchstone::catalogue
