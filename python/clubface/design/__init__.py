"""From a model to a better club and a better choice: comparisons, golfers and the spread of their shots, optimisation.

Everything here drives the models through the same calls as anyone who imports clubface, so that any model, ball and air
will do.
"""
