"""Flights: many images, one track, a position where no single image has one."""
