"""Export of deformed shapes over time as VTU files, with a collection that ParaView opens."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any
from xml.sax.saxutils import quoteattr

import numpy as np

from clubface.errors import InputError
from clubface.fem.heads import MeshedHead, ShellHead, SolidHead
from clubface.fem.result import Impact, turned
from clubface.support.files import file_stem, whole_file, write_text

__all__ = ["write_series"]

COLLECTION = '<?xml version="1.0"?>\n<VTKFile type="Collection" version="0.1" byte_order="LittleEndian">\n'
PARAVIEW = [0, 1, 2, 3, 5, 4]
"""Indices of xx, yy, zz, xy, yz, xz (the order of ParaView) in our order of components."""


def write_series(impact: Impact, folder: str | os.PathLike[str], name: str) -> list[Path]:
    """Write every recorded shape as a VTU file, and a collection that lists them with their times.

    The axes are world axes (x towards the target, y up, z to the right) with the origin at the clubhead's CG at first
    touch; for a ball thrown at a plane, x is the plane's normal. Lengths are in m, times in s. Points have a
    ``displacement`` relative to the shape at first touch. Cells have ``piece``: 0 for the core of the ball, then its
    other pieces, then the parts of a meshed head. Shells are quadrilaterals with a ``thickness`` [m] (0 for solid
    elements). If the run recorded fields, cells also have ``stress`` [Pa] and ``strain`` (components xx, yy, zz, xy,
    yz, xz), ``pressure``, ``von_mises`` [Pa] and ``plastic_strain``. Shells give the values of their outer side, and
    ``von_mises_inner`` for the inner side.

    The folder must exist. The files are ``<name>-0000.vtu`` and so on, and ``<name>.pvd``; they are returned, the
    collection last. Raises InputError if the run recorded no shapes.
    """
    import meshlane

    if not len(impact.frames):
        raise InputError("frames", 0, "1 or more; set frames in the settings of the run")
    ball = impact.ball.mesh
    shapes = impact.world_positions()
    cells: list[Any] = [("hexahedron", np.asarray(ball["elements"], dtype=np.int32))]
    cell_data: dict[str, list[Any]] = {
        "piece": [np.asarray(ball["piece"], dtype=np.int32)],
        "thickness": [np.zeros(len(ball["elements"]))],
    }
    if impact.head is not None:
        for kind, corners, parts, thickness in _cells(impact.head):
            cells.append((kind, corners.astype(np.int32) + len(ball["nodes"])))
            cell_data["piece"].append((parts + len(impact.ball.pieces)).astype(np.int32))
            cell_data["thickness"].append(thickness)
        shapes = np.concatenate([shapes, impact.world_positions(impact.head_frames)], axis=1)
    target, stem = Path(folder), file_stem(name)
    written = []
    for number, shape in enumerate(shapes):
        moved: dict[str, Any] = {"displacement": (shape - shapes[0]).astype(np.float32)}
        path = target / f"{stem}-{number:04d}.vtu"
        data = cell_data | _cell_stress(impact, number, [len(corners) for _, corners in cells[1:]])
        with whole_file(path) as file:
            grid = meshlane.Mesh(shapes[0], cells, point_data=moved, cell_data=data)
            meshlane.write(file.name, grid, file_format="vtu")
        written.append(path)
    entries = "".join(
        f'    <DataSet timestep="{time!r}" part="0" file={quoteattr(file.name)}/>\n'
        for time, file in zip(impact.frame_times.tolist(), written, strict=True)
    )
    collection = f"  <Collection>\n{entries}  </Collection>\n</VTKFile>\n"
    return [*written, write_text(target / f"{stem}.pvd", f"{COLLECTION}{collection}")]


def _cells(head: MeshedHead) -> list[tuple[str, Any, Any, Any]]:
    """Return type, nodes, part and thickness [m] of the elements of a head, grouped by type."""
    if isinstance(head, ShellHead):
        return [("quad", head.quads, head.part_of_elements(), head.thickness)]
    assert isinstance(head, SolidHead)
    parts = np.split(head.part_of_elements(), [len(head.hexahedra)])
    kinds = (("hexahedron", head.hexahedra, parts[0]), ("tetra10", head.tetrahedra, parts[1]))
    return [(kind, corners, part, np.zeros(len(part))) for kind, corners, part in kinds if len(corners)]


def _cell_stress(impact: Impact, frame: int, cells: list[int]) -> dict[str, list[Any]]:
    """Return stress and strain of all cells in a frame: the ball's, then the head's in blocks of ``cells`` elements."""
    data: dict[str, list[Any]] = {}
    for fields in (impact.fields, impact.head_fields):
        if fields is None:
            continue
        shells = fields.stress.ndim == 4
        outer, inner = ((frame, slice(None), side) if shells else (frame,) for side in (0, 1))
        arrays = {name: turned(getattr(fields, name)[outer], impact.attitude)[:, PARAVIEW]
                  for name in ("stress", "strain")}  # fmt: skip
        arrays |= {"pressure": fields.pressure[outer], "von_mises": fields.von_mises[outer]}
        arrays |= {"von_mises_inner": fields.von_mises[inner], "plastic_strain": fields.plastic_strain[frame]}
        for name, array in arrays.items():
            ends = np.cumsum(cells)[:-1] if fields is impact.head_fields else []
            data.setdefault(name, []).extend(np.split(array.astype("float32"), ends))
    return data
