# Build settings shared by every target of this project.
include(GNUInstallDirs)

option(PCL_SYMMETRY_BUILD_TESTS "Build the tests" ON)
option(PCL_SYMMETRY_WARNINGS_AS_ERRORS "Stop at a compiler warning" OFF)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
# Programs and libraries in one folder, so that they run from the build tree as they do when installed.
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib)

# No -march: an Eigen compiled for wider vectors than the distribution's PCL crashes together with it.
# Contraction of a*b+c is off so that the same input gives the same bytes whatever the instruction set.
function(pcl_symmetry_compile_options target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -ffp-contract=off
                                           $<$<BOOL:${PCL_SYMMETRY_WARNINGS_AS_ERRORS}>:-Werror>)
endfunction()

# pcl_symmetry_module(name SOURCES ... LINK ...): an internal static library of modules/<name>, whose headers are included
# as "<name>/header.h".
function(pcl_symmetry_module name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK;SYSTEM_INCLUDE" ${ARGN})
  add_library(${name}_module STATIC ${ARG_SOURCES})
  target_include_directories(${name}_module PUBLIC ${PROJECT_SOURCE_DIR}/modules ${PROJECT_SOURCE_DIR}/include)
  if(ARG_SYSTEM_INCLUDE)
    target_include_directories(${name}_module SYSTEM PUBLIC ${ARG_SYSTEM_INCLUDE})
  endif()
  target_link_libraries(${name}_module PUBLIC ${ARG_LINK})
  pcl_symmetry_compile_options(${name}_module)
endfunction()
