// SPDX-License-Identifier: Apache-2.0
#include "robust/response/reflect_wall.h"  // all of it is inline
