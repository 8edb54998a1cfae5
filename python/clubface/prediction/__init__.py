"""Launches for a whole file of deliveries, of any length."""
