# PCL 1.13 as CMake targets; used by this project's build and by its installed package config.
#
# find_package(PCL) delivers variables and one imported target per library, of which pcl_kdtree forgets FLANN and none
# is namespaced. After a find_package(PCL ...) this file makes of whatever components were found:
#
#   pcl_symmetry::pcl_core           common, search, kdtree and FLANN; no VTK
#   pcl_symmetry::pcl_io             pcl_core and io (which brings VTK)
#   pcl_symmetry::pcl_visualization  pcl_io and visualization
#
# They are imported, so the include directories of PCL, Eigen and Boost count as system headers: no warnings from them.

function(_pcl_symmetry_wrap_pcl target)
  if(TARGET ${target})
    return()
  endif()
  cmake_parse_arguments(ARG "" "" "COMPONENTS;LINK" ${ARGN})
  set(libraries ${ARG_LINK})
  foreach(component IN LISTS ARG_COMPONENTS)
    string(TOUPPER ${component} component)
    if(NOT PCL_${component}_FOUND)
      return()
    endif()
    list(APPEND libraries ${PCL_${component}_LIBRARIES})
  endforeach()
  add_library(${target} INTERFACE IMPORTED)
  target_link_libraries(${target} INTERFACE ${libraries})
  target_include_directories(${target} INTERFACE ${PCL_INCLUDE_DIRS})
endfunction()

_pcl_symmetry_wrap_pcl(pcl_symmetry::pcl_core COMPONENTS common search kdtree LINK FLANN::FLANN)
_pcl_symmetry_wrap_pcl(pcl_symmetry::pcl_io COMPONENTS io LINK pcl_symmetry::pcl_core)
_pcl_symmetry_wrap_pcl(pcl_symmetry::pcl_visualization COMPONENTS visualization LINK pcl_symmetry::pcl_io)
