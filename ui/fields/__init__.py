"""File boxes that offer what is at hand: databases and models, in the dock and in the dialogs of algorithms."""
