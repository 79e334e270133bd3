#!/usr/bin/env bash
# Runs a command on another Vulkan driver than the system's, in software, without a graphics card.
# Usage: tools/drivers.sh system|mesa|swiftshader COMMAND [ARGUMENT...]
#   system       the driver that the loader finds first
#   mesa         lavapipe of the distribution's backports (packages mesa-vulkan-drivers and libdrm2)
#   swiftshader  what Chromium draws with (package chromium-common; the installed one, where it is)
#
# What is missing is downloaded through apt and unpacked into .cache/drivers. Nothing is installed. Status 77 where the
# distribution does not have it.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
unpacked=.cache/drivers # below the repository

fail() { # MESSAGE [STATUS]
    echo "tools/drivers.sh: $1" >&2
    exit "${2-1}"
}

usage() {
    sed -n 's/^# \(Usage: .*\)/\1/p' "${BASH_SOURCE[0]}" >&2
    exit 2
}

# Unpacks the one package of $scratch that is called NAME into a folder, whole or not at all.
unpack() { # NAME FOLDER [PATTERN...]
    local name=$1 folder=$2
    shift 2
    dpkg-deb --fsys-tarfile "$scratch/$name"_*.deb | tar --extract --wildcards --directory "$folder" "$@"
    # shellcheck disable=SC2016 # dpkg expands them, here and below
    dpkg-deb --showformat '${Package} ${Version}\n' --show "$scratch/$name"_*.deb >>"$folder/packages"
}

fetch_mesa() {
    local folder=$unpacked/mesa
    [[ ! -e $folder/packages ]] || return 0
    local release new
    # shellcheck source=/dev/null
    release="$(. /etc/os-release && echo "${VERSION_CODENAME-}")-backports"
    echo "tools/drivers.sh: fetching mesa-vulkan-drivers and libdrm2 of $release into $folder (12 MB)" >&2
    # shellcheck source=third_party/private_apt.sh
    source third_party/private_apt.sh
    private_apt_open "$release"
    private_apt download mesa-vulkan-drivers libdrm2 || fail "$release has no mesa-vulkan-drivers" 77
    new=$scratch/unpacked && mkdir "$new"
    unpack mesa-vulkan-drivers "$new" './usr/lib/*/libvulkan_lvp.so'
    unpack libdrm2 "$new" './usr/lib/*/libdrm.so*'
    rm -rf "$folder" && mkdir -p "$unpacked" && mv "$new" "$folder"
}

fetch_swiftshader() {
    local folder=$unpacked/swiftshader new
    [[ ! -e $folder/packages ]] || return 0
    scratch=$(mktemp -d)
    trap 'rm -rf "$scratch"' EXIT
    chmod 755 "$scratch"
    new=$scratch/unpacked && mkdir "$new"
    if [[ -e /usr/lib/chromium/libvk_swiftshader.so ]]; then
        mkdir -p "$new/usr/lib/chromium"
        cp /usr/lib/chromium/libvk_swiftshader.so "$new/usr/lib/chromium"
        # shellcheck disable=SC2016
        dpkg-query --showformat '${Package} ${Version}\n' --show chromium-common >"$new/packages"
    else
        echo "tools/drivers.sh: fetching chromium-common into $folder (32 MB, of which 5 MB stay)" >&2
        apt-cache show chromium-common >/dev/null 2>&1 || fail "this distribution has no chromium-common, which holds SwiftShader" 77
        (cd "$scratch" && apt-get download chromium-common) >"$scratch/log" 2>&1 </dev/null ||
            { cat "$scratch/log" >&2 && fail "apt did not deliver chromium-common, which holds SwiftShader"; }
        unpack chromium-common "$new" './usr/lib/chromium/libvk_swiftshader.so' ||
            fail "this distribution's chromium-common holds no SwiftShader" 77
    fi
    rm -rf "$folder" && mkdir -p "$unpacked" && mv "$new" "$folder"
}

# Points the loader at one driver. Manifests of our own, since a name without a folder would find the system's library.
use() { # DRIVER
    [[ $1 != system ]] || return 0
    (cd "$root" && "fetch_$1")
    local folder=$root/$unpacked/$1 library missing manifest
    library=$(find "$folder" -name 'libvulkan_lvp.so' -o -name 'libvk_swiftshader.so')
    if [[ $1 == mesa ]]; then export LD_LIBRARY_PATH="${library%/*}${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}"; fi
    missing=$(ldd "$library" | sed -n 's/^\t*\(.*\) => not found$/\1/p')
    [[ -z $missing ]] || fail "the driver $1 needs libraries that are not installed: ${missing//$'\n'/, }"
    manifest=$(mktemp "$folder/driver.XXXXXX")
    echo '{"file_format_version": "1.0.0", "ICD": {"library_path": "'"$library"'", "api_version": "1.3.0"}}' >"$manifest"
    mv -f "$manifest" "$folder/driver.json" # whole at any time, for a run beside this one
    # Older loaders read the first name.
    export VK_ICD_FILENAMES="$folder/driver.json" VK_DRIVER_FILES="$folder/driver.json"
}

case ${1-} in
    system | mesa | swiftshader) (($# > 1)) || usage ;;
    *) usage ;;
esac
use "$1"
shift
exec "$@"
