# Build settings shared by every target of this project, and the functions that make its targets:
#
#   pcl_symmetry_module(<name> SOURCES ... [LINK ...])
#   pcl_symmetry_library(<target> COMPONENT <component> DESCRIPTION <text> SOURCES ... [LINK ...] [PRIVATE_LINK ...]
#                        [PKG_CONFIG_REQUIRES ...])
#   pcl_symmetry_program(<name> SOURCES ... [LINK ...])
#   pcl_symmetry_test(<name> SOURCES ... [LINK ...] [TOGETHER] [TIMEOUT <seconds>])
#   pcl_symmetry_program_test(<name> PROGRAM <program> SOURCES ... [LINK ...] [TOGETHER] [TIMEOUT <seconds>])
#
# Each is described above its definition. Dependencies to link (all found by the root, see PclSymmetryDependencies.cmake):
# Threads::Threads, Eigen3::Eigen, Spectra::Spectra, pcl_symmetry::pcl_core (common, search, kdtree, FLANN),
# pcl_symmetry::pcl_io, pcl_symmetry::pcl_visualization, Boost::iostreams, Boost::program_options,
# Boost::headers (Boost.Graph),
# nlohmann_json::nlohmann_json.
include(GNUInstallDirs)

option(PCL_SYMMETRY_BUILD_TESTS "Build the tests" ON)
set(PCL_SYMMETRY_TIMEOUT_SCALE 1 CACHE STRING "Factor on the time limits of tests: sanitizers and emulators are slow")
option(PCL_SYMMETRY_BUILD_VIEWER "Build pcl_symmetry_viewer (needs PCL's visualization)" ON)
option(PCL_SYMMETRY_WITH_ASSIMP "Read .glb, .gltf and .3mf by assimp (needs libassimp-dev)" OFF)
option(PCL_SYMMETRY_BENCHMARKS "Build the timings of single steps (needs libbenchmark-dev)" OFF)
option(PCL_SYMMETRY_FUZZING "Build the fuzz targets (needs clang, preset fuzz)" OFF)
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
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

# Programs and libraries in one folder each, so that they run from the build tree as they do when installed: wherever
# the prefix is moved to, a program finds the library beside it.
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib)
file(RELATIVE_PATH PCL_SYMMETRY_BIN_TO_LIB ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
set(CMAKE_INSTALL_RPATH $ORIGIN $ORIGIN/${PCL_SYMMETRY_BIN_TO_LIB})

# PCL names some fifty VTK libraries to whoever links its io: take the ones that are used, or every start pays for all.
add_link_options(LINKER:--as-needed)

find_program(PCL_SYMMETRY_CCACHE ccache)
mark_as_advanced(PCL_SYMMETRY_CCACHE)
if(PCL_SYMMETRY_CCACHE AND NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${PCL_SYMMETRY_CCACHE})
endif()

# No -march: an Eigen compiled for wider vectors than the distribution's PCL crashes together with it.
# Contraction of a*b+c is off so that the same input gives the same bytes whatever the instruction set.
# clang's -Wconversion warns about signs as well, which that of g++ leaves out: an Index, signed as PCL's, numbers vectors
# in some 600 places, and is checked where it comes in.
function(pcl_symmetry_compile_options target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -ffp-contract=off
                                           $<$<CXX_COMPILER_ID:Clang>:-Wno-sign-conversion>
                                           $<$<BOOL:${PCL_SYMMETRY_WARNINGS_AS_ERRORS}>:-Werror>)
endfunction()

# pcl_symmetry_module(<name> SOURCES ... [LINK ...])
#
# An internal static library <name>_module of modules/<name>, whose headers are included as "<name>/header.h". It is
# never installed. What a shared library exports does not belong here but in the SOURCES of pcl_symmetry_library: the
# linker leaves out members of a static library that nothing refers to.
function(pcl_symmetry_module name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_library(${name}_module STATIC ${ARG_SOURCES})
  target_include_directories(${name}_module PUBLIC ${PROJECT_SOURCE_DIR}/modules ${PROJECT_SOURCE_DIR}/include)
  target_link_libraries(${name}_module PUBLIC ${ARG_LINK})
  pcl_symmetry_compile_options(${name}_module)
endfunction()

# pcl_symmetry_library(<target> COMPONENT <component> DESCRIPTION <text> SOURCES ... [LINK ...] [PRIVATE_LINK ...]
#                      [PKG_CONFIG_REQUIRES ...])
#
# An installed shared library, known as pcl_symmetry::<component> here and to find_package (pcl_symmetry COMPONENTS
# <component>), and as <target> to pkg-config. LINK is what its public headers include, PRIVATE_LINK the rest (modules
# among it); PKG_CONFIG_REQUIRES is LINK in pkg-config's names.
function(pcl_symmetry_library target)
  cmake_parse_arguments(ARG "" "COMPONENT;DESCRIPTION" "SOURCES;LINK;PRIVATE_LINK;PKG_CONFIG_REQUIRES" ${ARGN})
  add_library(${target} SHARED ${ARG_SOURCES})
  add_library(pcl_symmetry::${ARG_COMPONENT} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${ARG_COMPONENT} VERSION ${PROJECT_VERSION}
                                             SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  target_compile_features(${target} PUBLIC cxx_std_17)
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
                                              $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
                                       PRIVATE ${PROJECT_SOURCE_DIR}/modules)
  target_link_libraries(${target} PUBLIC ${ARG_LINK} PRIVATE ${ARG_PRIVATE_LINK})
  pcl_symmetry_compile_options(${target})

  install(TARGETS ${target} EXPORT pcl_symmetry-${ARG_COMPONENT} DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(EXPORT pcl_symmetry-${ARG_COMPONENT} FILE pcl_symmetry-${ARG_COMPONENT}.cmake NAMESPACE pcl_symmetry::
          DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/pcl_symmetry)

  set(PKG_CONFIG_NAME ${target})
  set(PKG_CONFIG_DESCRIPTION ${ARG_DESCRIPTION})
  list(JOIN ARG_PKG_CONFIG_REQUIRES " " PKG_CONFIG_REQUIRES)
  file(RELATIVE_PATH PKG_CONFIG_TO_PREFIX ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
  string(REGEX REPLACE "/$" "" PKG_CONFIG_TO_PREFIX ${PKG_CONFIG_TO_PREFIX})
  configure_file(${PROJECT_SOURCE_DIR}/cmake/pcl_symmetry.pc.in ${PROJECT_BINARY_DIR}/${target}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${target}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endfunction()

# pcl_symmetry_program(<name> SOURCES ... [LINK ...])
#
# An installed program; it knows the project's version as PCL_SYMMETRY_VERSION.
function(pcl_symmetry_program name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE ${ARG_LINK})
  target_compile_definitions(${name} PRIVATE PCL_SYMMETRY_VERSION="${PROJECT_VERSION}")
  pcl_symmetry_compile_options(${name})
  # OPTIONAL: who has built a part (cmake/demo.sh) installs that part, and all headers.
  install(TARGETS ${name} DESTINATION ${CMAKE_INSTALL_BINDIR} OPTIONAL)
endfunction()

# pcl_symmetry_test(<name> SOURCES ... [LINK ...] [TOGETHER] [TIMEOUT <seconds>])
#
# A GoogleTest program <name>, linked with GTest::gtest_main. To ctest each of its cases is a test of its own, called
# <folder>/<suite>.<case>; with TOGETHER the program is one test, which is the better choice where cases share a
# fixture that is costly to set up. TIMEOUT (default 120) holds for one test.
function(pcl_symmetry_test name)
  cmake_parse_arguments(ARG "TOGETHER" "TIMEOUT" "SOURCES;LINK" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 120)
  endif()
  math(EXPR ARG_TIMEOUT "${ARG_TIMEOUT} * ${PCL_SYMMETRY_TIMEOUT_SCALE}")
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE ${ARG_LINK} GTest::gtest_main)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/test)
  pcl_symmetry_compile_options(${name})

  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR}/test ${CMAKE_CURRENT_SOURCE_DIR})
  if(ARG_TOGETHER)
    add_test(NAME ${folder}/${name} COMMAND ${name})
    set_tests_properties(${folder}/${name} PROPERTIES TIMEOUT ${ARG_TIMEOUT} LABELS ${folder})
  else()
    gtest_discover_tests(${name} TEST_PREFIX ${folder}/ DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60
                         PROPERTIES TIMEOUT ${ARG_TIMEOUT} LABELS ${folder})
  endif()
endfunction()

# pcl_symmetry_program_test(<name> PROGRAM <program> SOURCES ... [LINK ...] [TOGETHER] [TIMEOUT <seconds>])
#
# A test as above that runs one of the project's programs through apps/run_program.h. It knows the project's version as
# PCL_SYMMETRY_VERSION.
function(pcl_symmetry_program_test name)
  cmake_parse_arguments(ARG "" "PROGRAM" "" ${ARGN})
  pcl_symmetry_test(${name} ${ARG_UNPARSED_ARGUMENTS})
  target_link_libraries(${name} PRIVATE run_program)
  target_compile_definitions(${name} PRIVATE PCL_SYMMETRY_VERSION="${PROJECT_VERSION}")
  add_dependencies(${name} ${ARG_PROGRAM})
endfunction()
