#!/usr/bin/env bash
# Installs everything for development, tests and the demo on Debian 12, and creates .venv next to the code.
# You can run it again: it keeps what exists, and then needs no network.
set -euo pipefail

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
venv=$repository/.venv
python=/usr/bin/python3 # QGIS's Python; the python3 on PATH may be another one
requirements=("$repository/tools/requirements.txt" "$repository/tools/requirements-dev.txt")
packages=(
    qgis python3-qgis python3-numpy python3-scipy python3-pil gdal-bin sqlite3
    python3-venv python3-pip pyqt5-dev-tools qttools5-dev-tools
    xvfb xauth debootstrap ca-certificates git
)

fail() {
    echo "Set-up failed: $1" >&2
    exit 1
}

as_root() {
    if [ "$(id -u)" = 0 ]; then
        "$@"
    elif command -v sudo >/dev/null; then
        sudo "$@"
    else
        fail "Debian packages are missing (${missing[*]}); install them as root or install sudo."
    fi
}

missing_packages() {
    for package in "${packages[@]}"; do
        # shellcheck disable=SC2016 # ${Status} is dpkg-query's, not the shell's
        grep -q '^install ok installed' <<<"$(dpkg-query -W -f '${Status}' "$package" 2>/dev/null)" || echo "$package"
    done
}

install_packages() {
    mapfile -t missing < <(missing_packages)
    [ ${#missing[@]} -gt 0 ] || return 0
    echo "Installing Debian packages: ${missing[*]}"
    as_root apt-get -qq update </dev/null || fail "apt-get update did not work; check the network, the package sources and your rights."
    as_root env DEBIAN_FRONTEND=noninteractive apt-get -qq -y -o Dpkg::Use-Pty=0 \
        install --no-install-recommends "${missing[@]}" </dev/null >/dev/null ||
        fail "apt-get could not install ${missing[*]}; see its message above."
}

# Everything that the environment depends on. After a change the environment is created again.
venv_state() {
    local versions
    versions=$("$python" -c 'import sys, numpy; print(sys.version.split()[0], numpy.__version__)') ||
        fail "$python has no numpy; install python3-numpy."
    echo "$venv $versions $(cat "${requirements[@]}" | sha256sum | cut -d' ' -f1)"
}

make_venv() {
    local state=$1 numpy
    rm -rf "$venv"
    "$python" -m venv --system-site-packages "$venv" || fail "the virtual environment $venv could not be made."
    # pip must keep the numpy that QGIS is built with.
    numpy=$("$python" -c 'import numpy; print(numpy.__version__)')
    "$venv/bin/python" -m pip install --quiet --disable-pip-version-check --no-input \
        --constraint <(echo "numpy==$numpy") "${requirements[@]/#/--requirement=}" </dev/null ||
        fail "pip could not install the packages pinned in tools/requirements*.txt; see its message above."
    echo "$state" >"$venv/state"
}

[ -r /etc/debian_version ] || fail "this script knows Debian's package names only; see the README for what is needed."
install_packages
[ -x "$python" ] || fail "$python is missing; install python3."
# Two scripts at the same time must not create the same virtual environment.
exec 9>"$repository/.git/semref-setup.lock" 2>/dev/null || exec 9>/dev/null
flock 9 2>/dev/null || true
state=$(venv_state)
if [ "$(cat "$venv/state" 2>/dev/null)" != "$state" ]; then
    echo "Creating the virtual environment $venv"
    make_venv "$state"
fi
"$venv/bin/python" -c 'import cv2, numpy, qgis.core' 2>/dev/null ||
    fail "$venv/bin/python cannot import QGIS, numpy and OpenCV; remove $venv and run this again."
(cd "$repository" && "$venv/bin/python" -m tools.sample) || fail "the sample area could not be made; see the message above."
