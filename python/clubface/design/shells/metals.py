"""Metals to choose from: one for the whole head, or some for groups of its mesh."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import product

from clubface.errors import InputError
from clubface.fem.heads.metal import Metal
from clubface.support.checks import check_names

MOST_CHOICES = 50
"""Choices of metals that a study may have: each is a search by itself."""


@dataclass(frozen=True, kw_only=True)
class NamedMetal:
    """A metal by name, with where its figures are from.

    Attributes
    ----------
    groups
        The groups of a mesh that may be of it, all of them together; none for all that no other metal names.
    """

    name: str
    metal: Metal
    source: str = ""
    groups: tuple[str, ...] = ()


@dataclass(frozen=True, kw_only=True)
class MetalChoice:
    """What a head is made of: the metal of each group.

    Attributes
    ----------
    name
        What the choice is called in tables.
    metals
        The metal of each group whose metal is chosen; under "" that of all others.
    """

    name: str
    metals: Mapping[str, NamedMetal]

    def of_group(self, group: str) -> NamedMetal | None:
        """Return the metal of a group; None where the head keeps its own."""
        return self.metals.get(group, self.metals.get(""))


def elastic(metal: Metal) -> Metal:
    """Return a metal that does not yield."""
    return replace(metal, yield_stress=None, hardening=None, points=None)


def metal_choices(metals: Sequence[NamedMetal], groups: Sequence[str]) -> tuple[MetalChoice, ...]:
    """Return all ways to make a head of metals; without any, that of its own metals.

    Metals that name the same ``groups`` of a mesh are alternatives for these, and those that name none for all others;
    a head of one metal has no groups. A group that is unknown or has two lists of metals is an ``InputError``.
    """
    if not metals:
        return (MetalChoice(name="that of the head", metals={}),)
    alternatives: dict[tuple[str, ...], list[NamedMetal]] = {}
    for each in metals:
        if each.groups and not groups:
            raise InputError(f"groups of {each.name}", list(each.groups), "left out: this head is of one metal")
        check_names(f"groups of {each.name}", each.groups, groups)
        named = tuple(group for group in groups if group in each.groups)
        for others in alternatives:
            if others != named and (both := set(others) & set(named)):
                first = alternatives[others][0].name
                message = f"either those of {first} or others: {min(both)} would have two lists of metals"
                raise InputError(f"groups of {each.name}", list(each.groups), message)
        alternatives.setdefault(named, []).append(each)
    choices = []
    for chosen in product(*alternatives.values()):
        names, by_group = [], {}
        for named, metal in zip(alternatives, chosen, strict=True):
            names.append(f"{' and '.join(named)} of {metal.name}" if named else metal.name)
            by_group |= dict.fromkeys(named or ("",), metal)
        choices.append(MetalChoice(name=", ".join(names), metals=by_group))
    if len(choices) > MOST_CHOICES:
        raise InputError("metals", f"{len(choices)} choices of one for each list of groups", f"at most {MOST_CHOICES}")
    return tuple(choices)
