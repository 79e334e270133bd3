#!/usr/bin/env bash
# Provides vk_mem_alloc.h, the header of Vulkan Memory Allocator, where the distribution has no package of it.
#
# Debian 13 and Ubuntu 24.04 have one and tools/setup.sh installs it; Debian 12 has none. There this takes that one
# package of Debian 13 through apt, from the mirror the system already uses, with a sources list, state and cache of
# its own: a newer release among the system's sources could upgrade anything. The package is unpacked, not installed.
# Run again it does nothing. `--present` only tells, by its exit status, whether the header is there.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

package=libvulkan-memory-allocator-dev
release=trixie         # Debian 13
version='3.2.1+dfsg-*' # any revision of the packaging: the header itself is pinned, so only its text counts
header_sha256=1869d860b9713dda74f9d226d85b3a16c1c360b5430e56b5a54131c4d9fdf168
unpacked=.cache/vma # third_party/dependencies.cmake looks here
keyring=/usr/share/keyrings/debian-archive-keyring.gpg

fail() {
    echo "third_party/vma.sh: vk_mem_alloc.h is missing: $1" >&2
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

# shellcheck source=/dev/null
distribution=$(. /etc/os-release && echo "$ID ${VERSION_CODENAME-}")
[[ $distribution == debian\ * && -e $keyring ]] || fail "install $package, or put the header into /usr/include"

# Reading apt's own view of its sources covers every format they come in, and every kind of mirror.
# shellcheck disable=SC2016 # apt expands $(REPO_URI)
mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 'Origin: Debian' \
    "Codename: ${distribution#* }" 'Component: main')
mirror=${mirror%%$'\n'*}
[[ -n $mirror ]] || fail "apt knows no Debian mirror; run apt-get update"

# Outside the repository, because apt reads the network as a user of its own that may not enter a home folder.
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
chmod 755 "$scratch"
mkdir -p "$scratch/lists/partial" "$scratch/cache/archives/partial"
echo "deb [signed-by=$keyring] $mirror $release main" >"$scratch/sources.list"

# The hooks are cleared because a system's own may touch its cache after an update. The rest of the system's
# configuration stays in force: it may hold a proxy.
cat >"$scratch/apt.conf" <<CONF
Dir::Etc::SourceList "$scratch/sources.list";
Dir::Etc::SourceParts "/dev/null";
Dir::Etc::Preferences "/dev/null";
Dir::Etc::PreferencesParts "/dev/null";
Dir::State "$scratch";
Dir::State::Status "/dev/null";
Dir::Cache "$scratch/cache";
APT::Architectures { "$(dpkg --print-architecture)"; };
Acquire::Languages "none";
#clear APT::Update::Pre-Invoke;
#clear APT::Update::Post-Invoke;
#clear APT::Update::Post-Invoke-Success;
CONF

private_apt() { # quiet unless it fails
    (cd "$scratch" && apt-get --config-file apt.conf "$@") >"$scratch/log" 2>&1 </dev/null ||
        { cat "$scratch/log" >&2 && return 1; }
}

echo "third_party/vma.sh: fetching $package of Debian 13 into $unpacked (10 MB of package index, 120 kB of package)"
# Without --error-on an index that cannot be fetched is a warning only.
private_apt update --error-on=any || fail "the mirror $mirror did not serve Debian 13"
private_apt download "$package=$version" || fail "the mirror $mirror has no $package $version in Debian 13"

dpkg-deb --extract "$scratch/$package"_*.deb "$scratch/unpacked"
pinned "$scratch/unpacked" || fail "what $mirror served is not the pinned header of $package $version"
mkdir -p "$(dirname "$unpacked")"
rm -rf "$unpacked"
mv "$scratch/unpacked" "$unpacked"
