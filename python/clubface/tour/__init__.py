"""The published averages of the tours, set beside every model."""
