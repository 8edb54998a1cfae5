"""Checks that a mesh agrees with its head's file: axes, loft, radii and centre of the face.

All other models take loft, bulge and roll from the file, while finite elements use the mesh. If they disagreed, one
name would stand for two different heads.
"""

from __future__ import annotations

import math
import os
from collections.abc import Mapping, Sequence
from itertools import permutations, product
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from clubface import units
from clubface.errors import InputError
from clubface.fem.geometry import area_vectors
from clubface.fem.mesh_files import Mesh

ANGLE = math.radians(1.0)
"""Maximum angle between the face normals of mesh and file [rad]. With 5 mm elements the normal of a curved face is
known to 0.3 degrees, and a degree of loft is 0.8 degrees of launch."""
AT = 0.02
"""Radii may differ by as much as turns the normal by ``ANGLE`` at this distance from the face centre [m]."""
REACHES = (0.008, 0.01, 0.0125, 0.016, 0.02)
"""Radii about the face centre [m] for fitting the face; the first with enough nodes is used. The edges of a face curve
into crown and sole."""
ENOUGH = 9
"""Minimum number of nodes for fitting a quadric, which has six coefficients."""
OFF_CENTRE = 0.25
"""Largest distance between face centre and middle of the face outline, relative to its width or height."""
OFF_FACE = 2e-3
"""Largest distance between face centre and face, beyond the wall thickness [m]."""
WORDS = {"toe": (2, 1), "heel": (2, -1), "hosel": (2, -1), "crown": (1, 1), "sole": (1, -1), "back": (0, -1)}
"""Axis and direction, from the middle of the head, in which parts with these words in their names lie."""
DIRECTIONS = ("x must point to the target", "y must point up", "z must point from heel to toe")


class Face(NamedTuple):
    """Shape of a mesh's face about its centre; curvatures are None if the mesh is too coarse."""

    normal: NDArray[Any]  # outward
    bulge: float | None  # curvature along the face [1/m], positive where it is convex
    roll: float | None  # the same up the face
    height: float  # position of the face in front of the centre, along the normal [m]


def measured_face(nodes: NDArray[Any], quads: NDArray[Any], drawn: NDArray[Any]) -> Face:
    """Return the face about the origin: the normal of its elements there, and a quadric fitted to its nodes.

    ``nodes`` are relative to the face centre [m], ``quads`` are the elements of the face, and ``drawn`` marks the nodes
    from the file: nodes added at the middle of edges and triangles lie behind a curved face and would falsify its
    radii.
    """
    corners = nodes[quads]
    area = area_vectors(nodes, quads)
    away = np.linalg.norm(corners.mean(axis=1), axis=1)
    normal = area[away <= max(REACHES[0], np.sort(away)[: min(4, len(away))].max())].sum(axis=0)
    normal /= max(float(np.linalg.norm(normal)), 1e-300)
    used = np.unique(quads)
    places = nodes[used[drawn[used]]]
    height = float(places[np.argmin(np.linalg.norm(places, axis=1))] @ normal)
    for reach in REACHES:
        fit = Face(normal, None, None, height)
        for _ in range(2):  # repeat with the fitted normal at the centre
            fit = _quadric(places, fit.normal, reach) if fit is not None else None
        if fit is not None:
            return fit
    return Face(normal, None, None, height)


def _quadric(places: NDArray[Any], normal: NDArray[Any], reach: float) -> Face | None:
    """Fit a quadric to the nodes within a radius about the centre; None if there are too few."""
    up = np.array([0.0, 1.0, 0.0]) - normal[1] * normal
    if np.linalg.norm(up) < 1e-3:
        return None
    up /= np.linalg.norm(up)
    toe = np.cross(normal, up)
    h, u, w = places @ normal, places @ up, places @ toe
    near = (np.hypot(u, w) <= reach) & (np.abs(h) <= reach)  # a face group may hold the back of the head too
    h, u, w = h[near], u[near] / reach, w[near] / reach
    quadric = np.stack([np.ones_like(u), u, w, 0.5 * u * u, 0.5 * w * w, u * w], axis=1)
    if len(u) < ENOUGH or np.linalg.matrix_rank(quadric, 1e-3) < 6:
        return None
    fit = np.linalg.lstsq(quadric, h, rcond=None)[0]
    turned = normal - (fit[1] * up + fit[2] * toe) / reach
    return Face(turned / np.linalg.norm(turned), -float(fit[4]) / reach**2, -float(fit[3]) / reach**2, float(fit[0]))


def check_frame(
    mesh: Mesh, nodes: NDArray[Any], quads: NDArray[Any], *, drawn: NDArray[Any], loft: float, bulge: float,
    roll: float, wall: float, centre: str, parts: Mapping[str, NDArray[Any]],
) -> None:  # fmt: skip
    """Raise InputError if loft, bulge, roll, face centre or axes of a mesh differ from those of its head's file.

    ``loft``, ``bulge`` and ``roll`` are those of the file [rad, m], ``centre`` the face centre as written there,
    ``wall`` the wall thickness of the face [m], and ``parts`` the node positions of every group and added mass, by
    name. ``nodes``, ``quads`` and ``drawn`` are as for :func:`measured_face`. The mesh receives notes on oddities.
    """
    face, file = measured_face(nodes, quads, drawn), os.path.basename(mesh.path)
    expected = np.array([math.cos(loft), math.sin(loft), 0.0])
    _check_axes(face.normal, expected, file)
    _check_sides(nodes, parts, file)
    elevation = math.asin(max(-1.0, min(1.0, float(face.normal[1]))))
    if abs(elevation - loft) > ANGLE:
        message = (
            f"the loft of the mesh, to 1 deg: the face of {file} has {_degrees(elevation)} at the face centre;"
            " correct loft or face_centre, or rotate the mesh about z until it is soled as at address"
        )
        raise InputError("loft", _degrees(loft), message)
    turned = math.atan2(float(face.normal[2]), float(face.normal[0]))
    if abs(turned) * math.cos(elevation) > ANGLE:
        side = "toe" if turned > 0.0 else "heel"
        message = (
            f"loft along the target line: the face of {file} points {_degrees(abs(turned))} to the {side} at the face"
            " centre, but must point at the target to 1 deg; rotate the mesh about y, or correct face_centre"
        )
        raise InputError("loft", _degrees(loft), message)
    for name, radius, curvature in (("bulge", bulge, face.bulge), ("roll", roll, face.roll)):
        if curvature is not None and abs(curvature - 1.0 / radius) * AT > ANGLE:
            shape = "flat" if abs(curvature) * AT < ANGLE / 4 else units.fixed(1.0 / curvature, "mm", 0)
            shown = "flat" if math.isinf(radius) else units.show(radius, "mm")
            shape += " (hollow)" if shape != "flat" and curvature < 0.0 else ""
            message = f"that of the mesh: about the face centre the face of {file} has {shape}; correct {name}"
            raise InputError(name, shown, message)
    if not -OFF_FACE - wall <= face.height <= OFF_FACE:
        side = "in front of" if face.height < 0.0 else "behind"
        away = units.fixed(abs(face.height), "mm", 1)
        message = f"a point on the outside of the face; it lies {away} {side} the face of {file}"
        raise InputError("face_centre", centre, message)
    places = nodes[np.unique(quads)]
    for axis, sides in ((2, ("toe", "heel")), (1, ("top", "bottom"))):
        low, high = float(places[:, axis].min()), float(places[:, axis].max())
        off = -0.5 * (low + high)
        if abs(off) > OFF_CENTRE * (high - low):
            away = f"{units.fixed(abs(off), 'mm', 1)} nearer the {sides[off < 0.0]}"
            mesh.notes.append(f"face_centre is {away} than the middle of the face")


def _degrees(angle: float) -> str:
    return f"{round(math.degrees(angle), 1) + 0.0:g} deg"


def _check_axes(normal: NDArray[Any], expected: NDArray[Any], file: str) -> None:
    """Raise InputError if the face would point the right way with axes exchanged or reversed."""

    def apart(direction: NDArray[Any]) -> float:
        return math.acos(max(-1.0, min(1.0, float(direction @ expected))))

    if apart(normal) <= 10.0 * ANGLE:
        return
    choices = []
    for order in permutations(range(3)):
        for signs in product((1.0, -1.0), repeat=3):
            changes = sum(place != each for place, each in enumerate(order)) + sum(sign < 0.0 for sign in signs)
            choices.append((changes, order, signs))
    for changes, order, signs in sorted(choices):
        turned = np.array([sign * normal[axis] for axis, sign in zip(order, signs, strict=True)])
        if changes and apart(turned) <= 2.0 * ANGLE:
            axes = ["".join(("-" if sign < 0 else "", "xyz"[axis])) for axis, sign in zip(order, signs, strict=True)]
            what = _describe_axes(order, signs)
            message = (
                f"x to the target, y up and z to the toe: the face of {file} points along ({_format_vector(normal)}),"
                f" but ({_format_vector(expected)}) is expected; it seems that {what}; write ({', '.join(axes)}) as"
                " x, y, z"
            )
            raise InputError("axes of the mesh", None, message)


def _describe_axes(order: Sequence[int], signs: Sequence[float]) -> str:
    moved = [each for place, each in enumerate(order) if place != each]
    reversed_ = ["xyz"[axis] for axis, sign in zip(order, signs, strict=True) if sign < 0.0]
    words = []
    if len(moved) == 2:
        words.append(f"{' and '.join('xyz'[each] for each in sorted(moved))} are exchanged")
    elif moved:
        words.append("the axes are cyclically exchanged")
    if reversed_:
        words.append(f"{' and '.join(reversed_)} {'points' if len(reversed_) == 1 else 'point'} the opposite way")
    return " and ".join(words)


def _format_vector(direction: NDArray[Any]) -> str:
    return ", ".join(f"{each + 0.0:.2f}" for each in direction)


def _check_sides(nodes: NDArray[Any], parts: Mapping[str, NDArray[Any]], file: str) -> None:
    """Raise InputError if parts lie on the opposite side from their names, as in a left-handed head."""
    middle = 0.5 * (nodes.min(axis=0) + nodes.max(axis=0))
    size = nodes.max(axis=0) - nodes.min(axis=0)
    for name, places in parts.items():
        words = [each for each in WORDS if each in name.casefold().replace("-", " ").replace("_", " ").split()]
        if len(words) != 1:
            continue
        axis, sign = WORDS[words[0]]
        off = float(sign * (places.mean(axis=0) - middle)[axis])
        if off < -0.1 * size[axis]:
            more = (
                '; give a left-handed head as its mirror image, also with z to the toe, and hand = "left"'
                if axis == 2
                else ""
            )
            place = f"{units.fixed(abs(off), 'mm', 1)} on the other side of the middle of {file}"
            raise InputError("axes of the mesh", None, f"{DIRECTIONS[axis]}: {name!r} lies {place}{more}")
