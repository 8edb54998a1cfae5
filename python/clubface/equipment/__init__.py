"""Clubs and balls: what they are, how they are read and written, and the models and parameters that fit them."""
