"""The tab Inspect: one window of the database, its vector and its look-alikes."""
