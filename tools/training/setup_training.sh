#!/usr/bin/env bash
# Makes .venv-train beside the code, with what training a network needs (training/requirements.txt).
# It is apart from .venv, because QGIS's numpy and torch's don't go together; nothing of it ships with the plugin.
# PYTHON=/path/to/python3 bash tools/training/setup_training.sh takes another Python than the first on PATH.
set -euo pipefail

repository=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
requirements=$repository/training/requirements.txt
venv=$repository/.venv-train

[ -x "$venv/bin/python" ] || "${PYTHON:-python3}" -m venv "$venv"
# torch first and alone: what your package index gives for it (a CPU or CUDA build) then stays.
"$venv/bin/python" -m pip install --quiet "$(grep '^torch==' "$requirements")"
"$venv/bin/python" -m pip install --quiet --requirement "$requirements"
echo "Ready: $venv/bin/python tools/training/train_pan.py --help"
