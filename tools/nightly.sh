#!/usr/bin/env bash
# Runs the checks that take too long for every change: all tests on QGIS 3.40 and 3.44, core on the oldest wheels, and
# fuzzing of the readers. Run it before you close an issue.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
tools/setup.sh
export SEMREF_ONE_AT_A_TIME=yes
bash tools/side_by_side.sh \
    "Debian trixie: bash tools/test_in_root.sh trixie" \
    "Oldest wheels: bash tools/test_newest.sh oldest" \
    -- \
    "Debian forky: bash tools/test_in_root.sh forky" \
    "Fuzz: .venv/bin/python -m tools.fuzz --examples 400" \
    </dev/null
