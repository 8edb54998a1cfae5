"""Golfers: the distribution of their deliveries, their files, and one's own golfer from measured shots."""
