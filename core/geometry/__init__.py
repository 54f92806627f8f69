"""Points, poses and grounds: from pixels to the map and back."""
