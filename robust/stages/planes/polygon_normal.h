// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/planes/polygon_normal.h"

namespace touchstone::robust::stages {

/// There is no filter: numbers have to be found.
struct polygon_normal {
  static Perhaps<PolygonNormal<double>> enclosed(const Polygon3d& polygon);
  static Perhaps<PolygonNormal<double>> lattice(const Polygon3d& polygon);
  static PolygonNormal<double> exact(const Polygon3d& polygon);
  static Decided<PolygonNormal<double>> ask(const Polygon3d& polygon);
};

}  // namespace touchstone::robust::stages
