"""Label images and maps: classes, sources of pixels, counts and comparisons."""
