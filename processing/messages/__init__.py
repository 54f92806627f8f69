"""What is said in the user's language: sentences, numbers, columns, findings."""
