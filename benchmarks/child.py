"""Run an algorithm in a separate process to measure its peak memory and total time.

    python benchmarks/child.py '{"algorithm": "builddatabase", "parameters": {…}}'

Without an algorithm it only starts and stops QGIS. The last line of the output is
JSON: seconds, processor_seconds, peak_bytes.
"""

from __future__ import annotations

import json
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]


def run_in_child(algorithm: str = "", parameters: dict | None = None) -> dict:
    """Run an algorithm in a child process.

    Returns:
        seconds, processor_seconds and peak_bytes of the algorithm; ``whole``: seconds of the process.

    Raises:
        RuntimeError: When it fails.
    """
    order = json.dumps({"algorithm": algorithm, "parameters": parameters or {}})
    begin = time.perf_counter()
    finished = subprocess.run([sys.executable, __file__, order], capture_output=True, text=True, check=False)
    whole = time.perf_counter() - begin
    if finished.returncode:
        raise RuntimeError(f"semref:{algorithm} failed in a child process:\n{finished.stderr}")
    return {**json.loads(finished.stdout.splitlines()[-1]), "whole": whole}


def peak_bytes() -> int:
    """Return the largest resident memory of this process. getrusage would include the parent's peak on Linux."""
    for line in Path("/proc/self/status").read_text(encoding="ascii", errors="replace").splitlines():
        if line.startswith("VmHWM:"):
            return int(line.split()[1]) * 1024
    raise RuntimeError("Peak memory can be measured on Linux only.")


def main() -> None:
    sys.path[0] = str(ROOT / "tools")
    from qgis_session import qgis_session

    order = json.loads(sys.argv[1])
    with qgis_session():
        import processing

        begin, processor = time.perf_counter(), time.process_time()
        if order["algorithm"]:
            processing.run(f"semref:{order['algorithm']}", order["parameters"])
        seconds, processor = time.perf_counter() - begin, time.process_time() - processor
    print(json.dumps({"seconds": seconds, "processor_seconds": processor, "peak_bytes": peak_bytes()}))


if __name__ == "__main__":
    main()
