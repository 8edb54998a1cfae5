"""Tables of the study of the benchmark shots, made from its results when the pages are built."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from benchmark_findings import bias_of, bias_of_magnitudes
from core_tables import CoreTable, markdown_table
from findings_results import TITLES, UNITS, duration, heads, percent, plain_number, results, shown
from sphinx.application import Sphinx

from clubface import units
from clubface.equipment.models import model as model_named
from clubface.equipment.parameters import ParameterSet
from clubface.inference.evaluation import published
from clubface.quantities import display_unit
from clubface.shots.measured import QUANTITIES

SOURCES = {
    "all": "everything, as measured",
    "model": "the model alone",
    "capture": "motion capture alone",
    "extrapolation": "of that, straight lines through noise-free frames",
    "monitor": "the launch monitor alone",
}
LARGE = {"N/m3": ("G", 1e9)}
"""Units whose values are written with a prefix, and the prefix's factor."""
EFFECTS = {
    "ball": "restitution scatters from ball to ball",
    "face": "restitution falls off the centre",
    "shaft": "the tip of the shaft moves with the head",
    "all": "all three",
}


class Errors(CoreTable):
    """``{findings-errors} driver``: errors of the identified models with intervals, next to the published ones."""

    required_arguments = 1

    def table(self) -> list[str]:
        """One row a model, and the published one below it."""
        club = self.arguments[0]
        result = results()["clubs"][club]["errors"]
        rows = [["*mean magnitude*", *(f"*{shown(result['mean'][name], name)}*" for name in QUANTITIES)]]
        for model in results()["models"]:
            sizes = {name: result["sizes"][name][model] for name in QUANTITIES}
            cells = [
                f"{shown(each['mae'], name)} ({percent(each['mae'], result['mean'][name])})"
                f" [{', '.join(shown(end, name) for end in each['mae_interval'])}]"
                for name, each in sizes.items()
            ]
            rows.append([f"`{model}`", *cells])
            given = published().get((model, club))
            if given:
                cells = [
                    f"*{shown(given.mae[name], name)} ({percent(given.mae[name], given.mean[name])})*"
                    for name in QUANTITIES
                ]
                rows.append(["*published*", *cells])
        floor = [shown(result["floor"].get(name), name) for name in QUANTITIES]
        return markdown_table(heads(f"{club}, MAE"), [*rows, ["noise of the monitor", *floor]])


class Spreads(CoreTable):
    """``{findings-spreads} driver``: bias and standard deviation of the errors of the identified models."""

    required_arguments = 1

    def table(self) -> list[str]:
        """One row a model, and the published one below it."""
        club = self.arguments[0]
        result, rows = results()["clubs"][club]["errors"]["sizes"], []
        for model in results()["models"]:
            cells = [
                f"{shown(result[name][model]['bias'], name, '+')} ± {shown(result[name][model]['std'], name)}"
                for name in QUANTITIES
            ]
            rows.append([f"`{model}`", *cells])
            given = published().get((model, club))
            if given and given.std:
                rows.append(["*published*", *(f"*± {shown(given.std[name], name)}*" for name in QUANTITIES)])
        return markdown_table(heads(f"{club}, bias ± STD"), rows)


class Effects(CoreTable):
    """``{benchmark-effects}``: how large what no fitted model has is in the benchmark launches."""

    def table(self) -> list[str]:
        """One row a club and effect."""
        rows = [
            [f"{club}: {words}", *(shown(result["effects"][effect][name], name) for name in QUANTITIES)]
            for club, result in results()["clubs"].items()
            for effect, words in EFFECTS.items()
        ]
        return markdown_table(heads("mean change of the launch"), rows)


class Best(CoreTable):
    """``{findings-best}``: the best model of each quantity and club, and those not significantly worse."""

    def table(self) -> list[str]:
        """One row a quantity."""
        rows = []
        for name in QUANTITIES:
            row = [TITLES[name].lower()]
            for result in results()["clubs"].values():
                best = result["errors"]["best"][name]
                equal = [f"`{each['model']}`" for each in best["rivals"] if each["p"] >= 0.05]
                row += [f"`{best['model']}`", ", ".join(equal) or "none"]
            rows.append(row)
        clubs = list(results()["clubs"])
        columns = [text for club in clubs for text in (f"{club}: best", "not significantly worse")]
        return markdown_table(["", *columns], rows)


class Costs(CoreTable):
    """``{findings-costs}``: the cost on the shots of the fit and on shots held out, next to the published one."""

    def table(self) -> list[str]:
        """One row a model."""
        rows = []
        for model in results()["models"]:
            row: list[object] = [f"`{model}`", len(next(iter(results()["clubs"].values()))["fits"][model]["free"])]
            for club, result in results()["clubs"].items():
                fit = result["fits"][model]
                given = published().get((model, club))
                # Two of the ten are printed; this is what the printed errors and means add up to.
                cost = sum(given.mae[name] / given.mean[name] for name in QUANTITIES) if given else None
                row += [f"{fit['cost']:.4f}", f"{fit['cost_holdout']:.4f}", "" if cost is None else f"*{cost:.2f}*"]
            rows.append(row)
        columns = [text for club in results()["clubs"] for text in (f"{club}: cost", "held out", "*published*")]
        return markdown_table(["", "free", *columns], rows)


class Leads(CoreTable):
    """``{findings-leads}``: by how much each model's held-out cost exceeds the least."""

    def table(self) -> list[str]:
        """One row a model."""
        rows = []
        for model in results()["models"]:
            row = [f"`{model}`"]
            for result in results()["clubs"].values():
                each = result["held_out"][model]
                low, high = each["interval"]
                best = each["than"] == model
                row.append("least" if best else f"{each['more']:+.4f} [{low:+.4f}, {high:+.4f}]")
            rows.append(row)
        return markdown_table(["", *results()["clubs"]], rows)


class Parameters(CoreTable):
    """``{findings-parameters} volumetric``: identified parameters, intervals, whether the shots determine them.

    For models that made shots, it also gives the true values and those identified on their own shots.
    """

    required_arguments = 1

    def table(self) -> list[str]:
        """One row a club and parameter."""
        model = self.arguments[0]
        rows, has_own = [], False
        for club, result in results()["clubs"].items():
            fit, own = result["fits"][model], result["own"].get(model)
            printed = ParameterSet.builtin(model, club).values
            has_own = own is not None
            for name in fit["free"]:
                unit = display_unit(name, model_named(model).parameter(name).unit)
                prefix, scale = LARGE.get(unit, ("", 1.0))

                def write(value: float, unit: str = unit, scale: float = scale) -> str:
                    return plain_number(float(units.from_si(value, unit)) / scale)

                def with_ends(fit: dict[str, Any], name: str = name, write: Callable[[float], str] = write) -> str:
                    return (
                        f"{write(fit['parameters'][name])} [{', '.join(write(end) for end in fit['intervals'][name])}]"
                    )

                row = [f"{club}: `{name}`" + ("" if unit == "1" else f", {prefix}{unit}")]
                row += [write(own["true"][name]), with_ends(own)] if own else [write(float(printed[name]))]
                rows.append([*row, with_ends(fit), fit["identified"][name]])
        first = ["true", "from its own shots [95%]"] if has_own else ["published"]
        return markdown_table([f"`{model}`", *first, "from all shots [95%]", "determined?"], rows)


class Budget(CoreTable):
    """``{findings-budget} driver slip``: where the errors of a model come from."""

    required_arguments = 2

    def table(self) -> list[str]:
        """One row a source."""
        club, model = self.arguments
        result = results()["clubs"][club]["budget"][model]
        rows = [[SOURCES[source], *(shown(each[name], name) for name in QUANTITIES)] for source, each in result.items()]
        given = published().get((model, club))
        if given:
            rows.append(["*published, everything*", *(f"*{shown(given.mae[name], name)}*" for name in QUANTITIES)])
        return markdown_table(heads(f"{club}, `{model}`: MAE"), rows)


class ImpliedBias(CoreTable):
    """``{implied-bias} azimuth sidespin``: the bias that the published MAE and STD imply, for both readings of STD."""

    required_arguments = 1
    final_argument_whitespace = True

    def table(self) -> list[str]:
        """One row a club and model."""
        names = self.arguments[0].split()
        rows = []
        for (model, club), given in published().items():
            if not given.std:
                continue
            row = [f"{club}, `{model}`"]
            for name in names:
                pair = (given.mae[name], given.std[name])
                ends = sorted((shown(bias_of(*pair), name), shown(bias_of_magnitudes(*pair), name)), key=float)
                row += [shown(given.mae[name], name), " to ".join(dict.fromkeys(ends))]
            rows.append(row)
        columns = [text for name in names for text in (f"{TITLES[name].lower()}: MAE, {UNITS[name]}", "implied bias")]
        return markdown_table(["", *columns], rows)


class Effort(CoreTable):
    """``{findings-effort}``: how much was computed for each identification."""

    def table(self) -> list[str]:
        """One row a model."""
        rows = []
        for model in results()["models"]:
            row = [f"`{model}`"]
            for result in results()["clubs"].values():
                fit = result["fits"][model]
                row += [str(fit["shots"]), f"{fit['impacts'] / 1e6:.1f}"]
            rows.append(row)
        columns = [text for club in results()["clubs"] for text in (f"{club}: shots", "million impacts")]
        return markdown_table(["", *columns], rows)


class Times(CoreTable):
    """``{findings-times}``: the time of a shot, next to the published one."""

    def table(self) -> list[str]:
        """One row a model."""
        rows = []
        for model in results()["models"]:
            row = [f"`{model}`"]
            for club, result in results()["clubs"].items():
                given = published().get((model, club))
                # Printed times are those of ten shots.
                printed = f"*{duration(given.cpu / 10)}*" if given and given.cpu else ""
                row += [duration(result["errors"]["seconds"][model]), printed]
            rows.append(row)
        columns = [text for club in results()["clubs"] for text in (f"{club}: time a shot", "*published*")]
        return markdown_table(["", *columns], rows)


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the directives."""
    directives: Sequence[tuple[str, type[CoreTable]]] = (
        ("findings-errors", Errors), ("findings-spreads", Spreads), ("findings-best", Best),
        ("findings-costs", Costs), ("findings-leads", Leads), ("findings-parameters", Parameters),
        ("findings-budget", Budget), ("findings-effort", Effort), ("implied-bias", ImpliedBias),
        ("findings-times", Times), ("benchmark-effects", Effects),
    )  # fmt: skip
    for name, each in directives:
        app.add_directive(name, each)
    return {"parallel_read_safe": True}
