"""Label images and maps: classes, where pixels come from, what is counted and compared in them."""
