"""The safety net under refactorings: records what SemRef answers, and compares two recordings."""
