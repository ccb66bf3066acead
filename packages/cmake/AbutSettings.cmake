# SPDX-License-Identifier: BSD-3-Clause
# Language, build type, warnings, sanitizers, compiler cache.
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
include(GNUInstallDirs)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

find_program(ABUT_CCACHE ccache)
if(ABUT_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${ABUT_CCACHE})
endif()

add_library(abut_warnings INTERFACE)
target_compile_options(abut_warnings INTERFACE -Wall -Wextra
  $<$<BOOL:${ABUT_WARNINGS_AS_ERRORS}>:-Werror>)
if(ABUT_SANITIZE)
  add_compile_options(-fsanitize=${ABUT_SANITIZE} -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${ABUT_SANITIZE})
endif()
