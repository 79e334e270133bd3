# What `cmake --install` writes and find_package(cdr COMPONENTS ...) reads: static libraries, or shared ones with
# BUILD_SHARED_LIBS. Each kind is a component too, cdr_static and cdr_shared, so that one build can install either.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(CDR_SHADER_DIR "${CMAKE_INSTALL_INCLUDEDIR}/cdr/shaders")
set(CDR_CONFIG_DIR "${CMAKE_INSTALL_LIBDIR}/cmake/cdr")

# <cdr/version.h>, of cdr::base.
set(version_include "${PROJECT_BINARY_DIR}/include/version")
configure_file("${PROJECT_SOURCE_DIR}/tools/cmake/version.h.in" "${version_include}/cdr/version.h" @ONLY)
target_sources(cdr_base PUBLIC
    FILE_SET version TYPE HEADERS BASE_DIRS "${version_include}" FILES "${version_include}/cdr/version.h")
include(tools/cmake/CdrShared.cmake)

write_basic_package_version_file("${PROJECT_BINARY_DIR}/cdr-config-version.cmake" COMPATIBILITY SameMajorVersion)
file(RELATIVE_PATH CDR_PC_TO_PREFIX "${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig" "${CMAKE_INSTALL_PREFIX}")
foreach(folder LIBDIR INCLUDEDIR) # absolute ones stay as they are
    cmake_path(ABSOLUTE_PATH CMAKE_INSTALL_${folder} BASE_DIRECTORY "\${prefix}" OUTPUT_VARIABLE CDR_PC_${folder})
endforeach()

# The rooms of each part of the package, for the reference too.
set(CDR_DEPTH_ROOMS base depth)
set(CDR_PARTS DEPTH)
if(CDR_BUILD_RENDER)
    set(CDR_SCENE_ROOMS platform image scene)
    set(CDR_RENDER_ROOMS visibility gpu render)
    list(APPEND CDR_PARTS SCENE RENDER)
endif()

if(NOT CDR_INSTALL)
    return()
endif()
if(BUILD_SHARED_LIBS)
    foreach(PART IN LISTS CDR_PARTS)
        string(TOLOWER ${PART} part)
        set_target_properties(cdr_shared_${part} PROPERTIES EXCLUDE_FROM_ALL OFF)
    endforeach()
endif()

# cdr_install_licences([COMPONENT ...]): each component has them, since MIT asks that every copy does. An engine's folder for
# documents is not cdr's.
set(CDR_DOC_DIR "${CMAKE_INSTALL_DATAROOTDIR}/doc/cdr")
if(PROJECT_IS_TOP_LEVEL)
    set(CDR_DOC_DIR "${CMAKE_INSTALL_DOCDIR}")
endif()
function(cdr_install_licences)
    install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CDR_DOC_DIR}" ${ARGN})
    if(CDR_BUILD_RENDER) # without, nothing of others is compiled in
        install(FILES "${PROJECT_SOURCE_DIR}/third_party/LICENCES.md" DESTINATION "${CDR_DOC_DIR}/third_party" ${ARGN})
    endif()
endfunction()
if(CDR_BUILD_RENDER AND CDR_BUILD_TOOLS) # with the programs
    cdr_install_licences()
endif()

# cdr_install(KIND CHOSEN): what both kinds of package hold, and the libraries of one.
function(cdr_install kind chosen)
    set(where COMPONENT cdr_${kind})
    if(NOT chosen)
        list(APPEND where EXCLUDE_FROM_ALL)
    endif()
    foreach(PART IN LISTS CDR_PARTS)
        string(TOLOWER ${PART} part)
        set(targets cdr_shared_${part})
        if(kind STREQUAL "static")
            list(TRANSFORM CDR_${PART}_ROOMS PREPEND cdr_ OUTPUT_VARIABLE targets)
        endif()
        foreach(target IN LISTS targets)
            set(sets FILE_SET HEADERS ${where})
            if(target STREQUAL "cdr_base")
                list(APPEND sets FILE_SET version ${where})
            endif()
            install(TARGETS ${target} EXPORT cdr-${kind}-${part} ARCHIVE ${where} LIBRARY ${where} RUNTIME ${where} ${sets})
        endforeach()
        install(EXPORT cdr-${kind}-${part} NAMESPACE cdr:: DESTINATION "${CDR_CONFIG_DIR}" ${where})
    endforeach()
    cdr_install_licences(${where})
    install(DIRECTORY "${PROJECT_SOURCE_DIR}/shaders/public/" DESTINATION "${CDR_SHADER_DIR}" ${where}
        FILES_MATCHING PATTERN "*.glsl" PATTERN "*.hlsl")
    # CMake keeps a file that is as old as the one to install, as those of the two kinds are to the second.
    cmake_path(ABSOLUTE_PATH CMAKE_INSTALL_LIBDIR BASE_DIRECTORY "\${CMAKE_INSTALL_PREFIX}" OUTPUT_VARIABLE at)
    install(CODE "file(REMOVE \"\$ENV{DESTDIR}${at}/cmake/cdr/cdr-config.cmake\" \"\$ENV{DESTDIR}${at}/pkgconfig/cdr.pc\")" ${where})
    configure_package_config_file("${PROJECT_SOURCE_DIR}/tools/cmake/cdr-config.cmake.in"
        "${PROJECT_BINARY_DIR}/${kind}/cdr-config.cmake" INSTALL_DESTINATION "${CDR_CONFIG_DIR}" PATH_VARS CDR_SHADER_DIR)
    install(FILES "${PROJECT_BINARY_DIR}/${kind}/cdr-config.cmake" "${PROJECT_BINARY_DIR}/cdr-config-version.cmake"
        DESTINATION "${CDR_CONFIG_DIR}" ${where})
    set(CDR_PC_LIBS "-lcdr_depth")
    if(kind STREQUAL "static")
        string(APPEND CDR_PC_LIBS " -lcdr_base")
    endif()
    configure_file("${PROJECT_SOURCE_DIR}/tools/cmake/cdr.pc.in" "${PROJECT_BINARY_DIR}/${kind}/cdr.pc" @ONLY)
    install(FILES "${PROJECT_BINARY_DIR}/${kind}/cdr.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig" ${where})
endfunction()

if(BUILD_SHARED_LIBS)
    cdr_install(shared TRUE)
    cdr_install(static FALSE)
else()
    cdr_install(static TRUE)
    cdr_install(shared FALSE)
endif()
