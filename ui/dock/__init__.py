"""The dock's shell: its window, messages and what it keeps in the project."""
