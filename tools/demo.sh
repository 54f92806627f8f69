#!/usr/bin/env bash
# Runs the main steps on the sample area: installs what is missing, creates the sample, builds a reference database from
# its shapefile, and localizes images of it. The layers are written to demo/.
set -euo pipefail
tools=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
"$tools/setup.sh"
"$tools/../.venv/bin/python" "$tools/demo.py" "$@"
