"""The reports of ``clubface fem head`` and ``clubface fem run``: what a head bears, and what an impact came to."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from clubface.cli import reporting
from clubface.support.input_files import read_input
from clubface.support.shipped import builtin_names, builtin_path, path_of
from clubface.units import fixed, from_si

if TYPE_CHECKING:
    from clubface.fem.case import Case
    from clubface.fem.heads import MeshedHead
    from clubface.fem.result import Impact
    from clubface.fem.stress import BlowStress

CONTACT = {"time": "us", "normal": "N", "tangential": "N", "toe": "N", "area": "mm2"}
"""What is saved of the contact, with units."""


def write_head(
    target: str,
    of: MeshedHead,
    file: str,
    told: Mapping[str, Any],
    struck: BlowStress | None,
    given: Mapping[str, str],
    show: Callable[[], None],
) -> None:
    """Write the report of a head from ``file``; ``told`` has what was measured, ``given`` how it was struck."""
    picture, columns = None, {}
    if struck is not None:
        from clubface.fem.figures.stress import stress_figure

        parts = struck.parts
        when = fixed(struck.surface.time, "us", 0)
        picture = (
            f"The stress of the surface {when} after first touch, a cross where it is largest; and the largest stress "
            "of every part beside where its metal yields",
            stress_figure(struck, of.loft),
        )
        columns = {
            "part": [part.part for part in parts],
            "largest stress (MPa)": [from_si(part.stress, "MPa") for part in parts],
            "yields at (MPa)": [None if (at := part.yield_stress) is None else from_si(at, "MPa") for part in parts],
            "after (us)": [from_si(part.time, "us") for part in parts],
            **{f"{axis} (mm)": [from_si(part.place[place], "mm") for part in parts]
               for place, axis in enumerate(("to the target", "above the face centre", "to the toe"))},
            **{f"by {elements} elements (MPa)": [from_si(part.by_mesh[k][1], "MPa") for part in parts]
               for k, (elements, _) in enumerate(parts[0].by_mesh)},
        }  # fmt: skip
    path = Path(path_of("head", file, "fem_heads"))
    reporting.write(
        target, title=f"The head {of.name}: {'mass and mesh' if struck is None else 'what it bears'}",
        words=_head_words(of, told, struck, given), picture=picture, columns=columns, show=show, launches=(),
        given={"head": of.name, "elements": str(of.elements), **given}, files=_texts(path),
    )  # fmt: skip


def _texts(path: Path) -> dict[str, str]:
    """Return the text of a description by the name of its file; one that is not shipped is in every report."""
    return {path.name: read_input(path).decode("utf-8-sig", errors="replace")}


def _head_words(
    of: MeshedHead, told: Mapping[str, Any], struck: BlowStress | None, given: Mapping[str, str]
) -> Iterator[str]:
    """Say what a head is, and whether it holds, in sentences."""
    allowed = "; the rules of golf allow a driver 5900 g cm2" * (of.club.kind == "wood")
    yield (
        f"The head weighs {fixed(of.club.mass, 'g', 1)}. Against twisting about the vertical it has a moment of inertia"
        f" of {fixed(of.club.iyy, 'g cm2', 0)}{allowed}."
    )
    if "restitution" in told:
        yield (
            f"Its face gives back {100.0 * told['restitution']:.1f} % of the speed at which a ball meets it. The"
            f" pendulum of the rules touches it for {fixed(told['characteristic_time_s'], 'us', 0)}; the rules allow"
            " a driver 239 us, and 257 us with the tolerance."
        )
    parts = () if struck is None else struck.parts
    known = [(part.margin, part.yield_stress, part) for part in parts if part.margin is not None and part.yield_stress]
    for margin, yields, part in known:
        if margin < 0.0:
            yield (
                f"Struck at {given['blow']}, the {part.part} is too weak: the stress there reaches"
                f" {fixed(part.stress, 'MPa', 0)}, and its metal yields at {fixed(yields, 'MPa', 0)}."
            )
    if known and all(margin >= 0.0 for margin, _, _ in known):
        least, _, part = min(known, key=lambda each: each[0])
        yield (
            f"Struck at {given['blow']}, no part yields. Closest to it is the {part.part}, which could bear"
            f" {100.0 * least:.0f} % more stress."
        )
    if len(known) < len(parts):
        others = ", ".join(part.part for part in parts if part.margin is None)
        yield f"At which stress the metal yields is not told for: {others}."
    if struck is not None:
        peak = max(parts, key=lambda part: part.stress)
        ahead, high, toe = (from_si(place, "mm") for place in peak.place)
        yield (
            f"The largest stress, {fixed(peak.stress, 'MPa', 0)}, is that of the {peak.part},"
            f" {reporting.more_or_less(high, 'mm', ('above', 'below'))} the face centre,"
            f" {reporting.more_or_less(toe, 'mm', ('to the toe', 'to the heel'))} and"
            f" {reporting.more_or_less(ahead, 'mm', ('in front of it', 'behind it'))}."
        )
        if peak.spread is not None:
            counts = " and ".join(f"{elements}" for elements, _ in peak.by_mesh[1:])
            yield f"Meshes of {counts} elements change it by {100.0 * peak.spread:.0f} % at most."
        yield from struck.notes()
        yield "Notches, welds and fatigue over many blows are not counted: a real head needs more than this."


def write_run(target: str, found: Impact, case: Case, file: str, show: Callable[[], None]) -> None:
    """Write the report of one impact, the run of a case from ``file``."""
    from clubface.fem.case import FOLDER
    from clubface.fem.figures.impact import impact_figure

    picture = None
    if len(found.patch["time"]):
        picture = ("Force, spin, radius of the ball and energies while ball and face touch", impact_figure(found))
    path = Path(path_of("case", file, FOLDER))
    columns = {f"{name} ({unit})": from_si(found.contact[name], unit) for name, unit in CONTACT.items()}
    settings = {
        name.replace("_", " "): f"{fixed(value, 'us', 0)}" if name in ("duration", "interval") else str(value)
        for name, value in case.settings.values().items()
        if value is not None
    }
    files = _texts(path)
    if case.ball.name in builtin_names("balls"):
        (text,) = _texts(builtin_path("ball", case.ball.name, "balls")).values()
        files[f"ball {case.ball.name}.toml"] = text
    reporting.write(
        target, title=f"An impact by finite elements: {case.description or case.name}", words=_run_words(found, case),
        picture=picture, columns=columns,
        show=show, launches=() if found.launch is None else [found.launch],
        given={"case": case.name, "ball": case.ball.name, "head": case.club.name if case.club else "a plane",
               "friction": f"{found.friction:g}", "elements": str(found.elements), **settings},
        conditions={} if found.flown() else None, files=files,
    )  # fmt: skip


def _run_words(found: Impact, case: Case) -> Iterator[str]:
    """Say what came of an impact, in sentences."""
    if found.stopped:
        yield f"There is no launch: {found.stopped}."
        return
    out = found.outcome()
    what = case.club.name if case.club else "a rigid plane"
    if "ball_speed" in out:
        aside = from_si(out["azimuth"], "deg")
        sides = ("to the right", "to the left")
        way = "straight" if abs(aside) < 0.05 else reporting.more_or_less(aside, "degrees", sides)
        yield (
            f"The ball {case.ball.name} leaves {what} at {fixed(out['ball_speed'], 'mph', 1)},"
            f" {from_si(out['launch'], 'deg'):.1f} degrees upwards and {way}, and spins backwards with"
            f" {fixed(out['backspin'], 'rpm', 0)}."
        )
    else:
        yield f"The ball {case.ball.name} leaves {what} and spins with {fixed(out['backspin'], 'rpm', 0)}."
    yield (
        f"They touch for {fixed(found.contact_time, 'us', 0)}, and push each other with up to "
        f"{fixed(found.peak_force, 'kN', 1)}."
    )
    if flown := found.flown():
        yield f"In still air the ball would carry {fixed(flown['carry'], 'yd', 0)}."
    yield f"Energies close to {100.0 * found.energy_error:.2f} %, which is how far the computation can be trusted."
