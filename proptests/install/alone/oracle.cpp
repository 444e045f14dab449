// SPDX-License-Identifier: Apache-2.0
#include <touchstone/oracle/lines/orientation.h>

using namespace touchstone;

int main() { return oracle::orientation(Point2d{0, 0}, Point2d{2, 0}, Point2d{1, 1}).answer == Side::left ? 0 : 1; }
