#!/usr/bin/env bash
# Branch coverage of core/ by tests/core, with what is not reached: tools/coverage.sh [pytest arguments]
#
# Ends with 1 below 95 %. Slow tests are among them, as some modules have no others; -m "not slow" leaves them out.
# `python -m core` runs in processes of its own, which are not counted.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
python=$PWD/.venv/bin/python
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export COVERAGE_FILE=$folder/coverage SEMREF_BLOCK_QGIS=1

"$python" -m coverage run -m pytest tests/core -q -p no:cacheprovider "$@"
"$python" -m coverage report
