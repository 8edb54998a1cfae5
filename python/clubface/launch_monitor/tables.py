"""Tables of recorded shots of any other kind: clubface's own, and those of programs whose columns are named as usual.

Their layout is made from the one vocabulary of quantities, :mod:`clubface.tables.headings`. Nothing is known of whoever
wrote them: every quantity must have a unit, and columns of the same quantity must agree.
"""

from __future__ import annotations

from clubface.launch_monitor.formats import CG, FACE, Field, Format
from clubface.tables.headings import HAND, shot_words
from clubface.units import DIMENSIONLESS


def _fields() -> dict[str, Field]:
    words = shot_words()
    headings: dict[str, list[str]] = {}
    for heading, quantity in words.names.items():
        headings.setdefault(quantity, []).append(heading)
    return {
        quantity: Field(*each, unit="1" if words.dimensions[quantity] == DIMENSIONLESS else None)
        for quantity, each in headings.items()
        if quantity != HAND
    }


TABLE = Format(
    name="clubface",
    title="table of shots",
    fields=_fields(),
    file=("File",),
    needs_units=True,
    all_columns=True,
    speed_at=CG,
    face_at=FACE,
)
"""Its club data is taken where models want it unless columns ``speed_at`` and ``face_at`` say otherwise."""
