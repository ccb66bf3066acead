# SPDX-License-Identifier: BSD-3-Clause
# Finds the Exodus II C library: SEACAS's own CMake config when there is one, else header and archive.
# Target: ExodusII::exodus
find_package(SEACASExodus QUIET CONFIG)
if(TARGET SEACASExodus::exodus)
  if(NOT TARGET ExodusII::exodus)
    add_library(ExodusII::exodus INTERFACE IMPORTED)
    target_link_libraries(ExodusII::exodus INTERFACE SEACASExodus::exodus)
  endif()
  set(ExodusII_FOUND TRUE)
  return()
endif()
find_path(ExodusII_INCLUDE_DIR exodusII.h)
find_library(ExodusII_LIBRARY NAMES exodus exoIIv2c)
find_library(ExodusII_NETCDF_LIBRARY netcdf)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(ExodusII
  REQUIRED_VARS ExodusII_LIBRARY ExodusII_INCLUDE_DIR ExodusII_NETCDF_LIBRARY)
if(ExodusII_FOUND AND NOT TARGET ExodusII::exodus)
  add_library(ExodusII::exodus UNKNOWN IMPORTED)
  set_target_properties(ExodusII::exodus PROPERTIES
    IMPORTED_LOCATION ${ExodusII_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES ${ExodusII_INCLUDE_DIR}
    INTERFACE_LINK_LIBRARIES ${ExodusII_NETCDF_LIBRARY})
endif()
mark_as_advanced(ExodusII_INCLUDE_DIR ExodusII_LIBRARY ExodusII_NETCDF_LIBRARY)
