// SPDX-License-Identifier: Apache-2.0
/// Every type of questions and answers, described: for programs that ask any operation.
#pragma once

#include "catalogue/shape/described_answers.h"
#include "catalogue/shape/described_bodies.h"
#include "catalogue/shape/described_capsules.h"
#include "catalogue/shape/described_closest.h"
#include "catalogue/shape/described_commands.h"
#include "catalogue/shape/described_complexity.h"
#include "catalogue/shape/described_impacts.h"
#include "catalogue/shape/described_rays.h"
#include "catalogue/shape/described_simultaneous.h"
#include "catalogue/shape/described_solids.h"
#include "catalogue/shape/described_steps.h"
#include "catalogue/shape/described_triangles.h"
