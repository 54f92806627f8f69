"""Tab *Inspect*: one window of the database, its vector and similar windows."""
