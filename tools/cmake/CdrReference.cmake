# The reference of the installed headers, where Doxygen is installed: the target cdr_reference. tools/reference.doxyfile says
# how they are read, and what is an error.
find_package(Doxygen QUIET)
if(NOT DOXYGEN_FOUND)
    return()
endif()
set(reference_headers "${version_include}/cdr/version.h")
set(reference_roots "${version_include}")
foreach(room IN LISTS CDR_DEPTH_ROOMS CDR_SCENE_ROOMS CDR_RENDER_ROOMS)
    get_target_property(headers cdr_${room} HEADER_SET)
    list(APPEND reference_headers ${headers})
    list(APPEND reference_roots "${PROJECT_BINARY_DIR}/include/${room}")
endforeach()
list(JOIN reference_headers "\" \"" reference_headers)
list(JOIN reference_roots "\" \"" reference_roots)
set(CDR_REFERENCE_SETTINGS "${PROJECT_BINARY_DIR}/reference.doxyfile")
file(GENERATE OUTPUT "${CDR_REFERENCE_SETTINGS}" CONTENT "@INCLUDE = \"${PROJECT_SOURCE_DIR}/tools/reference.doxyfile\"
PROJECT_NAME = cdr
PROJECT_NUMBER = ${PROJECT_VERSION}
INPUT = \"${reference_headers}\"
STRIP_FROM_PATH = \"${reference_roots}\"
STRIP_FROM_INC_PATH = \"${reference_roots}\"
OUTPUT_DIRECTORY = \"${PROJECT_BINARY_DIR}/reference\"
")
add_custom_target(cdr_reference COMMAND "${DOXYGEN_EXECUTABLE}" "${CDR_REFERENCE_SETTINGS}"
    COMMENT "Making the reference in reference/html" VERBATIM)
