"""The algorithms, one a file, and nothing else."""
