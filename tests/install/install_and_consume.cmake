# SPDX-License-Identifier: BSD-3-Clause
# Installs BUILD, moves the result, then configures, builds and runs CONSUMER against it.
set(prefix ${WORK}/moved)
file(REMOVE_RECURSE ${WORK})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/installed
  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(RENAME ${WORK}/installed ${prefix})

# What is installed stands by itself.
file(GLOB_RECURSE files ${prefix}/*.cmake ${prefix}/*.hpp)
foreach(file IN LISTS files)
  file(READ ${file} text)
  foreach(place ${SOURCE} ${BUILD} ${WORK})
    string(FIND "${text}" "${place}/" position)
    if(NOT position EQUAL -1)
      message(FATAL_ERROR "${file} names ${place}")
    endif()
  endforeach()
  string(FIND "${text}" "abut_warnings" position)
  if(NOT position EQUAL -1)
    message(FATAL_ERROR "${file} passes abut's warning flags on")
  endif()
endforeach()

set(flags "")
if(SANITIZE)
  set(flags "-fsanitize=${SANITIZE}")
endif()
set(configure ${CMAKE_COMMAND} -S ${CONSUMER} -G ${GENERATOR} -D CMAKE_PREFIX_PATH=${prefix}
  -D CMAKE_BUILD_TYPE=${BUILD_TYPE} -D CMAKE_CXX_COMPILER=${CXX} -D CMAKE_CXX_FLAGS=${flags})
execute_process(COMMAND ${configure} -B ${WORK}/build OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
file(STRINGS ${WORK}/build/CMakeCache.txt searched REGEX "^(MUMPS|ExodusII|yaml-cpp|CLI11)_")
if(searched)
  message(FATAL_ERROR "a component that needs none of them made the consumer search: ${searched}")
endif()
execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK}/build COMMAND_ERROR_IS_FATAL ANY)

separate_arguments(mpiexec UNIX_COMMAND "${MPIEXEC}")
foreach(launcher "" "${mpiexec}")
  execute_process(COMMAND ${launcher} ${WORK}/build/consumer COMMAND_ECHO STDOUT
    OUTPUT_VARIABLE output ERROR_VARIABLE output RESULT_VARIABLE result)
  message(STATUS "${output}")
  if(NOT result EQUAL 0 OR NOT output MATCHES "consumer: all right")
    message(FATAL_ERROR "the consumer ended with ${result}")
  endif()
endforeach()

# The program finds its Python part where it is installed.
execute_process(COMMAND ${prefix}/bin/abut run ${SOURCE}/input/blocks/blocks.yaml --quiet
  --output-dir ${WORK}/run --summary ${WORK}/run/blocks.json COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${prefix}/bin/abut report ${WORK}/run/blocks.exo WORKING_DIRECTORY ${WORK}
  COMMAND_ERROR_IS_FATAL ANY)
file(READ ${WORK}/run/blocks.html page LIMIT 2000)
if(NOT page MATCHES "Rubber blocks at half their height")
  message(FATAL_ERROR "no report of the run: ${page}")
endif()
if(IS_SYMLINK ${prefix}/share/abut/python OR IS_SYMLINK ${prefix}/share/abut/python/abut)
  message(FATAL_ERROR "the Python part was not installed but linked")
endif()

# A component that is not there is an error that names it.
execute_process(COMMAND ${configure} -B ${WORK}/wrong -D COMPONENT=adhesion
  OUTPUT_QUIET ERROR_VARIABLE output RESULT_VARIABLE result)
if(result EQUAL 0 OR NOT output MATCHES "abut has no component 'adhesion'")
  message(FATAL_ERROR "an unknown component was accepted: ${output}")
endif()
