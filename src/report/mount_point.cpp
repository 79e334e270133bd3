#include "mount_point.h"

#include <fcntl.h>
#include <sys/stat.h>

namespace cdr::report {

bool isMountPoint(const std::filesystem::path& path) {
    struct statx found {};
    if (::statx(AT_FDCWD, path.c_str(), AT_SYMLINK_NOFOLLOW, 0, &found) != 0) {
        return false;
    }
    if ((found.stx_attributes_mask & STATX_ATTR_MOUNT_ROOT) != 0) {
        return (found.stx_attributes & STATX_ATTR_MOUNT_ROOT) != 0;
    }
    // Linux before 5.8 does not say so. A folder of its own file system shows all the same.
    struct statx parent {};
    return S_ISDIR(found.stx_mode) && ::statx(AT_FDCWD, (path / "..").c_str(), 0, 0, &parent) == 0 &&
           (found.stx_dev_major != parent.stx_dev_major || found.stx_dev_minor != parent.stx_dev_minor);
}

} // namespace cdr::report
