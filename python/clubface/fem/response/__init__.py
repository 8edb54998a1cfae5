"""Response functions of a ball: strikes by finite elements, and the coefficients of `response` fitted to them.

``python -m clubface.fem.response BALL FOLDER`` repeats it for a built-in ball or for a file of one.
"""
