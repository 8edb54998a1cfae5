"""From a model to a better club: alternatives side by side, maps of the face, golfers, dispersion and optimisation.

What stands here drives any model of impact, finite elements among them, and the flight after it.
"""
