"""Recorded shots made ready to stand beside models: of one club, with complete deliveries."""
