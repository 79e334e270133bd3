#include "mount_point.h"

#include <fcntl.h>
#include <sys/stat.h>

namespace cdr::report {

bool isMountPoint(const std::filesystem::path& path) {
    struct statx found {};
    return ::statx(AT_FDCWD, path.c_str(), AT_SYMLINK_NOFOLLOW, 0, &found) == 0 &&
           (found.stx_attributes & STATX_ATTR_MOUNT_ROOT) != 0;
}

} // namespace cdr::report
