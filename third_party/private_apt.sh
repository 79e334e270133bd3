# shellcheck shell=bash
# Sourced by scripts that take packages of another release than the system's, for example Debian 12's backports.
#
# apt gets a sources list, state and cache of its own, from the mirror that the system already uses. If the system's sources
# had a newer release, it could upgrade any package. Packages are downloaded and verified by Debian's key, never installed.
# Expects a function fail MESSAGE [STATUS].

# private_apt_open RELEASE: makes the folder $scratch, removed at exit, and fetches the package index of RELEASE into it.
private_apt_open() {
    local keyring=/usr/share/keyrings/debian-archive-keyring.gpg distribution mirror
    # shellcheck source=/dev/null
    distribution=$(. /etc/os-release && echo "$ID ${VERSION_CODENAME-}")
    [[ $distribution == debian\ * && -e $keyring ]] || fail "only Debian's packages are known here" 77

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
    echo "deb [signed-by=$keyring] $mirror $1 main" >"$scratch/sources.list"

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
    # Without --error-on an index that cannot be fetched is a warning only.
    private_apt update --error-on=any || fail "the mirror $mirror did not serve $1"
}

private_apt() { # quiet unless it fails
    (cd "$scratch" && apt-get --config-file apt.conf "$@") >"$scratch/log" 2>&1 </dev/null ||
        { cat "$scratch/log" >&2 && return 1; }
}
