# Public headers and the CMake package config; libraries and programs are installed where they are made
# (PclSymmetryDefaults.cmake).
include(CMakePackageConfigHelpers)

set(PCL_SYMMETRY_CONFIG_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/pcl_symmetry)

install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h" PATTERN "*.hpp")

install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

configure_package_config_file(cmake/pcl_symmetry-config.cmake.in ${PROJECT_BINARY_DIR}/pcl_symmetry-config.cmake
                              INSTALL_DESTINATION ${PCL_SYMMETRY_CONFIG_DIR})
# While the version is 0.x a new minor version may change the interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/pcl_symmetry-config-version.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/pcl_symmetry-config.cmake
              ${PROJECT_BINARY_DIR}/pcl_symmetry-config-version.cmake cmake/PclTargets.cmake
        DESTINATION ${PCL_SYMMETRY_CONFIG_DIR})
