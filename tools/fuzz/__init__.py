"""Every door through which something from outside comes in, tried with inputs that nobody means."""
