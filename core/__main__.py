"""``python -m core``: localize images on a computer without QGIS, from a copy of this folder."""

import sys

from .onboard.command_line import main

if __name__ == "__main__":
    sys.exit(main())
