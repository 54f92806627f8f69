"""The tab Correct: going through the places that a check found."""
