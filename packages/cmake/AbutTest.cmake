# SPDX-License-Identifier: BSD-3-Clause
# abut_test(NAME SOURCES a.cpp ... LIBRARIES abut::x ... [LABEL unit] [RANKS 1 2 4])
# A GoogleTest program, run under mpiexec once for each rank count.
function(abut_test name)
  cmake_parse_arguments(arg "" "LABEL" "SOURCES;LIBRARIES;RANKS" ${ARGN})
  if(NOT arg_LABEL)
    set(arg_LABEL unit)
  endif()
  if(NOT arg_RANKS)
    set(arg_RANKS 1)
  endif()
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES} abut_test_main abut_warnings)
  foreach(ranks ${arg_RANKS})
    set(test ${name}_np${ranks})
    if(ranks EQUAL 1)
      add_test(NAME ${test} COMMAND ${name})
    else()
      add_test(NAME ${test}
        COMMAND ${MPIEXEC_EXECUTABLE} ${ABUT_MPIEXEC_FLAGS} ${MPIEXEC_NUMPROC_FLAG} ${ranks} $<TARGET_FILE:${name}>)
    endif()
    abut_test_properties(${test} ${ranks} "${arg_LABEL}")
  endforeach()
endfunction()

# Environment, label, time limit and processor count of one test.
function(abut_test_properties test ranks label)
  set_tests_properties(${test} PROPERTIES
    LABELS "${label}" PROCESSORS ${ranks} TIMEOUT 600
    ENVIRONMENT "OMP_NUM_THREADS=1;OPENBLAS_NUM_THREADS=1;OMPI_ALLOW_RUN_AS_ROOT=1;OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1;OMPI_MCA_rmaps_base_oversubscribe=1;OMPI_MCA_btl_base_warn_component_unused=0")
endfunction()
