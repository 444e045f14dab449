// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/bodies.h"
#include "geometry/capsules.h"
#include "geometry/closest.h"
#include "geometry/commands.h"
#include "geometry/complexity.h"
#include "geometry/impacts.h"
#include "geometry/penetration.h"
#include "geometry/point_mesh_distance.h"
#include "geometry/points.h"
#include "geometry/polygons.h"
#include "geometry/polyhedra.h"
#include "geometry/ray_mesh.h"
#include "geometry/rays.h"
#include "geometry/simultaneous.h"
#include "geometry/solids.h"
#include "geometry/space.h"
#include "geometry/steps.h"
#include "geometry/thin_shapes.h"
#include "geometry/triangles.h"
#include "geometry/volumes.h"
#include "geometry/words.h"

/// Every type of questions and answers, for programs that ask any operation.
