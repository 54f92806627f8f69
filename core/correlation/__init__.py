"""Map correlation: compare class areas of an image and the map (docs/explanation/method.md)."""
