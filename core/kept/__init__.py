"""What takes long to make, kept in files and known by what it was made of."""
