// SPDX-License-Identifier: Apache-2.0
#include "robust/planes/point_ground_plane.h"  // all of it is inline
