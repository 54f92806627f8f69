"""What core sees in an image and in a window of a database, for whoever shows it."""
