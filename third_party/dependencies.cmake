# Every dependency comes from the distribution through tools/setup.sh; nothing is vendored.
# MikkTSpace's source is C. By the sibling of the C++ compiler, so that both know the same flags.
if(NOT CMAKE_C_COMPILER AND NOT DEFINED ENV{CC})
    string(REGEX REPLACE "clang\\+\\+([^/]*)$" "clang\\1" sibling "${CMAKE_CXX_COMPILER}")
    string(REGEX REPLACE "g\\+\\+([^/]*)$" "gcc\\1" sibling "${sibling}")
    if(EXISTS "${sibling}" AND NOT sibling STREQUAL CMAKE_CXX_COMPILER)
        set(CMAKE_C_COMPILER "${sibling}")
    endif()
endif()
enable_language(C)
find_package(Threads REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(glm REQUIRED)
if(CDR_BUILD_TOOLS)
    find_package(CLI11 REQUIRED)
    find_package(OpenSSL REQUIRED COMPONENTS Crypto)
endif()
find_package(Vulkan 1.3.239 REQUIRED COMPONENTS glslangValidator)
find_package(OpenEXR REQUIRED)
find_package(meshoptimizer REQUIRED)
if(NOT TARGET draco::draco) # its package stops where an engine has brought it
    find_package(draco REQUIRED)
endif()
find_package(PkgConfig REQUIRED)
pkg_check_modules(spng REQUIRED IMPORTED_TARGET spng)
pkg_check_modules(turbojpeg REQUIRED IMPORTED_TARGET libturbojpeg)
if(CDR_BUILD_TESTS AND CDR_BUILD_TOOLS)
    find_package(GTest REQUIRED)
    include(GoogleTest)
    if(CDR_BUILD_BENCHMARKS)
        find_package(benchmark REQUIRED)
    endif()
endif()

# Vulkan Memory Allocator: from the system, or where the distribution lacks it from third_party/vma.sh.
find_path(VMA_INCLUDE_DIR vk_mem_alloc.h
    PATHS "${PROJECT_SOURCE_DIR}/.cache/vma/usr/include" PATH_SUFFIXES vma REQUIRED)
add_library(cdr_vma INTERFACE)
target_include_directories(cdr_vma SYSTEM INTERFACE "${VMA_INCLUDE_DIR}")
target_link_libraries(cdr_vma INTERFACE Vulkan::Headers)

# stb_easy_font: captions in contact sheets.
find_path(STB_INCLUDE_DIR stb_easy_font.h PATH_SUFFIXES stb REQUIRED)
add_library(cdr_stb INTERFACE)
target_include_directories(cdr_stb SYSTEM INTERFACE "${STB_INCLUDE_DIR}")

# The viewer's window and interface: optional, since the library and the command line need neither. Dear ImGui comes as
# Debian's static library, with its GLFW and Vulkan back ends inside.
find_package(glfw3 3.3 QUIET)
find_path(IMGUI_INCLUDE_DIR imgui.h PATH_SUFFIXES imgui)
find_path(IMGUI_BACKENDS_DIR imgui_impl_vulkan.h PATH_SUFFIXES imgui/backends imgui)
find_library(IMGUI_LIBRARY imgui)
find_library(STB_LIBRARY stb) # what Debian's Dear ImGui was linked against
if(CDR_BUILD_VIEWER AND glfw3_FOUND AND IMGUI_INCLUDE_DIR AND IMGUI_BACKENDS_DIR AND IMGUI_LIBRARY)
    set(CDR_HAS_VIEWER TRUE)
    add_library(cdr_imgui INTERFACE)
    target_include_directories(cdr_imgui SYSTEM INTERFACE "${IMGUI_INCLUDE_DIR}" "${IMGUI_BACKENDS_DIR}")
    target_link_libraries(cdr_imgui INTERFACE "${IMGUI_LIBRARY}" glfw Vulkan::Vulkan ${CMAKE_DL_LIBS})
    if(STB_LIBRARY)
        target_link_libraries(cdr_imgui INTERFACE "${STB_LIBRARY}")
    endif()
    # A font made for reading; without it Dear ImGui's own pixel font is used.
    find_file(CDR_VIEWER_FONT DejaVuSans.ttf PATHS /usr/share/fonts/truetype/dejavu /usr/share/fonts/TTF
        /usr/share/fonts/dejavu NO_CMAKE_FIND_ROOT_PATH)
elseif(CDR_BUILD_VIEWER)
    message(STATUS "cdr-viewer is not built: it needs GLFW and Dear ImGui (libglfw3-dev, libimgui-dev)")
endif()
