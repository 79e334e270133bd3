#!/usr/bin/env bash
# Builds cdr::depth as an engine author does, without any other package, and installs it. Builds and runs an example of it
# outside the source tree, by CMake and by pkg-config. Then installs cdr::render from a build of all, and compiles each
# installed header alone. Builds and runs the examples as debug programs, from static libraries and from shared ones. The
# examples print what their page says, and headers.txt names what is installed for an engine to include.
# Usage: package_test.sh SOURCE_DIR [BUILD_DIR]
set -euo pipefail

source_dir=$(cd "$1" && pwd)
# shellcheck source=tests/package/common.sh
source "$source_dir/tests/package/common.sh"

# refuse REASON [CMAKE_ARGUMENT...]: find_package() of an installed cdr ends with this reason.
refuse() {
    local reason=$1
    shift
    if cmake -G Ninja -S "$source_dir/tests/package/components" -B "$work/refused" "$@" >"$work/log" 2>&1; then
        echo "this was not refused: $*" >&2
        exit 1
    fi
    tr -s ' \n' ' ' <"$work/log" | grep -qF "$reason" || { cat "$work/log" >&2 && echo "not said: $reason" >&2 && exit 1; }
    rm -rf "$work/refused"
}

# expect_licences PREFIX NAME...: these files are installed with cdr, and no other.
expect_licences() {
    [[ $(cd "$1/share/doc/cdr" && find . -type f -printf '%P\n' | LC_ALL=C sort | paste --serial --delimiters=' ') == "${*:2}" ]] ||
        { echo "installed without its licence, or with another: $1" >&2 && exit 1; }
}

install_cdr plain ""
expect_licences "$work/plain/prefix" LICENSE
expect_output "$work/plain/example/depth_only"
if ldd "$work/plain/example/depth_only" | grep -E 'fmt|vulkan|crypto|json'; then
    echo "the example links more than the compiler's libraries" >&2
    exit 1
fi
included=$(ninja -C "$work/plain/example" -t deps)
if [[ $included != *cdr/depth/mapping.h* ]] || grep -E '/(vulkan|fmt|glm|nlohmann|openssl)/' <<<"$included"; then
    echo "the example includes other packages' headers" >&2
    exit 1
fi

refuse "component scene is not in this package" "-DCMAKE_PREFIX_PATH=$work/plain/prefix"

pc_dir=$(dirname "$(find "$work/plain/prefix" -name cdr.pc)")
read -ra flags < <(PKG_CONFIG_PATH=$pc_dir pkg-config --define-prefix --cflags --libs cdr)
quiet c++ -std=c++20 "-I$poison" "$source_dir/src/examples/depth_only/"{main,draw_anchored}.cpp "${flags[@]}" -o "$work/by_pkg_config"
expect_output "$work/by_pkg_config"

# Folders may be absolute, for example those of a distribution.
quiet cmake -G Ninja -S "$source_dir" -B "$work/absolute" -DCDR_BUILD_RENDER=OFF "${hidden[@]}" \
    -DCMAKE_INSTALL_LIBDIR=/opt/lib64 -DCMAKE_INSTALL_INCLUDEDIR=/opt/include
if [[ $(pkg-config --cflags --libs "$work/absolute/static/cdr.pc") != "-I/opt/include -L/opt/lib64 "* ]]; then
    cat "$work/absolute/static/cdr.pc" >&2
    echo "cdr.pc does not name the folders where libraries and headers are" >&2
    exit 1
fi

if (($# < 2)); then
    echo "render: skipped, this build's libraries need more of the linker"
    exit 3
fi
build_dir=$(cd "$2" && pwd)

# expect_lines PROGRAM [FILE]: what it prints; without a file, what the examples' page says. The device has a name of its own.
expect_lines() {
    "$1" >"$work/output" || { cat "$work/output" >&2 && echo "failed: $1" >&2 && exit 1; }
    sed -i 's/^the borrowed device .* was made/the borrowed device DEVICE was made/' "$work/output"
    diff <(if (($# > 1)); then cat "$2"; else printed "$(basename "$1")"; fi) "$work/output" >&2 ||
        { echo "unexpected output of $1" >&2 && exit 1; }
}

# The allocator's header that cdr was built with, for hosts that have the allocator too.
vma_folder=$(sed -n 's/^VMA_INCLUDE_DIR:PATH=//p' "$build_dir/CMakeCache.txt")

# build_example NAME FOLDER: a debug program, whatever the library is, but without -g: nobody debugs it. Its sources are compiled
# as one, since the headers of Vulkan take most of the time.
build_example() {
    quiet cmake -G Ninja -S "$source_dir/src/examples/$1" -B "$2" -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG= \
        -DCMAKE_UNITY_BUILD=ON \
        -DCMAKE_CXX_FLAGS="-Wall -Wextra -Werror" -DCMAKE_PREFIX_PATH="$work/render" -DVMA_INCLUDE_DIR="$vma_folder"
    quiet cmake --build "$2"
}

quiet cmake --install "$build_dir" --component cdr_static --prefix "$work/render"
# expect_headers PREFIX: the headers and shaders that the list names are there and no other, so that a new one is installed
# knowingly.
expect_headers() {
    local at
    at=$(dirname "$(find "$1" -path '*/cdr/base')")
    diff "$source_dir/tests/package/headers.txt" <(cd "$at" && find . -type f -printf '%P\n' | LC_ALL=C sort) >&2 ||
        { echo "tests/package/headers.txt names what is installed; change it with what you install" >&2 && exit 1; }
}
expect_headers "$work/render"
expect_licences "$work/render" LICENSE third_party/LICENCES.md
# Without a component: one kind of libraries, and the programs with what a shell and man read of them.
quiet cmake --install "$build_dir" --prefix "$work/whole"
kind=$(sed -n 's/^BUILD_SHARED_LIBS:BOOL=ON$/shared/p' "$build_dir/CMakeCache.txt")
quiet cmake --install "$build_dir" --component "cdr_${kind:-static}" --prefix "$work/libraries"
programs=(bin/cdr share/{bash-completion/completions/cdr,fish/vendor_completions.d/cdr.fish,man/man1/cdr.1,zsh/site-functions/_cdr})
if [[ -e $build_dir/bin/cdr-viewer ]]; then programs+=(bin/cdr-viewer); fi
files_in() { find "$1" ! -type d -printf '%P\n'; }
diff <({ files_in "$work/libraries" && printf '%s\n' "${programs[@]}"; } | sort) <(files_in "$work/whole" | sort) >&2 ||
    { echo "the whole installation is not one kind of libraries and the programs" >&2 && exit 1; }
rm -r "$work/whole" "$work/libraries"

# Each installed header compiles alone, from what is installed. One that another header includes first is compiled with that
# one: nothing that could help it comes before, since export.h holds macros alone.
compile_headers() {
    printf '#include <%s>\n' "$@" | c++ -std=c++20 -fsyntax-only -Wall -Wextra -Wpedantic -Werror -DVK_NO_PROTOTYPES -I. -x c++ -
}
export -f compile_headers
headers=$(dirname "$(find "$work/render" -path '*/cdr/base')")
mapfile -t installed < <(cd "$headers/.." && find cdr -name '*.h' | LC_ALL=C sort)
included_first() {
    local header
    for header in "${installed[@]}"; do
        sed -n 's/^#include [<"]\(.*\)[>"]$/\1/p' "$headers/../$header" | sed '\,^cdr/base/export[.]h$,d' | sed 1q
    done | grep '^cdr/' | LC_ALL=C sort -u
}
if grep -q '^#include' "$headers/base/export.h"; then
    echo "export.h includes a header, so that it is no longer like nothing" >&2
    exit 1
fi
# Some of them; CDR_ALL_CASES takes all. tools/check.sh does, and compiles each alone from the sources too.
every=$([[ -n ${CDR_ALL_CASES-} ]] && echo 1 || echo 10)
mapfile -t alone < <(printf '%s\n' "${installed[@]}" | LC_ALL=C comm -23 - <(included_first) | awk "NR % $every == 0")
# shellcheck disable=SC2016 # expanded by the inner shell
if ! { printf '%s\n' "${alone[@]}" | (cd "$headers/.." &&
    xargs --max-args=1 --max-procs="$(nproc)" bash -c 'compile_headers "$1"' compile_headers) &&
    (cd "$headers/.." && compile_headers "${installed[@]}" "${installed[@]}"); } >"$work/log" 2>&1; then
    cat "$work/log" >&2
    echo "an installed header does not compile alone, or not twice" >&2
    exit 1
fi
echo "headers: ${#installed[@]} are installed; they compile together twice, and ${#alone[@]} of them alone"

# GLM's aligned types would give structs another layout than the libraries have.
if printf '#define GLM_FORCE_INTRINSICS\n#define GLM_FORCE_DEFAULT_ALIGNED_GENTYPES\n#include <cdr/scene/%s.h>\n' mesh camera |
    c++ -std=c++20 -fsyntax-only "-I$headers/.." -x c++ - >"$work/log" 2>&1 ||
    ! grep -q "/mesh[.]h:.*leave out GLM_FORCE_DEFAULT_ALIGNED_GENTYPES" "$work/log" ||
    ! grep -q "/camera[.]h:.*leave out GLM_FORCE_DEFAULT_ALIGNED_GENTYPES" "$work/log"; then
    cat "$work/log" >&2
    echo "mesh.h or camera.h takes GLM's aligned types, or does not say why not" >&2
    exit 1
fi

# The scene alone, and what is said where a package is missing.
static=("-DCMAKE_PREFIX_PATH=$work/render")
quiet cmake -G Ninja -S "$source_dir/tests/package/components" -B "$work/scene_only" "${static[@]}" \
    -DCMAKE_DISABLE_FIND_PACKAGE_Vulkan=TRUE -DCMAKE_DISABLE_FIND_PACKAGE_OpenSSL=TRUE # which the programs alone need
quiet cmake --build "$work/scene_only"
echo "2 instances in 2 cascades" >"$work/scene_only.txt"
expect_lines "$work/scene_only/scene_only" "$work/scene_only.txt"
if ninja -C "$work/scene_only" -t deps | grep '/vulkan/' || [[ $(ldd "$work/scene_only/scene_only") == *libvulkan* ]]; then
    echo "the scene needs Vulkan" >&2
    exit 1
fi
refuse "component scene needs the package glm, which was not found" "${static[@]}" -DCMAKE_DISABLE_FIND_PACKAGE_glm=TRUE
refuse "component scene needs the package draco, which was not found" "${static[@]}" -DCMAKE_DISABLE_FIND_PACKAGE_draco=TRUE
# What an engine has already, as a target, is not looked for: draco's own package stops then.
quiet cmake -G Ninja -S "$source_dir/tests/package/components" -B "$work/has_draco" "${static[@]}" -DENGINE_HAS=draco \
    -DCMAKE_DISABLE_FIND_PACKAGE_draco=TRUE
refuse "component render needs the package Vulkan 1.3.239, which was not found" "${static[@]}" -DCOMPONENTS=render \
    -DCMAKE_DISABLE_FIND_PACKAGE_Vulkan=TRUE
PKG_CONFIG_LIBDIR=/nowhere refuse "component scene needs the package spng, which pkg-config did not find" "${static[@]}"
refuse "component scenes is none of depth, scene and render" "${static[@]}" -DCOMPONENTS=scenes
refuse "component render needs the package Vulkan 1.3.239, which was not found" "${static[@]}" -DCOMPONENTS=render -DOPTIONAL=scenes \
    -DCMAKE_DISABLE_FIND_PACKAGE_Vulkan=TRUE # not what is optional
echo "components: the scene alone needs no Vulkan, and what is missing is named"

build_example moving_world "$work/moving_world"
expect_lines "$work/moving_world/moving_world"
included=$(ninja -C "$work/moving_world" -t deps)
if [[ $included != *cdr/render/renderer.h* ]] || grep -E '/vulkan[.]hpp|/vk_mem_alloc|/(fmt|nlohmann)/|/cdr/shaders/' <<<"$included"; then
    echo "the renderer's interface includes what it should keep inside" >&2
    exit 1
fi
calls=$(nm --undefined-only "$(find "$work/render" -name libcdr_gpu.a)" "$(find "$work/render" -name libcdr_render.a)")
if grep -E ' vk[A-Z]' <<<"$calls" || [[ $(ldd "$work/moving_world/moving_world") == *libvulkan* ]]; then
    echo "the static libraries call Vulkan's functions by name, or their users link the system's loader" >&2
    exit 1
fi
build_example borrowed_device "$work/borrowed_device"
expect_lines "$work/borrowed_device/borrowed_device"
# A program with an allocator of its own, whose functions have the names of those that cdr brings.
cat >"$work/allocator.txt" <<'EOF'
id 42 at 4.000000
from the host's allocator: yes
left: 1, the host's own
EOF
build_example ../../tests/package/allocator "$work/allocator"
expect_lines "$work/allocator/allocator_host" "$work/allocator.txt"
# A program whose functions of Vulkan are variables, which would be called by mistake if cdr called any by name.
cat >"$work/volk.txt" <<'EOF'
id 42 at 4.000000
asked the program's loader: yes
the process already calls Vulkan by another loader; hand the host's in before the first use of cdr::gpu
EOF
if [[ -e /usr/include/volk.h ]]; then
    build_example ../../tests/package/volk "$work/volk"
    expect_lines "$work/volk/volk_host" "$work/volk.txt"
else
    echo "volk: not built, there is no volk.h (libvulkan-volk-dev)"
fi
build_example host_compositing "$work/host_compositing"
expect_lines "$work/host_compositing/host_compositing"
echo "render: installed, examples built and run"

# The same from shared libraries, which give out what the installed headers declare and what they call of each other. They come
# beside the static ones, and what is installed last is found. The examples are linked anew, and compiled anew only where they
# would be otherwise.
quiet cmake --install "$build_dir" --component cdr_shared --prefix "$work/render"
libraries=$(dirname "$(find "$work/render" -name libcdr_render.so)")
headers=$(dirname "$(find "$work/render" -path '*/cdr/base')")
expect_headers "$work/render"
if grep '[.]a$' "$build_dir/install_manifest_cdr_shared.txt"; then
    echo "the shared package holds static libraries" >&2
    exit 1
fi
exported=$(nm --dynamic --demangle --defined-only "$libraries"/libcdr_{depth,scene,render}.so | sed -nE 's/^[0-9a-f]+ [^i] //p' |
    grep -v '[.]resolver') # compilers give these out for functions that they make once for each kind of CPU
if ! grep -q '^cdr::render::Renderer::render(' <<<"$exported" || grep -vE '^((typeinfo|typeinfo name|vtable) for )?cdr::' <<<"$exported"; then
    echo "the shared libraries give out what is not cdr's, or no renderer" >&2
    exit 1
fi
needed=$(nm --dynamic --demangle --undefined-only "$libraries"/libcdr_{scene,render}.so | sed -nE 's/^ +U (cdr::)/\1/p')
known=$(cat "$headers"/*/*.h "$headers"/*/*/*.h | grep -oE '\w+' | sort -u)
# The last name before the parameters: cdr::base::fixed[abi:cxx11](double, int) is fixed. What is inside a class that is
# given out comes along.
unknown=$(grep -E '^cdr::' <<<"$exported" | grep -vxFf <(echo "$needed") | grep -vE '::(Batch|Handles|Passes|Slot|State|Writer)::' | sed -E 's/\[abi:cxx11\]//g; s/\(.*//; s/<.*//; s/.*:://; s/^~//' | sort -u |
    grep -vE '^operator' | comm -23 - <(echo "$known"))
if [[ -n $unknown ]]; then
    echo "the shared libraries give out what no installed header declares: $unknown" >&2
    exit 1
fi
build_example depth_only "$work/depth_only"
expect_output "$work/depth_only/depth_only"
for example in moving_world borrowed_device host_compositing; do
    build_example "$example" "$work/$example"
    expect_lines "$work/$example/$example"
    if [[ $(ldd "$work/$example/$example") != *"$libraries/libcdr_render.so.1.0"* ]]; then
        echo "$example does not use the shared library" >&2
        exit 1
    fi
done
build_example ../../tests/package/allocator "$work/allocator"
expect_lines "$work/allocator/allocator_host" "$work/allocator.txt"
echo "shared: installed, examples built and run"
