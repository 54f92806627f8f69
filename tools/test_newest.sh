#!/usr/bin/env bash
# Runs tests/core with the newest wheels, and with the oldest supported wheels on Python 3.9:
#
#   tools/test_newest.sh [newest|oldest] [pytest arguments]
#
# Without an argument both run, without slow tests. The newest run also paints widgets of ui/ with PyQt6. The script finds
# Python 3.9 on PATH or in ~/.pyenv; SEMREF_NEWEST_PYTHON names another Python for the newest run. Each run has its own
# virtual environment, created again after a week. If wheels are missing, the script prints this and skips (exit 0).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
folder=${SEMREF_VERSIONS:-$PWD/.versions}
newest=(numpy opencv-python-headless pillow onnxruntime shapely onnx jinja2 pytest)
qt=PyQt6
# numpy of Debian 11 or older; the first wheels with everything that SemRef uses.
oldest=(
    numpy==1.21.6 opencv-python-headless==4.6.0.66 pillow==9.1.0 shapely==2.0.0 onnxruntime==1.15.1
    onnx==1.14.1 'protobuf<4.25' jinja2==3.0.3 pytest==8.4.2
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
    install_wheels "$name" "$@" || return 1
    if [ "$name" = newest ] && ! install_wheels "$name" "$qt"; then
        echo "SKIPPED: tests with Qt 6 were not run: there is no wheel of $qt for $python today." >&2
    fi
    touch "$folder/$name/complete"
}

install_wheels() { # NAME REQUIREMENT...
    "$folder/$1/bin/python" -m pip install --quiet --disable-pip-version-check --no-input --only-binary=:all: "${@:2}" </dev/null
}

run_tests() { # NAME [pytest arguments]
    local name=$1
    shift
    "$folder/$name/bin/python" -c 'import sys, numpy, cv2, onnxruntime, PIL, shapely
print("==", sys.argv[1], "Python", sys.version.split()[0], "numpy", numpy.__version__, "OpenCV", cv2.__version__,
      "Pillow", PIL.__version__, "onnxruntime", onnxruntime.__version__, "shapely", shapely.__version__)' "$name"
    SEMREF_BLOCK_QGIS=1 "$folder/$name/bin/python" -m pytest -q -rs -p no:cacheprovider -m 'not slow' tests/core "$@" </dev/null
}

test_with() { # NAME PYTHON [pytest arguments]
    local name=$1 python=$2
    local -n wheels=$name
    shift 2
    if make_venv "$name" "$python" "${wheels[@]}"; then
        run_tests "$name" "$@" || status=1
    else
        echo "SKIPPED: tests with the $name wheels were not run: pip cannot install them today. See its message above." >&2
    fi
}

which=${1:-both}
[ $# = 0 ] || shift
case $which in newest | oldest | both) ;; *) echo "Use newest, oldest or no argument." >&2; exit 2 ;; esac
status=0
if [ "$which" != oldest ]; then
    test_with newest "${SEMREF_NEWEST_PYTHON:-python3}" "$@"
fi
if [ "$which" != newest ]; then
    if python=$(find_python 3.9); then
        test_with oldest "$python" "$@"
    else
        echo "SKIPPED: tests with the oldest wheels were not run: no Python 3.9 is on PATH or under ~/.pyenv." >&2
    fi
fi
exit $status
