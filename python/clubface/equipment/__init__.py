"""Clubs, balls and shafts: their properties and files, and the models with their parameters."""
