# Run at every build: writes build_commit.h, and touches it only when the commit changed.
execute_process(COMMAND git describe --always --dirty --abbrev=12 --exclude=*
    WORKING_DIRECTORY "${SOURCE_DIR}" OUTPUT_VARIABLE commit ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
if(NOT commit)
    set(commit unknown)
endif()
set(text "#pragma once\n#define CDR_VERSION \"${VERSION}\"\n#define CDR_COMMIT \"${commit}\"\n")
file(CONFIGURE OUTPUT "${OUTPUT}" CONTENT "${text}" @ONLY)
