# What `cmake --install` writes and find_package(cdr COMPONENTS ...) reads.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(CDR_SHADER_DIR "${CMAKE_INSTALL_INCLUDEDIR}/cdr/shaders")
set(CDR_CONFIG_DIR "${CMAKE_INSTALL_LIBDIR}/cmake/cdr")

# <cdr/version.h>, of cdr::base.
set(version_include "${PROJECT_BINARY_DIR}/include/version")
configure_file("${PROJECT_SOURCE_DIR}/tools/cmake/version.h.in" "${version_include}/cdr/version.h" @ONLY)
target_sources(cdr_base PUBLIC
    FILE_SET version TYPE HEADERS BASE_DIRS "${version_include}" FILES "${version_include}/cdr/version.h")

set(CDR_INSTALLED_ROOMS base depth)
install(TARGETS cdr_base EXPORT cdr-depth FILE_SET HEADERS FILE_SET version)
install(TARGETS cdr_depth EXPORT cdr-depth FILE_SET HEADERS)
install(EXPORT cdr-depth NAMESPACE cdr:: DESTINATION "${CDR_CONFIG_DIR}")
if(CDR_BUILD_RENDER)
    foreach(room host image scene)
        install(TARGETS cdr_${room} EXPORT cdr-scene FILE_SET HEADERS)
    endforeach()
    install(EXPORT cdr-scene NAMESPACE cdr:: DESTINATION "${CDR_CONFIG_DIR}")
    foreach(room visibility gpu render)
        install(TARGETS cdr_${room} EXPORT cdr-render FILE_SET HEADERS)
    endforeach()
    list(APPEND CDR_INSTALLED_ROOMS host image scene visibility gpu render)
    install(EXPORT cdr-render NAMESPACE cdr:: DESTINATION "${CDR_CONFIG_DIR}")
endif()
install(DIRECTORY "${PROJECT_SOURCE_DIR}/shaders/public/" DESTINATION "${CDR_SHADER_DIR}"
    FILES_MATCHING PATTERN "*.glsl" PATTERN "*.hlsl")

configure_package_config_file("${PROJECT_SOURCE_DIR}/tools/cmake/cdr-config.cmake.in"
    "${PROJECT_BINARY_DIR}/cdr-config.cmake" INSTALL_DESTINATION "${CDR_CONFIG_DIR}" PATH_VARS CDR_SHADER_DIR)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/cdr-config-version.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/cdr-config.cmake" "${PROJECT_BINARY_DIR}/cdr-config-version.cmake"
    DESTINATION "${CDR_CONFIG_DIR}")
file(RELATIVE_PATH CDR_PC_TO_PREFIX "${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig" "${CMAKE_INSTALL_PREFIX}")
configure_file("${PROJECT_SOURCE_DIR}/tools/cmake/cdr.pc.in" "${PROJECT_BINARY_DIR}/cdr.pc" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/cdr.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig")
