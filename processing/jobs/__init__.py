"""What several algorithms do: read photos and annotations, localize, assess, train, and set up an area."""
