// SPDX-License-Identifier: Apache-2.0
#include "robust/volumes/closest_point_on_aabb.h"  // all of it is inline
