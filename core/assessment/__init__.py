"""Where a database will localize and where it will not, told before the flight."""
