"""Small parts that several rooms of the interface share."""
