"""``python -m core``: localise images on a computer without QGIS, from a copy of this folder."""

import sys

from .command_line import main

if __name__ == "__main__":
    sys.exit(main())
