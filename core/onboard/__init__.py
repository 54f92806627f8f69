"""The onboard file and the command line of an aircraft's computer."""
