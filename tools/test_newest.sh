#!/usr/bin/env bash
# Runs tests/core with the newest wheels of what it needs, and with the oldest supported ones on Python 3.9:
#
#   tools/test_newest.sh [newest|oldest] [pytest arguments]
#
# Without a word: both, without the slow tests. A Python 3.9 is looked for on PATH and under ~/.pyenv; without one the
# oldest run is skipped and says so. Each has a virtual environment of its own, remade when older than a week.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
folder=${SEMREF_VERSIONS:-$PWD/.versions}
newest=(numpy opencv-python-headless onnxruntime shapely onnx pytest PyQt6)
# Debian 11's and older numpy; the first wheels that hold what SemRef uses.
oldest=(
    numpy==1.21.6 opencv-python-headless==4.6.0.66 shapely==2.0.0 onnxruntime==1.15.1
    onnx==1.14.1 'protobuf<4.25' pytest==8.4.2
)

find_python() { # VERSION: a Python of that version
    local found
    for found in "python$1" "$HOME"/.pyenv/versions/"$1".*/bin/python; do
        if command -v "$found" >/dev/null && "$found" -c "import sys; sys.exit('%d.%d' % sys.version_info[:2] != '$1')" 2>/dev/null; then
            echo "$found"
            return 0
        fi
    done
    return 1
}

make_venv() { # NAME PYTHON REQUIREMENT...
    local name=$1 python=$2
    shift 2
    if [ -n "$(find "$folder/$name/complete" -mtime -7 2>/dev/null)" ]; then return 0; fi
    rm -rf "${folder:?}/$name"
    "$python" -m venv "$folder/$name"
    "$folder/$name/bin/python" -m pip install --quiet --disable-pip-version-check --no-input --only-binary=:all: "$@" </dev/null
    touch "$folder/$name/complete"
}

run_tests() { # NAME [pytest arguments]
    local name=$1
    shift
    "$folder/$name/bin/python" -c 'import sys, numpy, cv2, onnxruntime, shapely
print("==", sys.argv[1], "Python", sys.version.split()[0], "numpy", numpy.__version__, "OpenCV", cv2.__version__,
      "onnxruntime", onnxruntime.__version__, "shapely", shapely.__version__)' "$name"
    SEMREF_BLOCK_QGIS=1 "$folder/$name/bin/python" -m pytest -q -p no:cacheprovider -m 'not slow' tests/core "$@" </dev/null
}

which=${1:-both}
[ $# = 0 ] || shift
case $which in newest | oldest | both) ;; *) echo "Say newest, oldest or nothing." >&2; exit 2 ;; esac
status=0
if [ "$which" != oldest ]; then
    make_venv newest "${SEMREF_NEWEST_PYTHON:-python3}" "${newest[@]}"
    run_tests newest "$@" || status=1
fi
if [ "$which" != newest ]; then
    if python=$(find_python 3.9); then
        make_venv oldest "$python" "${oldest[@]}"
        run_tests oldest "$@" || status=1
    else
        echo "== oldest: skipped, there is no Python 3.9 on PATH or under ~/.pyenv."
    fi
fi
exit $status
