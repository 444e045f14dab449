// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/numbers/exact.h"
#include "catalogue/operation/row_of.h"
#include "oracle/truth.h"

namespace touchstone::proptests {

/// A row for tests alone: a word and a number that is always there. How high is the point over y = 0?
struct mandatory_number {
  using Question = std::tuple<Point2d>;
  using Answer = PointPlane<double>;
  using decision = catalogue::NoDecision;
  static void hard_cases(catalogue::HardCases<Question>&) {}
  static catalogue::Hooks<mandatory_number> hooks() { return {}; }

  static constexpr catalogue::Metadata metadata{.name = "mandatory_number", .fields = {"point"}};

  template <class Real>
  static PointPlane<Real> reference(const Point2<Real>& p) {
    return {p.y > Real(0) ? PlaneSide::front : p.y < Real(0) ? PlaneSide::back : PlaneSide::on, p.y};
  }
  static PointPlane<double> robust(const Point2d& p) { return reference(p); }
  static ::touchstone::oracle::Truth<PointPlane<mpq_class>> oracle(const Point2d& p) {
    const mpq_class height = catalogue::exact_value(p.y);
    return {reference(Point2<mpq_class>{0, height}), abs(height)};
  }
};

}  // namespace touchstone::proptests
