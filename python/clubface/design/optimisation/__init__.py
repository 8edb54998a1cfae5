"""Optimised clubs and fittings for golfers: one constrained problem, solved with exact derivatives."""
