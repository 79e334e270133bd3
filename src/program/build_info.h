#pragma once

#include <string>

namespace cdr::program {

/// Version and commit the binary was built from; the commit is "unknown" outside a git checkout.
struct BuildInfo {
    std::string version;
    std::string commit;
};
BuildInfo buildInfo();

} // namespace cdr::program
