"""What the tests of cluster/ share."""

SETTINGS = ["--window-size", "320", "--stride", "140", "--minimum-area", "40"]
