# A room is a folder of src: one library target whose headers are reachable only by the rooms that link it.

add_library(cdr_compile_options INTERFACE)
target_compile_features(cdr_compile_options INTERFACE cxx_std_20)
# -ffp-contract=off: the same bits from every compiler, so hashes and truth do not depend on fused multiply-adds.
target_compile_options(cdr_compile_options INTERFACE
    -Wall -Wextra -Wpedantic -Wconversion -Wshadow -ffp-contract=off
    # GCC 12 warns of overlapping copies inside std::string's own operator+ (GCC bug 105651).
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
    # In a batch one file sees the file-local names of another, and GCC takes the files for headers.
    $<$<BOOL:${CDR_UNITY_BUILD}>:-Wno-shadow>
    $<$<AND:$<COMPILE_LANG_AND_ID:CXX,GNU>,$<BOOL:${CDR_UNITY_BUILD}>>:-Wno-subobject-linkage>
    $<$<BOOL:${CDR_WARNINGS_AS_ERRORS}>:-Werror>)
if(CDR_SANITIZE)
    target_compile_options(cdr_compile_options INTERFACE -fsanitize=${CDR_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(cdr_compile_options INTERFACE -fsanitize=${CDR_SANITIZE})
endif()

# For what takes no part in a frame, such as the own files of programs, tests and benchmarks. In a whole build it is compiled
# a third faster.
add_library(cdr_quick_compile INTERFACE)
if(CDR_UNITY_BUILD)
    target_compile_options(cdr_quick_compile INTERFACE $<$<CONFIG:Release>:-Og>)
endif()

# cdr_batches(TARGET SOURCE...): with CDR_UNITY_BUILD the sources of a folder are compiled as one. Those of other folders may
# then still use the same file-local names.
function(cdr_batches target)
    set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
    foreach(source IN LISTS ARGN)
        cmake_path(GET source PARENT_PATH folder)
        file(RELATIVE_PATH folder "${CMAKE_CURRENT_SOURCE_DIR}" "${folder}")
        string(MAKE_C_IDENTIFIER "batch_${folder}" group)
        set_source_files_properties("${source}" PROPERTIES UNITY_GROUP ${group})
    endforeach()
endfunction()

# cdr_joined_batch(TARGET FOLDER...): the sources of these folders of the room become one batch. What many small batches include
# takes longer to compile than they do.
function(cdr_joined_batch target first)
    get_target_property(sources ${target} SOURCES)
    foreach(source IN LISTS sources)
        cmake_path(GET source PARENT_PATH folder)
        cmake_path(RELATIVE_PATH folder BASE_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}")
        if(folder IN_LIST ARGV)
            string(MAKE_C_IDENTIFIER "joined_${first}" group)
            set_source_files_properties("${source}" PROPERTIES UNITY_GROUP ${group})
        endif()
    endforeach()
endfunction()

# cdr_shared_batches(TARGET COUNT SOURCE...): the same in COUNT batches, for sources of many small folders. All their file-local
# names differ.
function(cdr_shared_batches target count)
    set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
    set(number 0)
    foreach(source IN LISTS ARGN)
        math(EXPR group "${number} * ${count} / ${ARGC}")
        set_source_files_properties("${source}" PROPERTIES UNITY_GROUP shared_${group})
        math(EXPR number "${number} + 1")
    endforeach()
endfunction()

# cdr_room(NAME [EXCLUDE REGEX] [HEADERS file...] [PUBLIC target...] [PRIVATE target...])
# The folder and its subfolders become the library cdr::NAME. Its headers are included by their path below src. Only targets
# that link cdr::NAME can include them: each room has an include folder of its own in the build tree. So an include that
# points up the room list does not compile. EXCLUDE leaves out sources and headers whose path matches.
# HEADERS are those that are installed, all where it is not given.
function(cdr_room name)
    cmake_parse_arguments(ROOM "" "EXCLUDE" "HEADERS;PUBLIC;PRIVATE" ${ARGN})
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/*.cpp")
    file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}" "${CMAKE_CURRENT_SOURCE_DIR}/*.h")
    if(ROOM_EXCLUDE)
        list(FILTER sources EXCLUDE REGEX "${ROOM_EXCLUDE}")
        list(TRANSFORM headers PREPEND "/")
        list(FILTER headers EXCLUDE REGEX "${ROOM_EXCLUDE}")
        list(TRANSFORM headers REPLACE "^/" "")
    endif()
    if(ROOM_HEADERS)
        set(headers ${ROOM_HEADERS})
    endif()
    add_library(cdr_${name} STATIC ${sources}) # shared libraries are made from their objects: CdrShared.cmake
    cdr_batches(cdr_${name} ${sources})
    add_library(cdr::${name} ALIAS cdr_${name})
    file(RELATIVE_PATH folder "${PROJECT_SOURCE_DIR}/src" "${CMAKE_CURRENT_SOURCE_DIR}")
    set(include_root "${PROJECT_BINARY_DIR}/include/${name}")
    cmake_path(GET folder PARENT_PATH parent)
    file(MAKE_DIRECTORY "${include_root}/${parent}")
    file(CREATE_LINK "${CMAKE_CURRENT_SOURCE_DIR}" "${include_root}/${folder}" SYMBOLIC)
    list(TRANSFORM headers PREPEND "${include_root}/${folder}/")
    target_sources(cdr_${name} PUBLIC FILE_SET HEADERS BASE_DIRS "${include_root}" FILES ${headers})
    target_compile_features(cdr_${name} PUBLIC cxx_std_20)
    target_link_libraries(cdr_${name} PUBLIC ${ROOM_PUBLIC} PRIVATE ${ROOM_PRIVATE} $<BUILD_INTERFACE:cdr_compile_options>)
    # For shared libraries, which give out what is marked CDR_EXPORT.
    set_target_properties(cdr_${name} PROPERTIES POSITION_INDEPENDENT_CODE ON EXPORT_NAME ${name}
        CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON VERIFY_INTERFACE_HEADER_SETS ON)
    if(WIN32 AND BUILD_SHARED_LIBS)
        target_compile_definitions(cdr_${name} PRIVATE CDR_BUILDS_SHARED)
    endif()
endfunction()

# cdr_test(NAME [DRIVER] [SUITES] [ALONE suite...] [TOGETHER suite...] [OWN_HEADERS] [EXCLUDE REGEX] [BATCHES COUNT]
# LIBRARIES target...): every .cpp of the folder and its subfolders as one GoogleTest program. CTest runs each case in a process
# of its own, or with SUITES each suite. SUITES is for programs whose cases share what is slow to make, such as a device, or take
# less time than a start of the program. ALONE names suites whose cases have a process each in spite of it, and TOGETHER, without
# SUITES, those that have one. DRIVER labels them as needing a Vulkan driver.
# OWN_HEADERS is for rooms that need no package: their tests do without the headers that tests/CMakeLists.txt compiles once.
# BATCHES compiles all folders in so many batches, which is faster than one for each folder: see cdr_shared_batches.
function(cdr_test name)
    cmake_parse_arguments(TEST "DRIVER;SUITES;OWN_HEADERS" "EXCLUDE;BATCHES" "LIBRARIES;ALONE;TOGETHER" ${ARGN})
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/*.cpp")
    if(TEST_EXCLUDE)
        list(FILTER sources EXCLUDE REGEX "${TEST_EXCLUDE}")
    endif()
    add_executable(${name} ${sources})
    if(TEST_BATCHES)
        cdr_shared_batches(${name} ${TEST_BATCHES} ${sources})
    else()
        cdr_batches(${name} ${sources})
    endif()
    target_link_libraries(${name} PRIVATE ${TEST_LIBRARIES} GTest::gtest_main cdr_compile_options cdr_quick_compile)
    target_compile_definitions(${name} PRIVATE
        CDR_ASSETS_DIR="${CDR_ASSETS_DIR}" CDR_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
    if(NOT TEST_OWN_HEADERS)
        target_precompile_headers(${name} REUSE_FROM cdr_test_headers)
    endif()
    # For `ctest -L NAME`.
    set_property(DIRECTORY PROPERTY LABELS ${name})
    # Long, since a slow machine is no reason to fail.
    set(properties TIMEOUT 1500)
    if(TEST_DRIVER)
        # A software driver's page faults, one per 4 KiB, take a quarter of the tests' time. So glibc asks for large pages.
        list(APPEND properties LABELS driver ENVIRONMENT GLIBC_TUNABLES=glibc.malloc.hugetlb=1)
    endif()
    if(NOT TEST_SUITES OR TEST_ALONE)
        # By their names as GoogleTest has them: with parameters something stands before or behind them.
        set(filters ${TEST_ALONE} ${TEST_TOGETHER})
        list(TRANSFORM filters REPLACE "^(.+)$" "\\1.*:*/\\1.*:\\1/*")
        list(JOIN filters ":" filter)
        if(NOT TEST_ALONE)
            string(PREPEND filter "*-")
        endif()
        gtest_discover_tests(${name} TEST_FILTER "${filter}" DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 300
            PROPERTIES ${properties})
    endif()
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${sources})
    set(suites "")
    foreach(source IN LISTS sources)
        file(STRINGS "${source}" lines REGEX "^(TYPED_)?TEST(_F|_P)?\\(")
        list(TRANSFORM lines REPLACE "^[A-Z_]+\\(([A-Za-z0-9_]+).*$" "\\1")
        list(APPEND suites ${lines})
    endforeach()
    list(REMOVE_DUPLICATES suites)
    if(TEST_SUITES)
        list(REMOVE_ITEM suites "" ${TEST_ALONE})
    else()
        set(suites ${TEST_TOGETHER})
    endif()
    foreach(suite IN LISTS suites)
        # With GoogleTest's own test of the suite, which fails where it is never instantiated.
        add_test(NAME ${suite} COMMAND ${name} --gtest_brief=1
            "--gtest_filter=${suite}.*:*/${suite}.*:${suite}/*:GoogleTestVerification.*<${suite}>")
        set_tests_properties(${suite} PROPERTIES ${properties})
    endforeach()
endfunction()
