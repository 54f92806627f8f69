"""Train a segmentation network in a separate Python with torch (docs/how-to/train_a_network.md)."""
