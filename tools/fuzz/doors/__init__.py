"""The doors, one file a kind."""
