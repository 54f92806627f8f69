#!/usr/bin/env bash
# The main job on the sample area: sets up what is missing, makes the sample, builds a reference database from its
# shapefile, and localizes its pictures; the layers stay in demo/.
set -euo pipefail
tools=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
"$tools/setup.sh"
"$tools/../.venv/bin/python" "$tools/demo.py" "$@"
