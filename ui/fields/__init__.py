"""Boxes for databases, models, fields and classes, in the dock and in the dialogs of algorithms."""
