"""The dock: a shell that is there from the start, and its content, made when it is opened."""
