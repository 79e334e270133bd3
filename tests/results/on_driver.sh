# shellcheck shell=bash
# What drivers.sh and promises.sh share. Both work in the folder `scratch`, which goes when they end.

scratch=$(mktemp -d)
trap 'rm -r "$scratch"' EXIT

# Runs a command on a driver of tools/drivers.sh, or on the card.
on() { # DRIVER COMMAND...
    local driver=$1
    if [[ $driver == card ]]; then driver=system; fi
    tools/drivers.sh "$driver" "${@:2}"
}

# Version, depth formats, sub-pixel bits, and whether the device draws gpu-driven. The version is that of the package where
# tools/drivers.sh took the driver from one.
device() { # DRIVER
    local version=
    on "$1" build/release/bin/cdr devices --json "$scratch/devices.json" >/dev/null
    if [[ -e .cache/drivers/$1/packages ]]; then version=$(head -1 ".cache/drivers/$1/packages"); fi
    # shellcheck disable=SC2016 # JavaScript expands it
    node -e '
        const [file, driver, version] = process.argv.slice(1);
        const [device] = JSON.parse(require("fs").readFileSync(file)).results;
        const gpuDriven = device.gpu_driven_missing.length === 0 ? "yes" : "no";
        const name = driver === "card" ? `${device.name}: ${device.driver}` : version || device.driver;
        console.log([name, device.depth_formats.join(" "), device.sub_pixel_bits, gpuDriven].join(","));
    ' "$scratch/devices.json" "$1" "$version"
}
