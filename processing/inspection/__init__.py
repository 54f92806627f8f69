"""What the dock shows of an image and of a window of a database."""
