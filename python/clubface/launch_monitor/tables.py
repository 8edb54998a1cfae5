"""Tables of recorded shots of any other kind: clubface's own, and those of programs whose columns are named as usual.

Their columns are those of the one vocabulary of quantities, :mod:`clubface.tables.headings`. Nothing is known of
whoever wrote them: every quantity must have a unit, and columns of the same quantity must agree.
"""

from __future__ import annotations

from clubface.launch_monitor.formats import CG, FACE, Field, Format, common_names
from clubface.tables.headings import HAND, shot_words
from clubface.tables.spelling import plain
from clubface.units import DIMENSIONLESS


def _fields() -> dict[str, Field]:
    """Return the columns of all that is measured, and of the properties of club and ball that a delivery may have."""
    names, dimensions = shot_words()
    headings = {name: quantity for name, (quantity, _) in common_names().items()}
    headings |= {plain(name.replace("_", " ")): name for name in names if name == names[name] and name != HAND}
    return {
        quantity: Field(
            *(name for name, each in headings.items() if each == quantity),
            unit="1" if dimensions.get(quantity) == DIMENSIONLESS else None,
        )
        for quantity in dict.fromkeys(headings.values())
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
