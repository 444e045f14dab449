// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/volumes.h"
#include "robust/kernel/shapes/plane.h"
#include "robust/kernel/shapes/valid.h"

/// Parallelepipeds on integers: Integer is std::int64_t (a lattice) or mpz_class, as in plane.h.
namespace touchstone::robust::kernel {

/// Refuses a box whose numbers are not finite or whose half axes are linearly dependent.
void validate_obb(const std::string& field, const Obb3d& box);

/// Refuses numbers of either that are not finite, then what breaks a rule of the solid, then of the box.
template <class Solid>
void validate_with_obb(const std::string& field, const Solid& solid, const std::string& field_of_box,
                       const Obb3d& box) {
  if (!valid(solid)) {
    validation::validate_numbers(field, solid), validation::validate_numbers(field_of_box, box);
    validation::validate(field, solid);
  }
  validate_obb(field_of_box, box);
}

/// On a lattice vectors are below 2^62, and an axis below 2^125.
template <class Integer>
Vector3<Second<Integer>> axis_across(const Vector3<Integer>& v, const Vector3<Integer>& w) {
  return {multiply(v.y, w.z) - multiply(v.z, w.y), multiply(v.z, w.x) - multiply(v.x, w.z),
          multiply(v.x, w.y) - multiply(v.y, w.x)};
}

/// axis . v; on a lattice below 2^189.
template <class Integer>
Third<Integer> product_with_axis(const Vector3<Second<Integer>>& axis, const Vector3<Integer>& v) {
  return multiply(axis.x, v.x) + multiply(axis.y, v.y) + multiply(axis.z, v.z);
}

/// |axis . v|
template <class Integer>
Third<Integer> along_axis(const Vector3<Second<Integer>>& axis, const Vector3<Integer>& v) {
  const Third<Integer> sum = product_with_axis(axis, v);
  return sign_of(sum) < 0 ? Third<Integer>(-sum) : sum;
}

}  // namespace touchstone::robust::kernel
