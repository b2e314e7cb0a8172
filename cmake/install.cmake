# What `cmake --install` puts where, and how find_package(zonal) finds it again: zonal::zonal is everything, zonal::zonal_sh one floor.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

get_property(libraries GLOBAL PROPERTY ZONAL_LIBRARIES)
install(TARGETS zonal zonal_flags ${libraries} EXPORT zonal
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT zonal NAMESPACE zonal:: FILE zonal-targets.cmake DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/zonal)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/zonal DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/zonal-config.cmake.in ${PROJECT_BINARY_DIR}/zonal-config.cmake
                              INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/zonal)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/zonal-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/zonal-config.cmake ${PROJECT_BINARY_DIR}/zonal-config-version.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/zonal)
