#!/usr/bin/env bash
# Installs what is missing, checks the code, and runs all tests: tools/test.sh [pytest arguments]
set -euo pipefail
tools=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
"$tools/setup.sh"
"$tools/lint.sh"
"$tools/pytest_suites.sh" "$tools/../.venv/bin/python" "$@"
