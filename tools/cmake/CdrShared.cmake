# The shared libraries of the package: each is made from the objects of its rooms, and gives out what is marked CDR_EXPORT.

# cdr_shared_library(NAME ROOMS room... [PUBLIC target...] [PRIVATE target...]) becomes cdr::NAME of a package.
function(cdr_shared_library name)
    cmake_parse_arguments(LIBRARY "" "" "ROOMS;PUBLIC;PRIVATE" ${ARGN})
    set(target cdr_shared_${name})
    list(TRANSFORM LIBRARY_ROOMS REPLACE "(.+)" "$<TARGET_OBJECTS:cdr_\\1>" OUTPUT_VARIABLE objects)
    add_library(${target} SHARED EXCLUDE_FROM_ALL ${objects})
    foreach(room IN LISTS LIBRARY_ROOMS)
        foreach(set IN ITEMS "" _version)
            get_target_property(roots cdr_${room} HEADER_DIRS${set})
            get_target_property(headers cdr_${room} HEADER_SET${set})
            if(headers)
                target_sources(${target} PUBLIC FILE_SET HEADERS BASE_DIRS ${roots} FILES ${headers})
            endif()
        endforeach()
    endforeach()
    target_compile_features(${target} PUBLIC cxx_std_20)
    target_compile_definitions(${target} INTERFACE $<$<PLATFORM_ID:Windows>:CDR_SHARED>)
    target_link_libraries(${target} PUBLIC ${LIBRARY_PUBLIC} PRIVATE ${LIBRARY_PRIVATE} $<BUILD_INTERFACE:cdr_compile_options>)
    set_target_properties(${target} PROPERTIES LINKER_LANGUAGE CXX EXPORT_NAME ${name} OUTPUT_NAME cdr_${name}
        VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} INSTALL_RPATH "$ORIGIN")
    if(NOT WIN32)
        # Hidden visibility leaves out what cdr keeps inside; the list leaves out what templates of others bring along.
        target_link_options(${target} PRIVATE LINKER:--no-undefined
            "LINKER:--version-script=${PROJECT_SOURCE_DIR}/tools/cmake/exports.map")
        set_target_properties(${target} PROPERTIES LINK_DEPENDS "${PROJECT_SOURCE_DIR}/tools/cmake/exports.map")
    endif()
endfunction()

cdr_shared_library(depth ROOMS base depth)
if(CDR_BUILD_RENDER)
    cdr_shared_library(scene ROOMS platform image scene PUBLIC cdr_shared_depth glm::glm
        PRIVATE fmt::fmt nlohmann_json::nlohmann_json Threads::Threads draco::draco meshoptimizer::meshoptimizer PkgConfig::spng
                PkgConfig::turbojpeg OpenEXR::OpenEXR)
    cdr_shared_library(render ROOMS visibility gpu render PUBLIC cdr_shared_scene Vulkan::Headers PRIVATE fmt::fmt ${CMAKE_DL_LIBS})
endif()
