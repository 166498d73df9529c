# cmake --install: headers, the libraries' sources and the CMake package. A native build also installs the
# libraries and, if it was built, the program.
#
# Firmware needs the libraries with its own compiler and flags, so a cross build that uses the package
# compiles the installed sources.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/flashbvh)
set(source_folder ${CMAKE_INSTALL_DATADIR}/flashbvh)

install(DIRECTORY lib/include/flashbvh DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(DIRECTORY lib/ DESTINATION ${source_folder} PATTERN docs EXCLUDE)
install(FILES lib/cmake/flashbvh_add_mesh.cmake lib/cmake/flashbvh_add_robot.cmake
  lib/cmake/host_tool.cmake DESTINATION ${package_folder})
if(NOT CMAKE_CROSSCOMPILING)
  install(TARGETS flashbvh flashbvh_robot_lib EXPORT flashbvhTargets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(EXPORT flashbvhTargets NAMESPACE flashbvh:: DESTINATION ${package_folder})
endif()
if(TARGET flashbvh_tool)
  install(TARGETS flashbvh_tool EXPORT flashbvhToolTargets
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  install(EXPORT flashbvhToolTargets NAMESPACE flashbvh:: DESTINATION ${package_folder})
endif()

# A folder in which find_package() does not look, even if the build tree's bin is in PATH.
set(to_install ${PROJECT_BINARY_DIR}/to_install)
configure_package_config_file(lib/cmake/flashbvhConfig.cmake.in
  ${to_install}/flashbvhConfig.cmake
  INSTALL_DESTINATION ${package_folder}
  PATH_VARS source_folder
  NO_CHECK_REQUIRED_COMPONENTS_MACRO)
# Valid for any architecture, because the package contains the sources.
write_basic_package_version_file(${to_install}/flashbvhConfigVersion.cmake
  COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES ${to_install}/flashbvhConfig.cmake ${to_install}/flashbvhConfigVersion.cmake
  DESTINATION ${package_folder})
