#!/usr/bin/env bash
# Measures the branch coverage of core/ by tests/core and lists missing branches: tools/coverage.sh [pytest arguments]
#
# The exit status is 1 below 95 %. Slow tests also run, because some modules have only slow tests; -m "not slow" leaves
# them out. Separate processes of `python -m core` do not count.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
python=$PWD/.venv/bin/python
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export COVERAGE_FILE=$folder/coverage SEMREF_BLOCK_QGIS=1

"$python" -m coverage run -m pytest tests/core -q -p no:cacheprovider "$@"
"$python" -m coverage report
