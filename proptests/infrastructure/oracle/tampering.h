// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

/// Claims that are tampered with in one place: what stands there is left out, repeated, exchanged or replaced.
namespace touchstone::proptests {

class Tampering {
  using json = nlohmann::json;
  using Place = json::json_pointer;

 public:
  /// `genuine`: true claims of one operation. What one of them holds in a place may replace what another holds there.
  /// `kinds`: of certificates, whatever operation they belong to.
  Tampering(std::vector<json> genuine, const std::set<std::string>& kinds) : genuine_(std::move(genuine)) {
    strings_["kind"] = kinds;
    for (const json& claim : genuine_) {
      for (const Place& place : places(claim)) {
        if (claim[place].is_string()) strings_[place.back()].insert(claim[place].get<std::string>());
      }
    }
  }

  /// The parts of a claim, each before the parts of it. Of a long list the first three and the last, because what is
  /// wrong with one of a hundred angles is wrong with the others.
  static std::vector<Place> places(const json& claim) {
    std::vector<Place> found;
    for (const char* field : {"op", "input", "truth", "certificate"}) add(claim, Place() / field, found);
    return found;
  }

  /// What no claim may hold in that place, so that it has to be refused.
  static std::vector<json> malformed(const json& claim, const Place& place) {
    std::vector<json> result;
    for (const json& junk : {json(nullptr), json::array(), json::object(), json("junk"), json(true)}) {
      if (claim[place].is_string() || claim[place].type() != junk.type()) replace(claim, place, junk, result);
    }
    if (claim[place].is_object()) replace(claim, place / "more", "1", result);
    if (claim[place.parent_pointer()].is_object() && place.back() != "method") {  // an optional field
      result.push_back(claim), result.back()[place.parent_pointer()].erase(place.back());
    }
    return result;
  }

  /// What may be false in that place. Some of it is true: the vertices of a face in another order, another ball.
  std::vector<json> altered(const json& claim, const Place& place) const {
    std::vector<json> result;
    for (const json& value : others(claim[place], place.back())) replace(claim, place, value, result);
    for (const json& other : genuine_) {
      if (!other.contains(place)) continue;
      replace(claim, place, other[place], result);
      if (place != Place("/truth") || other[place] == claim[place]) continue;
      replace(json(result.back()), Place("/certificate"), other["certificate"], result);
    }
    const json& siblings = claim[place.parent_pointer()];
    if (siblings.is_array()) {
      result.push_back(claim), result.back()[place.parent_pointer()].erase(std::stoul(place.back()));
    }
    std::size_t tried = 0;
    for (const auto& sibling : siblings.items()) {  // the same as that, and exchanged with it
      if (++tried > 8) break;
      if (sibling.value() == claim[place] || sibling.value().type() != claim[place].type()) continue;
      replace(claim, place, sibling.value(), result);
      replace(json(result.back()), place.parent_pointer() / sibling.key(), claim[place], result);
    }
    return result;
  }

 private:
  static void add(const json& claim, const Place& at, std::vector<Place>& found) {
    found.push_back(at);
    const json& here = claim[at];
    for (std::size_t i = 0; here.is_array() && i < here.size(); ++i) {
      if (i < 3 || i + 1 == here.size()) add(claim, at / i, found);
    }
    if (!here.is_object()) return;
    for (const auto& field : here.items()) add(claim, at / field.key(), found);
  }

  static void replace(const json& claim, const Place& place, const json& value, std::vector<json>& result) {
    json broken = claim;
    broken[place] = value;
    if (broken != claim) result.push_back(std::move(broken));
  }

  std::vector<json> others(const json& value, const std::string& name) const {
    std::vector<json> result;
    if (value.is_array() && !value.empty()) {
      result.push_back(json::array());
      result.push_back(value), result.back().push_back(value.back());
      result.push_back(value), std::reverse(result.back().begin(), result.back().end());
      result.push_back(json(value.size(), value[0]));
      result.push_back(zeros(value));
    }
    if (value.is_boolean()) result.push_back(!value.get<bool>());
    if (value.is_number()) {
      const double number = value.get<double>();
      for (const double other : {0.0, -number, number + 1, 2 * number}) result.push_back(other);
      for (const char* other : {"inf", "-0x1p-1074", "0x1.00000000000001p+0"}) result.push_back(other);
    }
    if (value.is_number_unsigned()) {
      const unsigned place = value.get<unsigned>();
      for (const unsigned other : {0u, place + 1, place + 1'000'000}) result.push_back(other);
    }
    if (!value.is_string()) return result;
    if (const auto found = strings_.find(name); found != strings_.end()) {
      result.insert(result.end(), found->second.begin(), found->second.end());
    }
    if (mpq_class number; number.set_str(value.get<std::string>(), 10) == 0) {
      const mpq_class tiny(1, mpz_class(1) << 1200), nearly_one = 1 + mpq_class(1, mpz_class(1) << 50);
      const mpq_class near_it[] = {number + 1, -number, 2 * number, number * nearly_one, number + tiny};
      for (const mpq_class& other : near_it) result.push_back(other.get_str());
      for (const char* other : {"0", "1", "1/2", "1/0", "0+1*sqrt(2)", "0+1*sqrt(4)", "1-1*sqrt(2)", "0+1*sqrt(-1)"})
        result.push_back(other);
      result.push_back(number.get_d());
    }
    return result;
  }

  /// The same with 0 for every number.
  static json zeros(const json& value) {
    if (value.is_string()) return "0";
    if (!value.is_structured()) return 0u;
    json result = value;
    for (json& part : result) part = zeros(part);
    return result;
  }

  std::vector<json> genuine_;
  std::map<std::string, std::set<std::string>> strings_;  ///< by the field's name
};

}  // namespace touchstone::proptests
