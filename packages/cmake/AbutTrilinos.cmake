# SPDX-License-Identifier: BSD-3-Clause
# Finds MPI and Trilinos: targets abut::kokkos and abut::sacado for kernels, and abut::trilinos for all
# of it, unless ABUT_TRILINOS_COMPONENTS names only some. Included by abut's build and by its
# installed configuration.
find_package(MPI REQUIRED COMPONENTS C CXX)
if(NOT ABUT_TRILINOS_COMPONENTS)
  set(ABUT_TRILINOS_COMPONENTS Tpetra Kokkos Teuchos Thyra ThyraTpetraAdapters NOX Belos Ifpack2 MueLu
    Zoltan2 Sacado)
endif()
find_package(Trilinos REQUIRED COMPONENTS ${ABUT_TRILINOS_COMPONENTS})

# abut_trilinos_target(NAME PREFIX ALL): abut::NAME with what the target ALL holds, from 13.4 on, or with
# the lists PREFIX_LIBRARIES, ..., up to 13.2.
function(abut_trilinos_target name prefix all)
  if(TARGET abut::${name})
    return()
  endif()
  add_library(abut::${name} INTERFACE IMPORTED)
  foreach(folder IN LISTS ${prefix}_INCLUDE_DIRS ${prefix}_TPL_INCLUDE_DIRS)
    cmake_path(ABSOLUTE_PATH folder NORMALIZE) # as given they start at the list's own folder
    target_include_directories(abut::${name} SYSTEM INTERFACE ${folder})
  endforeach()
  if(TARGET ${all})
    target_link_libraries(abut::${name} INTERFACE ${all})
  else()
    target_link_libraries(abut::${name} INTERFACE ${${prefix}_LIBRARIES} ${${prefix}_TPL_LIBRARIES})
  endif()
endfunction()

abut_trilinos_target(kokkos Kokkos Kokkos::all_libs)
if(Kokkos_ENABLE_OPENMP)
  find_package(OpenMP REQUIRED COMPONENTS CXX)
  target_link_libraries(abut::kokkos INTERFACE OpenMP::OpenMP_CXX) # the lists up to 13.2 have no flags
endif()
if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  target_compile_options(abut::kokkos INTERFACE -fopenmp-simd) # kernels say which loop is to be a vector
endif()
abut_trilinos_target(sacado Sacado Sacado::all_libs)
if("Tpetra" IN_LIST ABUT_TRILINOS_COMPONENTS)
  abut_trilinos_target(trilinos Trilinos Trilinos::all_selected_libs)
endif()
