#!/usr/bin/env bash
# Runs the tests on a newer QGIS, in a Debian root that is created once:
#
#   tools/test_in_root.sh trixie|forky [pytest arguments]
#   tools/test_in_root.sh trixie|forky -- COMMAND [arguments]   any command, in a copy of the working tree
#
# Roots are in $SEMREF_ROOTS (default ~/.cache/semref/roots). The script adds missing packages of the list below, and
# creates a removed root again. If a root cannot be created, the script prints the reason and skips the tests (exit 0).
set -euo pipefail

packages=(
    qgis python3-qgis xvfb xauth gdal-bin sqlite3 ca-certificates
    python3-numpy python3-opencv python3-onnxruntime python3-shapely python3-pytest python3-onnx python3-pil python3-pip
    python3-distributed python3-cryptography # Dask, in an older version than on this machine
)

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
data=${SEMREF_DATA:-$repository/../shared/data}
roots=${SEMREF_ROOTS:-$HOME/.cache/semref/roots}
name=${1:-}
# Each root has its own display numbers, because roots have separate lock files but share sockets with the machine.
case $name in
    trixie) script=trixie display=120 ;;
    forky) script=sid display=140 ;; # an older debootstrap does not know forky; sid's script makes it
    *) echo "Usage: $0 trixie|forky [pytest arguments | -- COMMAND]" >&2; exit 2 ;;
esac
shift
root=$roots/$name

skip() {
    echo "SKIPPED: tests in Debian $name were not run: $1" >&2
    exit 0
}

if [ "$(id -u)" != 0 ]; then
    sudo -n true 2>/dev/null || skip "making and entering a Debian root needs root or password-less sudo."
    exec sudo SEMREF_ROOTS="$roots" SEMREF_DATA="$data" CI="${CI:-}" SEMREF_ONE_AT_A_TIME="${SEMREF_ONE_AT_A_TIME:-}" \
        "$0" "$name" "$@"
fi

# With separate mount and process namespaces, mounts and processes end with the command.
# If the machine does not permit them, the command runs without /proc.
isolate() {
    if unshare --mount --pid --fork true 2>/dev/null; then
        unshare --mount --pid --fork --kill-child "$@"
    else
        "$@"
    fi
}

# in_root ROOT COMMAND...; $bind_data, if set, is the folder of the root for the data.
in_root() {
    isolate bash -c '
        root=$1 data=$2 target=$3
        shift 3
        mount -t proc proc "$root/proc" 2>/dev/null || true
        for part in /dev /dev/pts /dev/shm; do
            mount --bind "$part" "$root$part" 2>/dev/null || true
        done
        if [ -n "$target" ]; then
            mount --bind -o ro "$data" "$target" 2>/dev/null || true
        fi
        exec chroot "$root" "$@"' bash "$1" "$data" "${bind_data:-}" "${@:2}"
}

install_packages() {
    in_root "$1" env DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 sh -ec '
        apt-get -qq update
        apt-get -qq -y -o Dpkg::Options::=--force-unsafe-io -o Dpkg::Use-Pty=0 \
            install --no-install-recommends "$@"
        apt-get clean' sh "${packages[@]}" || return 1
    printf '%s\n' "${packages[@]}" >"$1/etc/semref-packages"
}

# In a subshell, so that the trap ends with it.
make_root() (
    rm -rf --one-file-system "$roots/.$name."* # what a killed run left
    building=$(mktemp -d "$roots/.$name.XXXXXX") || exit 1
    trap 'rm -rf --one-file-system "$building"' EXIT
    chmod 755 "$building"
    debootstrap --variant=minbase "$name" "$building" "" "/usr/share/debootstrap/scripts/$script" || exit 1
    # Services must not start in a root.
    printf '#!/bin/sh\nexit 101\n' >"$building/usr/sbin/policy-rc.d"
    chmod 755 "$building/usr/sbin/policy-rc.d"
    # Indexes of testing expire after a week, so a slow mirror would stop the tests. Signatures are still checked.
    echo 'Acquire::Check-Valid-Until "false";' >"$building/etc/apt/apt.conf.d/90semref"
    install_packages "$building" || exit 1
    mv "$building" "$root"
)

prepare_root() {
    local log=$roots/$name.log
    mkdir -p "$roots" || skip "the folder $roots cannot be made."
    exec 9>"$roots/$name.lock"
    flock 9
    if [ ! -d "$root" ]; then
        command -v debootstrap >/dev/null || skip "debootstrap is not installed (apt-get install debootstrap)."
        echo "Creating a Debian $name root in $root (some minutes, once; log: $log)" >&2
        make_root >"$log" 2>&1 </dev/null || skip "the root cannot be made today; last line of $log: $(tail -n 1 "$log")"
    elif ! printf '%s\n' "${packages[@]}" | cmp -s - "$root/etc/semref-packages"; then
        install_packages "$root" >"$log" 2>&1 </dev/null ||
            skip "packages cannot be installed today; last line of $log: $(tail -n 1 "$log")"
    fi
    exec 9>&-
}

prepare_root

work=$(mktemp -d "$root/tmp/semref.XXXXXX")
trap 'rm -rf --one-file-system "$work"' EXIT
mkdir -p "$work/semref" "$work/home" "$work/tmp"
git -c safe.directory="$repository" -C "$repository" ls-files -z --cached --others --exclude-standard |
    tar -C "$repository" --create --null --files-from=- --ignore-failed-read 2>/dev/null |
    tar -C "$work/semref" --extract --no-same-owner
if [ -d "$data" ]; then
    bind_data=$work/shared/data
    mkdir -p "$bind_data"
fi

inside=${work#"$root"}
# pip's index of this machine, for the test of a QGIS without packages.
pip=()
for name_of_variable in PIP_INDEX_URL PIP_TRUSTED_HOST PIP_DEFAULT_TIMEOUT; do
    [ -z "${!name_of_variable:-}" ] || pip+=("$name_of_variable=${!name_of_variable}")
done
if [ -r "${PIP_CERT:-}" ]; then
    cp "$PIP_CERT" "$work/pip.crt"
    pip+=(PIP_CERT="$inside/pip.crt")
fi
# The shell is the first process of the namespace, because Xvfb does not signal a first process.
run() {
    in_root "$root" env -i PATH=/usr/local/bin:/usr/bin:/bin:/usr/sbin:/sbin LANG=C.UTF-8 CI="${CI:-}" \
        HOME="$inside/home" TMPDIR="$inside/tmp" SEMREF_DATA="$inside/shared/data" PYTHONDONTWRITEBYTECODE=1 \
        SEMREF_DISPLAY="$display" SEMREF_ONE_AT_A_TIME="${SEMREF_ONE_AT_A_TIME:-}" "${pip[@]}" \
        sh -ec 'cd "$1"; shift; "$@"; exit 0' sh "$inside/semref" "$@"
}

if [ "${1:-}" = -- ]; then
    run "${@:2}"
    exit
fi

echo "Debian $name: $(run env QT_QPA_PLATFORM=offscreen /usr/bin/python3 -c '
import sys
import numpy
from qgis.core import Qgis
print(f"QGIS {Qgis.QGIS_VERSION}, Python {sys.version.split()[0]}, numpy {numpy.__version__}")')"
# Slow tests of tests/core need no QGIS and run on this machine.
run env SEMREF_QUICK_CORE=yes bash tools/pytest_suites.sh /usr/bin/python3 "$@"
