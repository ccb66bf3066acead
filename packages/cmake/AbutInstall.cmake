# SPDX-License-Identifier: BSD-3-Clause
# Installs the packages' targets for find_package(abut COMPONENTS ...) in other projects.
include(CMakePackageConfigHelpers)
set(folder ${CMAKE_INSTALL_LIBDIR}/cmake/abut)
list(JOIN ABUT_PACKAGES " " ABUT_PACKAGES)

install(EXPORT abut NAMESPACE abut:: FILE abutTargets.cmake DESTINATION ${folder})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/abutConfig.cmake.in
  ${PROJECT_BINARY_DIR}/abutConfig.cmake INSTALL_DESTINATION ${folder}
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/abutConfigVersion.cmake
  VERSION ${PROJECT_VERSION} COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/abutConfig.cmake
  ${PROJECT_BINARY_DIR}/abutConfigVersion.cmake
  ${CMAKE_CURRENT_LIST_DIR}/AbutTrilinos.cmake
  ${CMAKE_CURRENT_LIST_DIR}/FindExodusII.cmake
  ${CMAKE_CURRENT_LIST_DIR}/FindMUMPS.cmake
  DESTINATION ${folder})
