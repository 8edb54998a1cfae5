"""Kinds of studies: their interface, and a module for each."""
