"""Missing Python packages: the options page and the installer."""
