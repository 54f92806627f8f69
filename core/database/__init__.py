"""Reference databases in memory: built, updated, searched for look-alikes."""
