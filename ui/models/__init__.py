"""The models at hand, with their cards, to choose from."""
