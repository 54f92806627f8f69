"""What codes of the core mean, in the user's language."""
