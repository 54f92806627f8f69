"""Texts in the user's language: sentences, numbers, values of columns, findings."""
