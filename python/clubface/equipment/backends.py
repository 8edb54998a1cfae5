"""The models that something else than the compiled core of reduced models computes, by the module that does.

Such a module declares its model as ``MODEL`` and what computes it, a :class:`clubface.simulation.impact.Backend`, as
``BACKEND``.
It is imported when its model is named; here are names alone, so that a registration costs nothing.
"""

from types import SimpleNamespace

MODULES: dict[str, str] = {}
"""The module of each further model, by the name of the model."""

OWN: dict[str, SimpleNamespace] = {}
"""``MODEL`` and ``BACKEND`` of each model that a user registered in this process, by the name of the model."""

CLUB_FILES: dict[str, str] = {}
"""The module that reads club files of another form than that of :class:`clubface.Club`, by a key that only they have.

Its function ``club_of`` makes a club of a document of strict TOML."""
