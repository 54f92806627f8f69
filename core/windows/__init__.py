"""Windows and topology vectors: the published method (docs/explanation/method.md)."""
