// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace touchstone::audit {

/// `touchstone map OP... [--out DIR] [--jobs N]`: a failure map of each operation as OP.png (reference beside robust)
/// and OP.html (the same with legend); prints what it wrote and one line of counts each. Throws UsageError for an
/// unknown operation or a directory that cannot be written. Jobs 0: as many as the machine has. Returns 1 if a pixel is
/// a finding, else 0.
int run_map(const std::vector<std::string>& operations, const std::string& out_directory, bool binary32, int jobs);

}  // namespace touchstone::audit
