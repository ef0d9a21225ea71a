# Target `tidy`: clang-tidy with the rules of .clang-tidy over every source file of this project; a finding is an error.
find_program(PCL_SYMMETRY_RUN_CLANG_TIDY NAMES run-clang-tidy run-clang-tidy-14)
mark_as_advanced(PCL_SYMMETRY_RUN_CLANG_TIDY)
if(PCL_SYMMETRY_RUN_CLANG_TIDY)
  add_custom_target(tidy
    COMMAND ${PCL_SYMMETRY_RUN_CLANG_TIDY} -quiet -p ${PROJECT_BINARY_DIR} "${PROJECT_SOURCE_DIR}/(modules|apps|test)/"
    COMMENT "clang-tidy"
    USES_TERMINAL)
endif()
