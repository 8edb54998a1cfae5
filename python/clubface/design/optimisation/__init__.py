"""Clubs best for golfers within limits, and parts that fit them: one problem, solved with exact derivatives."""
