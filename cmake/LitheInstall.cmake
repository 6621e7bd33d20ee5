# SPDX-FileCopyrightText: 2026 the lithe authors
# SPDX-License-Identifier: MIT
# What `cmake --install` puts in place: the runtime, the format's headers and a package for find_package(lithe).
# The bake's libraries stay inside; of the bake only the tool is installed.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(LITHE_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/lithe)

set_target_properties(lithe_format PROPERTIES EXPORT_NAME format)
set_target_properties(lithe_runtime PROPERTIES EXPORT_NAME runtime)
install(TARGETS lithe_format lithe_runtime EXPORT lithe ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY format/include/ runtime/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  FILES_MATCHING PATTERN "*.h" PATTERN "*.hpp")
install(EXPORT lithe NAMESPACE lithe:: FILE lithe-targets.cmake DESTINATION ${LITHE_PACKAGE_DIR})

configure_package_config_file(cmake/lithe-config.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/lithe-config.cmake
  INSTALL_DESTINATION ${LITHE_PACKAGE_DIR})
# Until 1.0 every minor version may change the C API.
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/lithe-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/lithe-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/lithe-config-version.cmake
  DESTINATION ${LITHE_PACKAGE_DIR})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/licenses/lithe)

if(TARGET lithe_tool)
  install(TARGETS lithe_tool DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
