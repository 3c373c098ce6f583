# SPDX-License-Identifier: Apache-2.0
# What `cmake --install` copies, by component: kernels, program, rtl, vectors, docs.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# --- kernels: headers, and what finds them from CMake and pkg-config. The same on every processor, so below share/. ---
set(headers ${CMAKE_INSTALL_INCLUDEDIR}/halfspace)
set(data ${CMAKE_INSTALL_DATADIR}/halfspace)
set(package ${CMAKE_INSTALL_DATADIR}/cmake/halfspace)
target_include_directories(halfspace_hls INTERFACE $<INSTALL_INTERFACE:${headers}>)
install(TARGETS halfspace_hls EXPORT halfspaceTargets)
install(EXPORT halfspaceTargets NAMESPACE halfspace:: DESTINATION ${package} COMPONENT kernels)
install(DIRECTORY hls DESTINATION ${headers} COMPONENT kernels
  PATTERN CMakeLists.txt EXCLUDE PATTERN *.cpp EXCLUDE PATTERN *.toml EXCLUDE PATTERN __pycache__ EXCLUDE)
install(DIRECTORY hls/top DESTINATION ${data}/hls COMPONENT kernels FILES_MATCHING PATTERN *.cpp)
install(FILES hls/numbers/stream_words.cpp DESTINATION ${data}/hls/numbers COMPONENT kernels)
install(DIRECTORY hls/formats/configs/ DESTINATION ${data}/configs COMPONENT kernels FILES_MATCHING PATTERN *.toml)

set(built ${PROJECT_BINARY_DIR}/setup)
configure_package_config_file(setup/halfspaceConfig.cmake.in ${built}/halfspaceConfig.cmake
  INSTALL_DESTINATION ${package} PATH_VARS data)
write_basic_package_version_file(${built}/halfspaceConfigVersion.cmake COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
# Found from where the file lies, so that what is installed can be moved.
file(RELATIVE_PATH headers_from_pc ${CMAKE_INSTALL_FULL_DATADIR}/pkgconfig ${CMAKE_INSTALL_FULL_INCLUDEDIR}/halfspace)
configure_file(setup/halfspace.pc.in ${built}/halfspace.pc @ONLY)
install(FILES ${built}/halfspaceConfig.cmake ${built}/halfspaceConfigVersion.cmake DESTINATION ${package}
  COMPONENT kernels)
install(FILES ${built}/halfspace.pc DESTINATION ${CMAKE_INSTALL_DATADIR}/pkgconfig COMPONENT kernels)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT kernels)
if(HALFSPACE_KERNELS_ONLY)
  return()
endif()

# --- the rest: a tree like that of the sources, with the files that the program calls and those of other tools ---
install(DIRECTORY rtl tb driver DESTINATION ${data} COMPONENT rtl
  PATTERN CMakeLists.txt EXCLUDE PATTERN faults EXCLUDE PATTERN __pycache__ EXCLUDE)
install(FILES hls/units.txt DESTINATION ${data}/hls COMPONENT rtl)
install(FILES halfspace.core Bender.yml DESTINATION ${data} COMPONENT rtl)
install(DIRECTORY vectors/standard DESTINATION ${data}/vectors COMPONENT vectors)
install(DIRECTORY tests/configs/ DESTINATION ${data}/configs COMPONENT vectors)
install(DIRECTORY cli/sweep DESTINATION ${data} COMPONENT program
  PATTERN *.cpp EXCLUDE PATTERN *.hpp EXCLUDE PATTERN __pycache__ EXCLUDE)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT docs)
install(FILES README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT docs)
