"""``semref``, or ``python -m core`` beside this folder: localize images on a computer without QGIS."""

import os
import signal
import sys


def run() -> int:
    """Run a command; return its exit code."""
    # Threads of OpenBLAS keep a core busy while they wait, and gain nothing on small matrices. NumPy reads it once.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    is_default = signal.getsignal(signal.SIGINT) == signal.default_int_handler
    if is_default:
        # NumPy and OpenCV, which load for seconds on small computers, turn Ctrl+C into errors of their own.
        signal.signal(signal.SIGINT, signal.SIG_DFL)
    from .onboard.command_line import REFUSED, main

    if is_default:
        signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        code = main()
    except SystemExit as end:
        # argparse ends so after its help.
        code = int(end.code or 0)
    try:
        if sys.stdout is not None:
            sys.stdout.flush()
    except OSError:
        # Otherwise Python tries again at exit and returns its own exit code.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        code = code or REFUSED
    return code


if __name__ == "__main__":
    sys.exit(run())
