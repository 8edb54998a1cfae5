"""The catalogue: the sentence of every note, by its code.

One file a subject; :mod:`clubface.results.notes` explains the placeholders.
"""

from clubface.results.catalogue.capture import SENTENCES as _CAPTURE
from clubface.results.catalogue.design import SENTENCES as _DESIGN
from clubface.results.catalogue.equipment import SENTENCES as _EQUIPMENT
from clubface.results.catalogue.fem import SENTENCES as _FEM
from clubface.results.catalogue.inference import SENTENCES as _INFERENCE
from clubface.results.catalogue.player import SENTENCES as _PLAYER
from clubface.results.catalogue.shot import SENTENCES as _SHOT
from clubface.results.catalogue.shots import SENTENCES as _SHOTS
from clubface.results.catalogue.studies import SENTENCES as _STUDIES
from clubface.results.catalogue.validation import SENTENCES as _VALIDATION

SENTENCES: dict[str, str] = {
    "text": "{text}",
    **_CAPTURE,
    **_DESIGN,
    **_EQUIPMENT,
    **_FEM,
    **_INFERENCE,
    **_PLAYER,
    **_SHOT,
    **_STUDIES,
    **_SHOTS,
    **_VALIDATION,
}
