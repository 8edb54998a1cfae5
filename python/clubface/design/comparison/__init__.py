"""Shots side by side, their differences, and what makes them."""
