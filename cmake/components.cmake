# SPDX-License-Identifier: Apache-2.0
# The components of the package, each after those that it holds; read by our own build and by find_package(touchstone).

set(touchstone_components geometry reference robust oracle certify judge audit testing c)

set(touchstone_parts_of_reference geometry)
set(touchstone_parts_of_robust geometry)
set(touchstone_parts_of_oracle geometry)
set(touchstone_parts_of_judge geometry reference robust oracle certify)
set(touchstone_parts_of_audit ${touchstone_parts_of_judge} judge)
set(touchstone_parts_of_testing ${touchstone_parts_of_audit} audit)
set(touchstone_parts_of_c ${touchstone_parts_of_judge} judge)

# What a user of the component must have, its parts included.
set(touchstone_needs_of_robust GMP MPFR)
set(touchstone_needs_of_oracle GMP MPFR)
set(touchstone_needs_of_certify GMP nlohmann_json)
set(touchstone_needs_of_judge GMP MPFR nlohmann_json fmt)
set(touchstone_needs_of_audit ${touchstone_needs_of_judge} PNG ZLIB EXPAT)
set(touchstone_needs_of_testing ${touchstone_needs_of_audit})
set(touchstone_needs_of_c ${touchstone_needs_of_judge})
set(touchstone_version_of_nlohmann_json 3.11)

set(touchstone_debian_of_GMP libgmp-dev)
set(touchstone_debian_of_MPFR libmpfr-dev)
set(touchstone_debian_of_nlohmann_json nlohmann-json3-dev)
set(touchstone_debian_of_fmt libfmt-dev)
set(touchstone_debian_of_PNG libpng-dev)
set(touchstone_debian_of_ZLIB zlib1g-dev)
set(touchstone_debian_of_EXPAT libexpat1-dev)
