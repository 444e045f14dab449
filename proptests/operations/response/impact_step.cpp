// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/response/impact_step.h"

#include "proptests/response_laws.h"

namespace touchstone::proptests::impact_step_tests {}
