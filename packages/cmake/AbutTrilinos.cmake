# SPDX-License-Identifier: BSD-3-Clause
# Finds MPI and Trilinos: target abut::trilinos. Included by abut's build and by its installed
# configuration.
find_package(MPI REQUIRED COMPONENTS C CXX)
find_package(Trilinos REQUIRED COMPONENTS Tpetra Kokkos Teuchos Thyra ThyraTpetraAdapters NOX Belos
  Ifpack2 MueLu Zoltan2 Sacado)

if(NOT TARGET abut::trilinos)
  # Plain library lists up to 13.2, imported targets from 13.4 on.
  add_library(abut::trilinos INTERFACE IMPORTED)
  target_include_directories(abut::trilinos SYSTEM INTERFACE ${Trilinos_INCLUDE_DIRS}
    ${Trilinos_TPL_INCLUDE_DIRS})
  if(TARGET Trilinos::all_selected_libs)
    target_link_libraries(abut::trilinos INTERFACE Trilinos::all_selected_libs)
  else()
    target_link_libraries(abut::trilinos INTERFACE ${Trilinos_LIBRARIES} ${Trilinos_TPL_LIBRARIES})
  endif()
  target_link_libraries(abut::trilinos INTERFACE MPI::MPI_CXX)
endif()
