#!/usr/bin/env bash
# Runs the four test suites, each in the surroundings it needs:
#
#   tools/pytest_suites.sh PYTHON [pytest arguments]
#
# tests/core and tests/tools with QGIS, GDAL and Qt blocked, tests/qgis without a display, tests/gui in a virtual one.
# Two at a time: core and tools beside qgis and gui; what the first two say is shown when all are through. A suite that
# fails does not keep the next from running; the exit status tells whether any failed. Each tells its processor time.
# With SEMREF_QUICK_CORE=yes the first three leave out slow tests.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
python=$1
shift
arguments=("$@")
no_tests_collected=5 # pytest's exit status
TIMEFORMAT='   %R s, of the processor %U s'

quick=()
[ "${SEMREF_QUICK_CORE:-}" != yes ] || quick=(-m "not slow")

outcomes=$(mktemp -d)
trap 'rm -rf "$outcomes"' EXIT

# suite FOLDER PREFIX...; $leave_out, where set, are arguments of pytest for it
leave_out=()
suite() {
    local folder=$1 status=0
    shift
    [ -d "$folder" ] || return 0
    echo "== $folder"
    time "$@" "$python" -m pytest "$folder" "${leave_out[@]}" "${arguments[@]}" </dev/null || status=$?
    # A selection such as -k may well leave a suite empty; a suite without selection may not be.
    if [ $status = $no_tests_collected ] && [ ${#arguments[@]} -gt 0 ]; then
        return 0
    fi
    [ $status = 0 ] || echo "$folder" >>"$outcomes/failed"
    touch "$outcomes/ran"
}

{
    leave_out=("${quick[@]}")
    suite tests/core env SEMREF_BLOCK_QGIS=1
    suite tests/tools env SEMREF_BLOCK_QGIS=1
    suite tests/training env SEMREF_BLOCK_QGIS=1
} >"$outcomes/output" 2>&1 &
# .ci/run has something else to do for the other core.
[ -z "${SEMREF_ONE_AT_A_TIME:-}" ] || wait
suite tests/qgis env QT_QPA_PLATFORM=offscreen
suite tests/gui env --unset=QT_QPA_PLATFORM --unset=WAYLAND_DISPLAY \
    xvfb-run --auto-servernum --server-num="${SEMREF_DISPLAY:-99}" --server-args='-screen 0 1600x1000x24'
wait
cat "$outcomes/output"

if [ -e "$outcomes/failed" ]; then
    echo "Tests failed in: $(sort "$outcomes/failed" | tr '\n' ' ')" >&2
    exit 1
fi
if [ ! -e "$outcomes/ran" ]; then
    echo "No test was run: nothing fits ${arguments[*]:-tests/}." >&2
    exit 1
fi
