"""The localizer: one image and a database in, one localization out."""
