# SPDX-License-Identifier: BSD-3-Clause
# The system's Python: it has numpy and netCDF4 from Debian packages, which another one need not have.
set(ABUT_SCENE_PYTHON /usr/bin/python3 CACHE FILEPATH "Python with numpy and netCDF4 for the scene tests")
set(ABUT_TEST_THREADS 1 CACHE STRING "Threads of each process of a test, where Kokkos has any")
set(ABUT_TEST_SECONDS 600 CACHE STRING "Time limit of a test that has none of its own")

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

# Environment, label, time limit and processor count of one test; exit status 77 counts as skipped. Each has a session folder of MPI's of its
# own: programs that end take the common one away from others that start.
function(abut_test_properties test ranks label)
  set(session ${PROJECT_BINARY_DIR}/mpi/${test})
  file(MAKE_DIRECTORY ${session})
  set_tests_properties(${test} PROPERTIES
    LABELS "${label}" PROCESSORS ${ranks} TIMEOUT ${ABUT_TEST_SECONDS} SKIP_RETURN_CODE 77
    ENVIRONMENT "OMP_NUM_THREADS=${ABUT_TEST_THREADS};KOKKOS_NUM_THREADS=${ABUT_TEST_THREADS};OPENBLAS_NUM_THREADS=1;OMPI_ALLOW_RUN_AS_ROOT=1;OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1;OMPI_MCA_rmaps_base_oversubscribe=1;OMPI_MCA_mpi_yield_when_idle=1;OMPI_MCA_btl_base_warn_component_unused=0;OMPI_MCA_orte_tmpdir_base=${session}")
endfunction()

# abut_scene_test(NAME FILE file.py LABEL label [RANKS 1 2] [PROCESSORS n] [SECONDS n] [ARGUMENTS a ...])
# A Python unittest file that runs the program on whole scenes, once for each rank count. PROCESSORS: cores
# to keep free for it when the file starts more ranks by itself. tests/support is on its module path.
function(abut_scene_test name)
  cmake_parse_arguments(arg "" "FILE;LABEL;PROCESSORS;SECONDS" "RANKS;ARGUMENTS" ${ARGN})
  if(NOT TARGET abut)
    return()
  endif()
  if(NOT arg_RANKS)
    set(arg_RANKS 1)
  endif()
  cmake_path(ABSOLUTE_PATH arg_FILE BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
  foreach(ranks ${arg_RANKS})
    set(test ${name}_np${ranks})
    add_test(NAME ${test} COMMAND ${ABUT_SCENE_PYTHON} -B ${PROJECT_SOURCE_DIR}/tests/support/run_tests.py
      ${arg_FILE} ${arg_ARGUMENTS})
    if(arg_PROCESSORS)
      abut_test_properties(${test} ${arg_PROCESSORS} "${arg_LABEL}")
    else()
      abut_test_properties(${test} ${ranks} "${arg_LABEL}")
    endif()
    if(arg_SECONDS)
      set_tests_properties(${test} PROPERTIES TIMEOUT ${arg_SECONDS})
    endif()
    list(JOIN ABUT_MPIEXEC_FLAGS " " flags)
    set_property(TEST ${test} APPEND PROPERTY ENVIRONMENT
      "ABUT_EXECUTABLE=$<TARGET_FILE:abut>;ABUT_MPIEXEC=${MPIEXEC_EXECUTABLE};ABUT_MPIEXEC_FLAGS=${flags}"
      "ABUT_TEST_RANKS=${ranks};PYTHONPATH=${PROJECT_SOURCE_DIR}/tests/support")
  endforeach()
endfunction()
