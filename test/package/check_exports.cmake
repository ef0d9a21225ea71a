# cmake -D NM=... -D LIBRARY=... -P check_exports.cmake
#
# Weak symbols (templates and inline functions of other libraries) are left aside: the linker merges them.
execute_process(COMMAND ${NM} --dynamic --defined-only --demangle ${LIBRARY} OUTPUT_VARIABLE symbols
                COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[0-9a-f]+ [TDBR] [^\n]*" exported "${symbols}")
if(NOT exported MATCHES " pcl::symmetry::")
  message(FATAL_ERROR "${LIBRARY} exports nothing of this project")
endif()
foreach(symbol IN LISTS exported)
  if(NOT symbol MATCHES "^[0-9a-f]+ [TDBR] ((typeinfo|typeinfo name|vtable) for )?pcl::")
    message(SEND_ERROR "${LIBRARY} exports ${symbol}")
  endif()
endforeach()
