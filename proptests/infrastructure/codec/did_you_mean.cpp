// SPDX-License-Identifier: Apache-2.0
#include "catalogue/codec/did_you_mean.h"

#include "proptests/catch.h"
#include "proptests/uses.h"

namespace touchstone::proptests::did_you_mean_tests {
namespace {

const std::vector<std::string> names{"orientation", "segment_segment", "ray_segment", "aabb_aabb", "line_line"};

}  // namespace

TEST_CASE("did you mean: a letter wrong, missing, too many or swapped with its neighbour is a misspelling") {
  for (const char* misspelt : {"oriemtation", "orientaton", "orientattion", "orientatoin", "Orientation"})
    CHECK(did_you_mean(misspelt, names) == " (did you mean \"orientation\"?)");
  CHECK(did_you_mean("line-line", names) == " (did you mean \"line_line\"?)");
  CHECK(did_you_mean("segmentsegment", names) == " (did you mean \"segment_segment\"?)");
}

TEST_CASE("did you mean: what has more than a third of its letters wrong is another name") {
  CHECK(did_you_mean("juggle", names).empty());
  CHECK(did_you_mean("", names).empty());
  // Three of nine letters, then four of nine.
  CHECK(did_you_mean("aabb_xxxb", names) == " (did you mean \"aabb_aabb\"?)");
  CHECK(did_you_mean("aabb_xxxx", names).empty());
  CHECK(did_you_mean(std::string(10'000'000, 'a'), names).empty());
}

TEST_CASE("did you mean: the same words in another order are the name, even beside one that is nearer") {
  const std::vector<std::string> known{"capsule_aabb", "ray_capsule", "capsule_rays"};
  CHECK(did_you_mean("capsule_ray", known) == " (did you mean \"ray_capsule\"?)");
  CHECK(did_you_mean("segment-Ray", names) == " (did you mean \"ray_segment\"?)");
  CHECK(did_you_mean("segment_rai", names).empty());
}

TEST_CASE("did you mean: three letters or more that a name begins with stand for it") {
  CHECK(did_you_mean("orient", names) == " (did you mean \"orientation\"?)");
  CHECK(did_you_mean("seg", names) == " (did you mean \"segment_segment\"?)");
  CHECK(did_you_mean("or", names).empty());
  CHECK(did_you_mean("entation", std::vector<const char*>{"or_entation_of"}).empty());
}

TEST_CASE("did you mean: of several equally near the first is named, and a nearer one before it") {
  CHECK(did_you_mean("lift", std::vector<const char*>{"left", "list", "right"}) == " (did you mean \"left\"?)");
  CHECK(did_you_mean("lists", std::vector<const char*>{"left", "list", "right"}) == " (did you mean \"list\"?)");
  CHECK(did_you_mean("x", std::vector<const char*>{"y"}).empty());
}

}  // namespace touchstone::proptests::did_you_mean_tests
