// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "catalogue/codec/did_you_mean.h"
#include "catalogue/codec/expected.h"
#include "catalogue/codec/json.h"
#include "catalogue/codec/plain.h"

namespace touchstone::c {

using namespace catalogue;

/// The options of a call: an object whose fields are read one by one, and must then all have been.
class Options {
 public:
  explicit Options(const char* text) : fields_(text == nullptr ? Json::object() : plain(parse_line(text))) {
    if (!fields_.is_object()) throw InvalidInput("options", expected("one JSON object", fields_));
  }
  void read(const char* name, bool& flag) {
    read_if(name, "true or false", [&](const Json& value) {
      if (value.is_boolean()) flag = value.get<bool>();
      return value.is_boolean();
    });
  }
  void read(const char* name, std::uint64_t& count) {
    read_if(name, "an integer from 0", [&](const Json& value) {
      const double number = value.is_number() ? value.get<double>() : -1;
      const bool right = number >= 0 && number <= 0x1p53 && number == std::trunc(number);
      if (right) count = static_cast<std::uint64_t>(number);
      return right;
    });
  }
  void read(const char* name, std::string& text) {
    read_if(name, "text", [&](const Json& value) {
      if (value.is_string()) text = value.get<std::string>();
      return value.is_string();
    });
  }
  void read(const char* name, std::vector<std::string>& names) {
    read_if(name, "a list of names", [&](const Json& value) {
      for (const Json& entry : value) {
        if (!entry.is_string()) return false;
        names.push_back(entry.get<std::string>());
      }
      return value.is_array();
    });
  }
  void require_known() const {
    for (const auto& [key, value] : fields_.items()) {
      if (std::find(known_.begin(), known_.end(), key) == known_.end())
        throw InvalidInput("options." + key, "no such option" + did_you_mean(key, known_));
    }
  }

 private:
  template <class Take>
  void read_if(const char* name, const char* rule, const Take& take) {
    known_.emplace_back(name);
    const auto at = fields_.find(name);
    if (at != fields_.end() && !take(*at)) throw InvalidInput("options." + known_.back(), expected(rule, *at));
  }

  Json fields_;
  std::vector<std::string> known_;
};

}  // namespace touchstone::c
