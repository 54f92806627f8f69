#!/usr/bin/env bash
# Runs the four test suites, each in the surroundings it needs:
#
#   tools/pytest_suites.sh PYTHON [pytest arguments]
#
# tests/core and tests/tools with QGIS, GDAL and Qt blocked, tests/qgis without a display, tests/gui in a virtual one.
# A suite that fails does not keep the next from running; the exit status tells whether any failed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
python=$1
shift
arguments=("$@")
failed=()
ran=no
no_tests_collected=5 # pytest's exit status

# suite FOLDER PREFIX...
suite() {
    local folder=$1 status=0
    shift
    [ -d "$folder" ] || return 0
    echo "== $folder"
    "$@" "$python" -m pytest "$folder" "${arguments[@]}" </dev/null || status=$?
    # A selection such as -k may well leave a suite empty; a suite without selection may not be.
    if [ $status = $no_tests_collected ] && [ ${#arguments[@]} -gt 0 ]; then
        return 0
    fi
    ran=yes
    [ $status = 0 ] || failed+=("$folder")
}

suite tests/core env SEMREF_BLOCK_QGIS=1
suite tests/tools env SEMREF_BLOCK_QGIS=1
suite tests/qgis env QT_QPA_PLATFORM=offscreen
suite tests/gui env --unset=QT_QPA_PLATFORM --unset=WAYLAND_DISPLAY \
    xvfb-run --auto-servernum --server-args='-screen 0 1600x1000x24'

if [ ${#failed[@]} -gt 0 ]; then
    echo "Tests failed in: ${failed[*]}" >&2
    exit 1
fi
if [ $ran = no ]; then
    echo "No test was run: nothing fits ${arguments[*]:-tests/}." >&2
    exit 1
fi
