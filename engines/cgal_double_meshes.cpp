// SPDX-License-Identifier: Apache-2.0
// CGAL as peer: surfaces and triangles by its kernel over plain doubles, which the manual does not call robust.
// Under the GPL with what it includes.
#include <CGAL/Simple_cartesian.h>
#include <touchstone/program/engine_main.h>

#include "cgal_meshes.h"

using namespace touchstone;

struct CgalDoubleMeshes : CgalMeshes<CGAL::Simple_cartesian<double>> {
  static constexpr const char* name = "CGAL Simple_cartesian<double> " CGAL_VERSION_STR " (triangles, surfaces)";
  static constexpr auto boundary = Boundary::closed;
};

TOUCHSTONE_ENGINE_MAIN(CgalDoubleMeshes)
