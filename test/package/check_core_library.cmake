# cmake -D READELF=... -D LIBRARY=... -P check_core_library.cmake
execute_process(COMMAND ${READELF} --dynamic --wide ${LIBRARY} OUTPUT_VARIABLE dynamic COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "\\(NEEDED\\)[^\n]*" needed "${dynamic}")
if(NOT needed MATCHES "libpcl_")
  message(FATAL_ERROR "${LIBRARY} does not even need PCL: ${needed}")
endif()
if(needed MATCHES "vtk|libpcl_io|libpcl_visualization")
  message(FATAL_ERROR "${LIBRARY} needs more than the core of PCL: ${needed}")
endif()
