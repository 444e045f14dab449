// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <new>
#include <string>
#include <string_view>

#include "geometry/invalid_input.h"
#include "robust/kernel/filters/strict_math.h"
#include "touchstone_robust.h"

/// Shared by the functions for C: no exception leaves them.
namespace touchstone::robust::c {

/// Fills in the error if the caller wants it, and returns the code. "questions[17].p1[0]" becomes the question 17 and
/// the field "p1[0]". Text longer than its buffer is truncated.
int failed(touchstone_error* error, touchstone_code code, std::string_view field, std::string_view rule) noexcept;

/// Calls call(), and returns its code, or that of its exception.
template <class Call>
int answered(touchstone_error* error, const Call& call) noexcept {
  try {
    call();
    return TOUCHSTONE_OK;
  } catch (const InvalidInput& refused) {
    return failed(error, TOUCHSTONE_INVALID_INPUT, refused.field(), refused.rule());
  } catch (const std::bad_alloc&) {
    return failed(error, TOUCHSTONE_OUT_OF_MEMORY, "", "enough memory");
  } catch (const std::exception& unexpected) {
    return failed(error, TOUCHSTONE_FAILED, "", unexpected.what());
  } catch (...) {
    return failed(error, TOUCHSTONE_FAILED, "", "an error of an unknown type");
  }
}

}  // namespace touchstone::robust::c
