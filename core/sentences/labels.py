"""What is wrong with a class table, a label map or an image."""

SENTENCES = {
    "labels.no_pixels": "The image has no pixels.",
}
