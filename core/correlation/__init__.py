"""Map correlation: class areas of an image and of the map (docs/explanation/method.md)."""
