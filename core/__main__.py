"""``python -m core``: localize images on a computer without QGIS, from a copy of this folder."""

import os
import sys

from .onboard.command_line import REFUSED, main

if __name__ == "__main__":
    code = main()
    try:
        sys.stdout.flush()
    except OSError:
        # Python would try again at its end, and end with a code of its own.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        code = code or REFUSED
    sys.exit(code)
