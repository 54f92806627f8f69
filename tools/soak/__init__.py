"""Long runs that must not grow: memory, descriptors, threads."""
