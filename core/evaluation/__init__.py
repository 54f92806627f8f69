"""How well a database localizes, by trials with known truth."""
