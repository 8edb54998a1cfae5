"""Recorded shots, with or without their launches, and their files."""
