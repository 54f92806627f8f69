#!/usr/bin/env bash
# Checks the code without running it: ruff, mypy and the English of all texts, then Bandit, detect-secrets and flake8 on the
# unpacked zip with the options of the plugin repository, which rejects a zip with findings.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
repository=$PWD
python=$repository/.venv/bin/python

"$python" -m ruff check --quiet .
"$python" -m ruff format --check --quiet . || {
    echo "Lint: some files are not formatted. Run \`ruff format .\`." >&2
    exit 1
}
"$python" -m mypy --no-error-summary
"$python" tools/prose.py

unpacked=$(mktemp -d)
trap 'rm -rf "$unpacked"' EXIT
"$python" tools/release/package.py --output "$unpacked/semref.zip" >/dev/null
"$python" -m zipfile -e "$unpacked/semref.zip" "$unpacked/plugin"
cd "$unpacked/plugin"

# These three take most of the time, so files that were clean are not checked again.
known=$repository/.venv/linted
state=$({
    find . -type f -print0 | sort --zero-terminated | xargs --null sha256sum
    cat "$repository/tools/lint.sh" "$repository/tools/requirements-dev.txt"
} | sha256sum | cut -d' ' -f1)
if grep -qsx "$state" "$known"; then
    echo "Lint: no findings. The shipped files have not changed since the last check."
    exit 0
fi

"$python" -m bandit --quiet --recursive .
# E203 contradicts PEP 8 in slices and ruff format; the plugin repository only reports it.
"$python" -m flake8 --isolated --max-line-length=120 --extend-ignore=E203 .
"$python" -m detect_secrets scan --all-files --exclude-files 'metadata\.txt' . >"$unpacked/secrets.json"
"$python" - "$unpacked/secrets.json" <<'PYTHON'
import json
import sys

results = json.load(open(sys.argv[1]))["results"]
for file, findings in results.items():
    for finding in findings:
        print(f"{file}:{finding['line_number']}: detect-secrets sees: {finding['type']}", file=sys.stderr)
sys.exit(bool(results))
PYTHON
echo "$state" >>"$known"
echo "Lint: no findings."
