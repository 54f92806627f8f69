"""What is wrong with installing Python packages."""

SENTENCES = {
    "packages.pip_failed": "pip could not install {package}: {reason}.",
    "packages.socks_proxy": (
        "pip can’t use the SOCKS proxy of QGIS’s network settings; set an HTTP proxy there or none."
    ),
    "packages.proxy": ("The proxy can’t be used; check it under Settings ▸ Options ▸ Network, or install from wheels."),
    "packages.certificate": (
        "The package index’s certificate is not trusted; ask your network’s administrator how pip is set up here, "
        "or install from a folder of wheels."
    ),
    "packages.other_wheel": (
        "The package index gave another file for {package} than the one that SemRef was tested with; nothing was "
        "installed. Use the public index, or install from a folder of wheels that you trust."
    ),
    "packages.disk_full": "The disk is full: {folder} needs about 500 MB.",
    "packages.no_network": (
        "The package index can’t be reached; check the network and Settings ▸ Options ▸ Network, or install from a "
        "folder of wheels."
    ),
    "packages.no_wheel": "{folder} has no wheel of {package} for Python {python} on this system.",
    "packages.not_in_index": "The package index has no {package} for Python {python} on this system.",
    "packages.no_python": ("No Python {version} like QGIS’s was found (looked for {paths}); use “{command}” instead."),
    "packages.no_pip": "{python}, the Python of QGIS, has no pip; {how_to_get_pip}.",
    "packages.older_one": (
        "{path} is an older version than SemRef can use, and QGIS finds it first; update or remove it."
    ),
    "packages.another_first": (
        "QGIS finds {path} first, which SemRef did not install; replace it by {package} where it came from."
    ),
    "packages.unusable": (
        "{package} was installed, but can’t be used with numpy {numpy}: {reason}; it was removed again."
    ),
    "packages.not_installed": "{package} can’t be installed: {reason}: {name}.",
    "packages.needed": (
        "SemRef needs the Python package {packages}. Install it under Settings ▸ Options ▸ SemRef, or by typing "
        "{commands}."
    ),
    "packages.needed_in_window": (
        "SemRef needs the Python package {packages}. Install it under Settings ▸ Options ▸ SemRef."
    ),
    "packages.no_such_python": "{python} is no program; choose the Python that trains, or leave it out.",
    "packages.no_venv": (
        "{python} can’t make an environment ({reason}); on Debian and Ubuntu install python3-venv, elsewhere name "
        "another Python with torch."
    ),
    "packages.no_training_wheels": "The environment for training could not be filled: {reason}.",
    "packages.training_unusable": "torch was installed, but can’t be used: {reason}; it was removed again.",
    "packages.no_training_python": (
        "Training needs a Python of its own with torch: have SemRef make one under Settings ▸ Options ▸ SemRef (about "
        "1.5 GB, more with support for graphics cards), or name one in PYTHON."
    ),
    "packages.not_removed": (
        "{name} can’t be removed, probably because it is in use; restart QGIS and remove it again."
    ),
}
