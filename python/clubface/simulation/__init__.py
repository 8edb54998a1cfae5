"""One impact and one flight: deliveries in, launches, histories, derivatives and trajectories out."""
