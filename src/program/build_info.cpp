#include "build_commit.h" // written at each build

#include <program/build_info.h>

namespace cdr::program {

BuildInfo buildInfo() {
    return {.version = CDR_VERSION, .commit = CDR_COMMIT};
}

} // namespace cdr::program
