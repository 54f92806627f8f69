"""Injects faults into everything that SemRef writes; see ``__main__``."""
