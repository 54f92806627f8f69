#!/usr/bin/env bash
# Runs the four test suites, each in its environment:
#
#   tools/pytest_suites.sh PYTHON [pytest arguments]
#
# tests/core and tests/tools with QGIS, GDAL and Qt blocked, tests/qgis without a display, tests/gui in a virtual one.
# Two suites run at a time: core and tools in parallel with qgis and gui. The output of the first two appears at the end.
# After a failure the next suite still runs; the exit status is 1 if any suite failed. Each suite prints its processor
# time. With SEMREF_QUICK_CORE=yes the first three leave out slow tests.
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

# suite FOLDER PREFIX...; $leave_out, if set, has further pytest arguments
leave_out=()
suite() {
    local folder=$1 status=0
    shift
    [ -d "$folder" ] || return 0
    echo "== $folder"
    time "$@" "$python" -m pytest "$folder" "${leave_out[@]}" "${arguments[@]}" </dev/null || status=$?
    # A suite may be empty with a selection such as -k, but not without one.
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
# .ci/run uses the other core.
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
    echo "No test was run: no test matches ${arguments[*]:-tests/}." >&2
    exit 1
fi
