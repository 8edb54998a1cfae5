"""Files of parameter sets, one file a source.

A file names its source and holds one or more ``[[set]]``, each with the model and club it was found for, its
values with units, and what must be said of them::

    title = "My range session"
    reference = "42 drives, June"

    [[set]]
    model = "volumetric"
    club = "driver"                       # driver, 7-iron or any
    [set.range]                           # optional: the shots it was found from
    speed = ["101 mph", "118 mph"]
    [set.values]
    stiffness = "6.25e9 N/m3"
    ...
    [set.value_caveats]
    stiffness = "not identifiable from launch data"
"""

from __future__ import annotations

from typing import Any

from clubface.equipment.models import Model, model
from clubface.equipment.ranges import QUANTITIES
from clubface.errors import ClubfaceError
from clubface.support.strict_toml import Document

FILE_KEYS = ("title", "reference", "set")
TEXTS = ("model", "club", "variant", "source")
FLAGS = {"default": False, "includes_face": True}
"""Keys of yes or no, and what is taken where they are left out."""
SET_KEYS = (*TEXTS, *FLAGS, "characteristic_time", "caveats", "range", "values", "value_caveats")


def entries(document: Document) -> list[dict[str, Any]]:
    """Return the tables [[set]] of a document, whose own keys are checked."""
    data = document.data
    document.check_keys(data, FILE_KEYS, ("title", "reference", "set"))
    document.check_text(data, ("title", "reference"))
    found = data["set"]
    if not (isinstance(found, list) and found and all(isinstance(each, dict) for each in found)):
        raise document.error("there must be at least one [[set]]", "set")
    return found


def check_entry(document: Document, entry: dict[str, Any], index: int) -> Model:
    """Check the keys and kinds of one [[set]], its numbers not yet; return its model."""
    document.check_keys(entry, SET_KEYS, ("model", "club", "values"), "set", index)
    document.check_text(entry, TEXTS, "set", index)
    caveats = entry.get("caveats", [])
    if not (isinstance(caveats, list) and all(isinstance(each, str) for each in caveats)):
        raise document.error("caveats must be a list of texts", "caveats", "set", index)
    for key, usual in FLAGS.items():
        if not isinstance(entry.get(key, usual), bool):
            raise document.error(f"{key} must be true or false", key, "set", index)
    values, value_caveats, within = entry["values"], entry.get("value_caveats", {}), entry.get("range", {})
    if not all(isinstance(each, dict) for each in (values, value_caveats, within)):
        raise document.error("values, value_caveats and range must be tables", "values", "set", index)
    try:
        declared = model(entry["model"])
    except ClubfaceError as error:
        raise document.wrap(error, "set", index) from error
    names = [each.name for each in declared.parameters]
    document.check_keys(values, names, names, "set.values", index)
    document.check_keys(value_caveats, names, (), "set.value_caveats", index)
    document.check_text(value_caveats, value_caveats, "set.value_caveats", index)
    document.check_keys(within, QUANTITIES, (), "set.range", index)
    return declared
