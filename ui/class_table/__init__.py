"""Class tables in a window: looked through and edited where an algorithm asks for one."""
