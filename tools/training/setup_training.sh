#!/usr/bin/env bash
# Creates .venv-train next to the code, with the packages for training (training/requirements.txt).
# It is separate from .venv, because QGIS and torch need different versions of numpy. The plugin does not contain it.
# PYTHON=/path/to/python3 bash tools/training/setup_training.sh uses another Python than the first on PATH.
set -euo pipefail

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
requirements=$repository/training/requirements.txt
venv=$repository/.venv-train

[ -x "$venv/bin/python" ] || "${PYTHON:-python3}" -m venv "$venv"
# torch is installed first, so that the build of your package index (CPU or CUDA) stays.
"$venv/bin/python" -m pip install --quiet "$(grep '^torch==' "$requirements")"
"$venv/bin/python" -m pip install --quiet --requirement "$requirements"
echo "Ready: $venv/bin/python tools/training/train_pan.py --help"
