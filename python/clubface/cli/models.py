"""``clubface models``: the models, or one with its parameters, published values, sources and caveats."""

from __future__ import annotations

from typing import Annotated, Any

import typer

from clubface.cli import options, output
from clubface.cli.output import print_numbers, print_words
from clubface.equipment.models import DEFAULT_MODEL, further_models, model, models as registry
from clubface.equipment.parameters import RANGES, in_words

app = typer.Typer(add_completion=False)

PAPERS = {
    "Caldwell and McPhee (2023)": "Three-dimensional golf clubhead-ball impact models for drivers and irons",
    "Roh and Lee": "Analysis of golf ball spin mechanism at impact by FEM",
}


@app.command()
def models(
    name: Annotated[
        str | None, typer.Argument(metavar="[NAME]", help="Show this model in full.", show_default=False)
    ] = None,
    as_json: options.Json = False,
) -> None:
    """List the impact models, or show one with its parameters and their published values."""
    if name is not None:
        found = model(name)
        if as_json:
            output.print_json(describe(found))
        else:
            _print_model(found)
        return
    if as_json:
        output.print_json([describe(each) for each in registry().values()])
        return
    rows = [[each.name, each.kind, each.summary, each.laws_in_words] for each in registry().values()]
    rows[list(registry()).index(DEFAULT_MODEL)][2] += " The model where none is named."
    print_words(["model", "kind", "what it is", "laws it obeys"], rows)
    output.print_notes(f'{each.name}: {each.summary} "all" does not mean it.' for each in further_models().values())
    output.print_notes(["clubface models NAME lists parameters, units, bounds, published values, sources and caveats."])


def describe(found: Any) -> dict[str, Any]:
    """Return a model as a document; values in SI."""
    from clubface.equipment.parameters import builtin_sets

    return {
        "name": found.name,
        "title": found.title,
        "kind": found.kind,
        "summary": found.summary,
        "reference": found.reference,
        "papers": _papers(found),
        "laws": found.laws,
        "laws_without": dict([found.laws_without]) if found.laws_without else {},
        "parameters": [
            {
                "name": each.name,
                "unit": each.unit,
                "meaning": each.meaning,
                "default": each.default,
                "lower": each.lower,
                "upper": each.upper,
                "source": each.source,
            }
            for each in found.parameters
        ],
        "sets": [
            {
                "name": each.name,
                "club": each.club,
                "default": each.default,
                "values": each.values,
                "source": each.source,
                "reference": each.reference,
                "range": each.range,
                "caveats": each.caveats,
                "value_caveats": each.value_caveats,
            }
            for each in builtin_sets(found.name)
        ],
    }


def _print_model(found: Any) -> None:
    from clubface.equipment.parameters import builtin_sets

    print(f"{found.name}: {found.title} ({found.kind})")
    output.print_paragraph(found.summary)
    output.print_paragraph(f"Reference: {found.reference}")
    for short, title in _papers(found).items():
        output.print_paragraph(f"{short}: {title}")
    output.print_paragraph(f"Laws it obeys: {found.laws_in_words}")
    if found.name in RANGES:
        output.print_paragraph(f"Range it is made for: {in_words(RANGES[found.name])}")
    print()
    rows = [
        [each.name, _unit(each.unit), f"{each.lower:.4g} to {each.upper:.4g}", each.meaning]
        for each in found.parameters
    ]
    print_words(["parameter", "unit", "allowed", "meaning"], rows)
    sources: dict[str, list[str]] = {}
    for each in found.parameters:
        sources.setdefault(each.source, []).append(each.name)
    output.print_notes(f"{', '.join(names)}: {source}" for source, names in sources.items() if source)
    sets = builtin_sets(found.name)
    if not sets:
        return
    print()
    heads = ["published values", *(f"[{index}]" for index in range(1, len(sets) + 1))]
    values = [
        [each.name, *(f"{one.values[each.name]:.6g}" + ("*" if each.name in one.value_caveats else "") for one in sets)]
        for each in found.parameters
    ]
    print_numbers(heads, values)
    for index, one in enumerate(sets, 1):
        standing = ", used by default" if one.default else ""
        output.print_paragraph(f"[{index}] {one.name}, for {one.club}{standing}: {one.source}. {one.reference}")
        within = [f"from shots with {in_words(one.range)}"] if one.range else []
        output.print_notes([*within, *one.caveats, *(f"{key}: {text}" for key, text in one.value_caveats.items())])


def _papers(found: Any) -> dict[str, str]:
    """Return the papers that the model's texts call by a short name."""
    texts = " ".join([found.reference, *(f"{each.meaning} {each.source}" for each in found.parameters)])
    return {short: title for short, title in PAPERS.items() if short in texts}


def _unit(unit: str) -> str:
    return "" if unit == "1" else unit
