# SPDX-License-Identifier: BSD-3-Clause
# Finds what abut stands on and gives each a target of one name, whatever the distribution does.
include(AbutTrilinos)
find_package(ExodusII REQUIRED)
find_package(MUMPS REQUIRED)
find_package(yaml-cpp REQUIRED)
find_package(muparser REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(pugixml REQUIRED)
