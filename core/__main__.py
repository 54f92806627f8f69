"""``semref``, or ``python -m core`` beside this folder: localize images on a computer without QGIS."""

import os
import sys


def run() -> int:
    """Run a command; return its exit code."""
    # Threads of OpenBLAS keep a core busy while they wait, and gain nothing on small matrices. NumPy reads it once.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    from .onboard.command_line import REFUSED, main

    code = main()
    try:
        sys.stdout.flush()
    except OSError:
        # Otherwise Python tries again at exit and returns its own exit code.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        code = code or REFUSED
    return code


if __name__ == "__main__":
    sys.exit(run())
