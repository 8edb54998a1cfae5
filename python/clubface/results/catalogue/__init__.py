"""The catalogue: the sentence of every note, by its code.

One file per subject; :mod:`clubface.results.notes` explains the placeholders.
"""

from clubface.results.catalogue import design, impacts, inference, shots

SENTENCES: dict[str, str] = {
    "text": "{text}",
    **design.SENTENCES,
    **impacts.SENTENCES,
    **inference.SENTENCES,
    **shots.SENTENCES,
}
