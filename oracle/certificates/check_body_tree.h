// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "oracle/certificates/check_space.h"

/// The bodies that a box, a point or a ray meets; check_broad_phase.cpp describes the checks.
namespace touchstone::certify {

/// The fact `axis`: 0, 1 or 2.
std::size_t axis(const Claim& claim);
/// A number of the certificate that is an index in a list.
std::size_t place(const Rational& index, std::size_t size);
const json& list(const json& object, const char* name, const std::string& what);

struct RayInSpace {
  Triple origin, direction;
};
RayInSpace ray_in_space(const json& value, const std::string& what);

struct BoxedBody {
  json written;
  Box box;
};
/// Bodies by their indices.
struct BoxedBodies {
  std::map<std::uint64_t, BoxedBody> there{};
  std::uint64_t next = 0;   ///< total number so far
  std::size_t changes = 0;  ///< commands that changed them
};

class BodyTree;

/// The trees of a certificate, each read when a query first names it.
class BodyTrees {
 public:
  explicit BodyTrees(const Claim& claim);
  ~BodyTrees();
  BodyTrees(const BodyTrees&) = delete;
  BodyTrees& operator=(const BodyTrees&) = delete;

  /// The tree that the proof of a query names.
  BodyTree& named(const Claim& query, const BoxedBodies& bodies);
  void expect_used() const;

 private:
  Claim claim_;
  std::vector<std::unique_ptr<BodyTree>> trees_;
};

/// The bodies that the query, input of the claim, is proved to meet, by their indices, or for a ray in the order of the
/// first t. Certificate: `each_body`, `each_along`, or `by_tree`.
std::vector<std::uint64_t> met_bodies(const Claim& query, const BoxedBodies& bodies, BodyTrees& trees);

}  // namespace touchstone::certify
