#!/usr/bin/env bash
# Installs whatever is missing to build, test and run cdr, on Debian 12, Debian 13, Ubuntu 24.04 or later. These are packages
# of the distribution, and the npm packages of the report's page in src/page/node_modules. In .cache it puts the pictures of
# the Earth for the scene orbit and the source of MikkTSpace. If nothing is missing, it touches neither the system nor the
# network.
# Usage: tools/setup.sh [--dry-run | --list | --demo]
# --dry-run says what is missing, where it would come from and what checks it, and changes nothing. --list names the
# distribution's packages. --demo goes on without what npm does not deliver, and says what lacks it: the demo needs none of it.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

packages=(
    # build (pkg-config is a part of pkgconf on every distribution above)
    g++ cmake ninja-build pkgconf ccache git ca-certificates
    # Vulkan: loader, shader compiler, validation, and lavapipe, a driver that needs no graphics card
    libvulkan-dev glslang-tools vulkan-validationlayers mesa-vulkan-drivers
    # libraries
    libcli11-dev libdraco-dev libfmt-dev libglm-dev libmeshoptimizer-dev libopenexr-dev libspng-dev libssl-dev libstb-dev
    libturbojpeg0-dev nlohmann-json3-dev
    # the viewer: optional, without them it is not built; the font is what it writes with
    libglfw3-dev libimgui-dev fonts-dejavu-core
    # its tests, which drive the real window on a display of their own: optional, they skip and say so
    xvfb xdotool
    # plots: optional, only the --plot of timing and scaling asks for it, and says so where it is missing
    gnuplot-nox
    # videos: optional, only flicker's --videos and the report ask for it, and say so where it is missing
    ffmpeg
    # several machines: optional, without them cdr is built for one, and the tests of ranks skip and say so
    libopenmpi-dev openmpi-bin
    # the reference of the installed headers, and the test of what they say: optional, it skips and says so
    doxygen
    # tests, benchmarks and checks
    libbenchmark-dev libgtest-dev clang clang-format clang-tidy libclang-rt-dev libvulkan-volk-dev
)

fail() {
    echo "tools/setup.sh: $1" >&2
    exit 1
}

as_root() {
    if ((EUID == 0)); then
        "$@"
    else
        sudo "$@"
    fi
}

dry_run=false
demo=false
case ${1-} in
    '') ;;
    --dry-run) dry_run=true ;;
    --demo) demo=true ;;
    --list)
        printf '%s\n' "${packages[@]}" nodejs npm chromium-headless-shell libvulkan-memory-allocator-dev
        exit
        ;;
    *) echo "usage: tools/setup.sh [--dry-run | --list | --demo]" >&2 && exit 2 ;;
esac

command -v apt-get >/dev/null ||
    fail "needs apt; on another system install what its list of packages names, and Vulkan Memory Allocator"

# By their commands, since a distribution of node from elsewhere brings npm along and refuses the package of that name.
command -v node >/dev/null || packages+=(nodejs)
command -v npm >/dev/null || packages+=(npm)
# The browser that tests the report's page: a Chromium without a window, which takes 0.56 of the CPU time. Ubuntu has none but a
# snap; without it they skip.
[[ $(. /etc/os-release && echo "$ID") == ubuntu ]] || command -v chromium >/dev/null || packages+=(chromium-headless-shell)

missing=()
installed=" $(dpkg-query --show --showformat='${Package}=${db:Status-Status} ' "${packages[@]}" 2>/dev/null || true)"
for package in "${packages[@]}"; do
    [[ $installed == *" $package=installed "* ]] || missing+=("$package")
done

lock=src/page/package-lock.json
# Whether src/page/node_modules holds what the lock file names, file by file as npm unpacked it.
has_npm_packages() {
    cmp --silent "$lock" src/page/node_modules/.cdr-lock.json &&
        (cd src/page/node_modules && sha256sum --check --status --strict .cdr-sums) 2>/dev/null
}

if $dry_run; then
    would() { echo "would install $1: $2"; }
    if ((${#missing[@]})); then would "by apt, checked by the distribution's signatures" "${missing[*]}"; fi
    third_party/vma.sh --present ||
        would "by apt, checked by its signatures and by SHA-256" "the header of Vulkan Memory Allocator"
    has_npm_packages || would "by npm into src/page/node_modules, checked by the hashes of $lock" \
        "$(sed -nE 's,^        "node_modules/([^@"]+)": [{]$,\1,p' "$lock" | paste --serial --delimiters=' ')"
    third_party/orbit_data.sh --present ||
        would "by npm into .cache/orbit-data, checked by SHA-256" "two pictures of the Earth"
    third_party/mikktspace.sh --present ||
        would "by npm into .cache/mikktspace, checked by SHA-256" "MikkTSpace as C source, translated by wabt"
    echo "nothing was changed"
    exit
fi

if ((${#missing[@]})) || ! third_party/vma.sh --present; then
    # Always, since package lists may be absent (containers) or name files that the mirror has dropped since.
    as_root apt-get update -q </dev/null || echo "tools/setup.sh: package lists not refreshed, using those at hand" >&2
    allocator=libvulkan-memory-allocator-dev
    if ! third_party/vma.sh --present && apt-cache show "$allocator" >/dev/null 2>&1; then
        missing+=("$allocator")
    fi
    if ((${#missing[@]})); then
        ((EUID == 0)) || command -v sudo >/dev/null || fail "needs root or sudo to install: ${missing[*]}"
        echo "tools/setup.sh: installing ${missing[*]}"
        as_root env DEBIAN_FRONTEND=noninteractive \
            apt-get install -q --yes --no-install-recommends "${missing[@]}" </dev/null
    fi
    third_party/vma.sh
fi

# Gets what comes through npm. Where that fails, only the demo goes on.
get() { # WHAT_LACKS_IT COMMAND
    "$2" || { $demo && echo "tools/setup.sh: npm failed; without what it delivers, $1" >&2; }
}

# Exactly what package-lock.json names. The files beside them say which lock they came from, and what each file was then.
install_page() {
    echo "tools/setup.sh: installing the report page's npm packages into src/page/node_modules"
    npm --prefix src/page ci --ignore-scripts --no-audit --no-fund --loglevel=error </dev/null &&
        (cd src/page/node_modules && find . -type f ! -name '.cdr-*' -print0 | sort --zero-terminated |
            xargs --null sha256sum >.cdr-sums) &&
        cp "$lock" src/page/node_modules/.cdr-lock.json && return
    rm -rf src/page/node_modules # a part of it would be built
    return 1
}
has_npm_packages || get "cdr report makes no page" install_page

# Only that scene asks for it, and says so where it is missing.
get "the scene orbit has no Earth" third_party/orbit_data.sh

# Without it tangents are derived otherwise, and a note says so.
get "tangents that glTF files lack are not MikkTSpace's" third_party/mikktspace.sh
