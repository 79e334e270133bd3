#!/usr/bin/env bash
# Provides vk_mem_alloc.h, the header of Vulkan Memory Allocator, where the distribution has no package of it.
#
# Debian 13 and Ubuntu 24.04 have one and tools/setup.sh installs it; Debian 12 has none. There this takes that one
# package of Debian 13 (private_apt.sh says how). It is unpacked, not installed.
# Run again it does nothing. `--present` only tells, by its exit status, whether the header is there.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

package=libvulkan-memory-allocator-dev
release=trixie         # Debian 13
version='3.2.1+dfsg-*' # any revision of the packaging: the header itself is pinned, so only its text counts
header_sha256=1869d860b9713dda74f9d226d85b3a16c1c360b5430e56b5a54131c4d9fdf168
unpacked=.cache/vma # third_party/dependencies.cmake looks here

fail() {
    echo "third_party/vma.sh: vk_mem_alloc.h is missing: $1; install $package, or put the header into /usr/include" >&2
    exit 1
}

pinned() { # FOLDER: holds the pinned header
    echo "$header_sha256  $1/usr/include/vk_mem_alloc.h" | sha256sum --check --status 2>/dev/null
}

present() {
    [[ -e /usr/include/vk_mem_alloc.h || -e /usr/include/vma/vk_mem_alloc.h ]] || pinned "$unpacked"
}

if present; then exit 0; fi
if [[ ${1-} == --present ]]; then exit 1; fi

echo "third_party/vma.sh: fetching $package of Debian 13 into $unpacked (10 MB of package index, 120 kB of package)"
# shellcheck source=third_party/private_apt.sh
source third_party/private_apt.sh
private_apt_open "$release"
private_apt download "$package=$version" || fail "Debian's mirror has no $package $version in Debian 13"

dpkg-deb --extract "$scratch/$package"_*.deb "$scratch/unpacked"
pinned "$scratch/unpacked" || fail "what Debian's mirror served is not the pinned header of $package $version"
mkdir -p "$(dirname "$unpacked")"
rm -rf "$unpacked"
mv "$scratch/unpacked" "$unpacked"
