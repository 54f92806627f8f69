"""The tab Localize: images in, positions out, and what is known of each."""
