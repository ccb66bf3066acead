# SPDX-License-Identifier: BSD-3-Clause
# Finds the parallel MUMPS, double precision. Target: MUMPS::dmumps
# The build with PT-Scotch ordering is preferred and must be named before Trilinos's own libraries.
find_path(MUMPS_INCLUDE_DIR dmumps_c.h)
find_library(MUMPS_LIBRARY NAMES dmumps_ptscotch dmumps)
find_library(MUMPS_COMMON_LIBRARY NAMES mumps_common_ptscotch mumps_common)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(MUMPS
  REQUIRED_VARS MUMPS_LIBRARY MUMPS_COMMON_LIBRARY MUMPS_INCLUDE_DIR)
if(MUMPS_FOUND AND NOT TARGET MUMPS::dmumps)
  add_library(MUMPS::dmumps UNKNOWN IMPORTED)
  set_target_properties(MUMPS::dmumps PROPERTIES
    IMPORTED_LOCATION ${MUMPS_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${MUMPS_INCLUDE_DIR}
    INTERFACE_LINK_LIBRARIES ${MUMPS_COMMON_LIBRARY})
endif()
mark_as_advanced(MUMPS_INCLUDE_DIR MUMPS_LIBRARY MUMPS_COMMON_LIBRARY)
