"""Windows and topology vectors: the published method (docs/method.md)."""
