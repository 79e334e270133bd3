#!/usr/bin/env bash
# Runs a program under the newest validation layer that Debian has. It has checks that older layers lack: load operations
# after store operations, and buffers that shaders read and write.
# Usage: tools/layers.sh [--shaders] PROGRAM [ARGUMENT...]
#   --shaders  follow buffers into shaders too; the layer guesses there, and takes atomics for hazards
#
# The layer needs a newer C library than Debian 12 has, so it comes with one. PROGRAM, a binary, runs on that. What is missing
# is downloaded through apt and unpacked into .cache/layers. Nothing is installed. Status 77 where apt is not there for that.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
unpacked=$root/.cache/layers
packages=(vulkan-validationlayers libc6 libstdc++6 libgcc-s1)

fail() { # MESSAGE [STATUS]
    echo "tools/layers.sh: $1" >&2
    exit "${2-1}"
}

fetch() {
    local package new
    echo "tools/layers.sh: fetching ${packages[*]} of Debian unstable into .cache/layers (20 MB)" >&2
    cd "$root"
    # shellcheck source=third_party/private_apt.sh
    source third_party/private_apt.sh
    private_apt_open sid
    private_apt download "${packages[@]}" || fail "the mirror lacks one of ${packages[*]}"
    new=$scratch/unpacked && mkdir "$new"
    for package in "$scratch"/*.deb; do
        dpkg-deb --extract "$package" "$new"
        # shellcheck disable=SC2016 # dpkg expands them
        dpkg-deb --showformat '${Package} ${Version}\n' --show "$package" >>"$new/packages"
    done
    mkdir -p .cache && rm -rf "$unpacked" && mv "$new" "$unpacked"
}

[[ ${1-} != --shaders ]] || { export VK_KHRONOS_VALIDATION_SYNCVAL_SHADER_ACCESSES_HEURISTIC=1 && shift; }
(($#)) || { sed -n 's/^# \(Usage: .*\)/\1/p' "${BASH_SOURCE[0]}" >&2 && exit 2; }
[[ -e $unpacked/packages ]] || (fetch) # a shell of its own: what is removed at its exit would stay after exec
libraries=$(dirname "$(find "$unpacked" -name libVkLayer_khronos_validation.so)")
export VK_LAYER_PATH=$unpacked/usr/share/vulkan/explicit_layer.d
export VK_KHRONOS_VALIDATION_SYNCVAL_LOAD_OP_AFTER_STORE_OP_VALIDATION=1
# Surfaces write their emission, and translucent ones their count, even where no attachment takes it, as the specification allows.
export VK_KHRONOS_VALIDATION_MESSAGE_ID_FILTER=Undefined-Value-ShaderOutputNotConsumed-DynamicRendering
exec "$(find "$libraries" -name 'ld-linux*')" --library-path "$libraries" "$@"
