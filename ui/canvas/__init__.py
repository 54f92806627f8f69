"""What SemRef draws on the map canvas, and the tools that pick places on it."""
