"""Options page for Python packages, devices and training, and the installer."""
