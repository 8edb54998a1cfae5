"""Models, clubs and balls as results: lists, and single items with the source of every value."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from clubface.equipment.balls import BALL_DIAMETER_LIMIT, BALL_PROPERTIES, Ball, ball_names
from clubface.equipment.clubs import CATEGORIES, CLUB_NAMES, CLUB_PROPERTIES, TOUR_CLUBS, Club, club
from clubface.equipment.models import DEFAULT_MODEL, Model, Parameter, further_models, model, models
from clubface.equipment.parameters import RANGES, ParameterSet, builtin_sets, in_words
from clubface.quantities import Quantity, Reading
from clubface.results.notes import Note, note
from clubface.results.result import Result
from clubface.results.table import Column, Table, column, table, text
from clubface.schema import Entry
from clubface.support.checks import without_warnings
from clubface.units import SI_UNITS

__all__ = ["club_result", "clubs_result", "model_result", "models_result"]

PAPERS = {
    "Caldwell and McPhee (2023)": "Three-dimensional golf clubhead-ball impact models for drivers and irons",
    "Roh and Lee": "Analysis of golf ball spin mechanism at impact by FEM",
}
"""Titles of papers that the texts of models cite by short names."""


def models_result() -> Result:
    """Return all models with a summary and the laws they obey."""
    every = list(models().values())
    listed = table(
        "models",
        text("model", [each.name for each in every]),
        text("title", [each.title for each in every], printed=False),
        text("kind", [each.kind for each in every]),
        text("summary", [each.summary for each in every], label="what it is"),
        text("laws", [each.laws_in_words for each in every], label="laws it obeys"),
        text("reference", [each.reference for each in every], printed=False),
        title="Impact models",
    )
    notes = [note("default-model", model=DEFAULT_MODEL)]
    notes += [note("further-model", model=each.name, summary=each.summary) for each in further_models().values()]
    return Result("models", "Impact models", (listed,), notes=tuple(notes), hints=(note("model-in-full"),))


def model_result(name: str) -> Result:
    """Return a model with its parameters, published values, sources and caveats."""
    shown = model(name)
    sets = builtin_sets(shown.name)
    parameters = shown.parameters
    functions = _functions(parameters)
    terms = {each for coefficients in functions.values() for each in coefficients}
    declared = table(
        "parameters",
        text("parameter", [each.name for each in parameters]),
        text("unit", ["" if each.unit == "1" else each.unit for each in parameters]),
        text("lower", [each.lower for each in parameters], digits=-4),
        text("upper", [each.upper for each in parameters], digits=-4),
        text("default", [each.default for each in parameters], digits=-6),
        text("meaning", [each.meaning for each in parameters]),
        text("source", [each.source for each in parameters], printed=False),
        title="Parameters",
        shown_rows=[row for row, each in enumerate(parameters) if each not in terms],
    )
    texts = " ".join([shown.reference, *(f"{each.meaning} {each.source}" for each in parameters)])
    notes = [
        note("model-summary", summary=shown.summary),
        note("model-reference", reference=shown.reference),
        *(note("model-paper", short=short, title=title) for short, title in PAPERS.items() if short in texts),
        note("model-laws", laws=shown.laws_in_words),
    ]
    if shown.name in RANGES:
        notes.append(note("model-range", range=in_words(RANGES[shown.name])))
    sources: dict[str, list[str]] = {}
    for each in parameters:
        sources.setdefault(each.source, [])
        if each not in terms:
            sources[each.source].append(each.name)
    for name, coefficients in functions.items():
        sources[coefficients[0].source].append(f"{name}_...")
    notes += [note("parameters-from", parameters=names, source=source) for source, names in sources.items() if source]
    notes += [each for place, one in enumerate(sets, 1) for each in _set_notes(place, one)]
    title = f"{shown.name}: {shown.title} ({shown.kind})"
    tables = [declared] if not sets else [declared, _published_values(shown, sets)]
    if functions:
        features = text("feature", list(FEATURES)), text("meaning", list(FEATURES.values()))
        tables = [_function_table(functions), table("features", *features, title="What they depend on"), *tables]
        notes.insert(1, note("coefficients-are-terms", coefficients=len(terms), functions=len(functions)))
    return Result("model", title, tuple(tables), notes=tuple(notes))


FEATURES = {
    "speed": "normal approach speed over 40 m/s, minus 0.75",
    "friction": "coefficient of friction minus 0.3, times three",
    "slip": "share of friction needed for rolling, from -0.5 (none) to 0.5 (the ball slides throughout)",
    "mobility": "effective mass of ball and head along the normal over the ball's mass, minus 0.8, times 5",
    "ratio": "mobility of the contact along the face over that along the normal, near 0 for clubs",
    "coupling": "how strongly the normal impulse drives the contact along its sliding direction (off centre)",
    "face": "square of the characteristic time over 250 us",
    "bend": "how much faster the normals approach at separation than at first touch, as the face curves and turns",
    "offset": "how strongly the normal impulse drives the contact along the face in any direction",
}
"""Features of the response functions, by their names in the parameters."""
_FIRST = "_middle"
"""Suffix of the constant term of a function."""
_POWERS = {"2": "²", "3": "³"}


def _functions(parameters: Sequence[Parameter]) -> dict[str, list[Parameter]]:
    """Return the coefficients of each response function of a model by name; empty for other models."""
    first = {each.meaning: each.name for each in parameters if each.name.endswith(_FIRST)}
    functions: dict[str, list[Parameter]] = {}
    for each in parameters:
        if each.meaning in first:
            functions.setdefault(first[each.meaning].removesuffix(_FIRST), []).append(each)
    return functions


def _formula(function: str, coefficients: Sequence[Parameter]) -> str:
    """Return a function as a sum of terms, such as "0.823 - 0.0786 speed + 0.0471 speed face"."""
    written = ""
    for each in coefficients:
        features = each.name.removeprefix(f"{function}_").split("_")
        factors = [f"{word[:-1]}{_POWERS[word[-1]]}" if word[-1] in _POWERS else word for word in features]
        term = " ".join([f"{abs(each.default):.3g}", *(word for word in factors if word != _FIRST[1:])])
        sign = "-" if each.default < 0.0 else "+"
        written += f" {sign} {term}" if written else term.rjust(len(term) + (sign == "-"), "-")
    return written


def _function_table(functions: Mapping[str, Sequence[Parameter]]) -> Table:
    meanings = [coefficients[0].meaning for coefficients in functions.values()]
    return table(
        "functions",
        text("function", list(functions)),
        text("meaning", [each.removeprefix("term of ") for each in meanings], label="what it is"),
        text("terms", [len(each) for each in functions.values()], printed=False),
        text("formula", [_formula(name, each) for name, each in functions.items()]),
        title="Functions",
    )


def _published_values(shown: Model, sets: Sequence[ParameterSet]) -> Table:
    cells = [(each.name, place, one) for each in shown.parameters for place, one in enumerate(sets, 1)]
    starred = [f"{one.values[name]:.6g}{'*' * (name in one.value_caveats)}" for name, _, one in cells]
    return table(
        "published_values",
        text("parameter", [name for name, _, _ in cells]),
        text("place", [f"[{place}]" for _, place, _ in cells], in_files=False),
        text("shown", starred, in_files=False),
        text("set", [one.name for _, _, one in cells], printed=False),
        text("club", [one.club for _, _, one in cells], printed=False),
        text("value", [one.values[name] for name, _, one in cells], printed=False),
        text("caveat", [one.value_caveats.get(name) for name, _, one in cells], printed=False),
        title="Published values",
        layout="pivot",
    )


def _set_notes(place: int, one: ParameterSet) -> list[Note]:
    code = "default-set" if one.default else "published-set"
    notes = [note(code, place=place, set=one.name, club=one.club, source=one.source, reference=one.reference)]
    if one.range:
        notes.append(note("set-range", place=place, range=in_words(one.range)))
    notes += [note("set-caveat", place=place, caveat=each) for each in one.caveats]
    return notes + [
        note("value-caveat", place=place, parameter=key, caveat=each) for key, each in one.value_caveats.items()
    ]


def clubs_result() -> Result:
    """Return the built-in clubs by category, and the balls."""
    heads = sorted(map(club, CLUB_NAMES), key=lambda each: (each.name not in TOUR_CLUBS, each.loft))
    heads = [each for category in CATEGORIES for each in heads if each.category == category]
    with without_warnings():
        balls = [Ball.builtin(each) for each in ball_names()]
    listed = table(
        "clubs",
        text("club", [each.name for each in heads]),
        text("category", [each.category for each in heads], label="kind"),
        column("loft", [each.loft for each in heads], label="loft", digits=2),
        column("mass", [each.mass for each in heads], digits=1),
        column("moi", [each.iyy for each in heads], "iyy", label="MOI"),
        column("cg_depth", [each.cg_depth for each in heads], "cg_x", label="CG behind face"),
        column("cg_height", [each.cg_height for each in heads], "cg_y", label="CG above normal"),
        text("hand", ["left" if each.hand < 0 else "right" for each in heads], printed=False),
        text("parameters", [each.parameters for each in heads], printed=False),
        text("description", [each.description for each in heads], label="what it is"),
        title="Clubs",
    )
    weights = table(
        "balls",
        text("ball", [each.name for each in balls]),
        column("mass", [each.mass for each in balls], "ball_mass", label="mass"),
        column("diameter", [2.0 * each.radius for each in balls], "ball_radius", label="diameter"),
        column("inertia", [each.inertia for each in balls], "ball_inertia", label="inertia", digits=2),
        text("description", [each.description for each in balls], label="what it is"),
        title="Balls",
    )
    notes = [note("clubs-listed")]
    if any(2.0 * each.radius < BALL_DIAMETER_LIMIT for each in balls):
        notes.append(note("small-ball"))
    return Result("clubs", "Clubs and balls", (listed, weights), notes=tuple(notes))


def club_result(shown: Club | Ball) -> Result:
    """Return a club or ball with the meaning and source of every value."""
    properties = CLUB_PROPERTIES if isinstance(shown, Club) else BALL_PROPERTIES
    names = [name for name in properties if _is_known(shown, name)]
    by_source: dict[str, int] = {}
    marks = [shown.sources.get(name, "") for name in names]
    marks = [f"[{by_source.setdefault(each, len(by_source) + 1)}]" if each else "" for each in marks]
    quantities = [_quantity_of(name, properties[name]) for name in names]
    listed = table(
        "values",
        text("field", names),
        Column("value", [getattr(shown, name) for name in names], quantities, digits=-6),
        text("mark", marks, label="source", in_files=False),
        text("meaning", [properties[name].meaning for name in names]),
        text("source", [shown.sources.get(name, "") for name in names], printed=False),
    )
    notes: list[Note] = []
    title = f"{shown.name}: {shown.description}"
    if isinstance(shown, Club):
        hand = "" if shown.hand > 0 else ", left-handed"
        title = f"{shown.name}: {shown.description or shown.kind}{hand}; parameters of {shown.parameters}"
        depth = "cg-behind-face" if shown.cg_depth >= 0.0 else "cg-in-front-of-face"
        height = "cg-above-normal" if shown.cg_height >= 0.0 else "cg-below-normal"
        notes = [note(depth, cg_x=abs(shown.cg_depth)), note(height, cg_y=abs(shown.cg_height))]
    notes += [note("source-of-values", place=place, source=source) for source, place in by_source.items()]
    return Result("club", title, (listed,), notes=tuple(notes))


def _is_known(shown: Club | Ball, name: str) -> bool:
    """Return whether a value is given; for a mesh, flexibility of the face may be unknown."""
    if getattr(shown, name) is None:
        return False
    if not isinstance(shown, Club) or name != "characteristic_time" or not hasattr(shown, "head"):
        return True
    return bool(shown.cor or shown.characteristic_time)


def _quantity_of(name: str, field: Entry) -> Quantity:
    """Return a field as a quantity in the unit used in files of clubs and balls."""
    reading = Reading(field.unit, 4)
    return Quantity(name, SI_UNITS[field.dimension], reading, reading, name.replace("_", " "), meaning=field.meaning)
