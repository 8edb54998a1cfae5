"""Better clubs from the models: what the rules allow, what a body can be, golfers and their shots, optima.

Everything here drives any model through its derivatives and its batches, so that a new model needs no change here.
"""
