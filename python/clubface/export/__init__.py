"""Clubs, models and deliveries for other programs."""
