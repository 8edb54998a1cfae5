"""The models that something else than the compiled core of reduced models computes, by the module that does.

Such a module declares its model as ``MODEL`` and what computes it, a :class:`clubface.simulation.backends.Backend`, as
``BACKEND``.
It is imported when its model is named; here are names alone, so that a registration costs nothing.
"""

MODULES: dict[str, str] = {}
"""The module of each further model, by the name of the model."""
