"""Where the shots of a golfer go: by sampling, by derivatives, and what spreads them."""
