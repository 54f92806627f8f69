"""Reference databases in memory: build, update, search for similar windows."""
