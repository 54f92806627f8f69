"""The dock: a shell that exists from the start, and content that is created when the dock opens."""
