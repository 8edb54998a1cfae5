"""The files of a run: figures as JSON, histories as CSV, pictures, and deformed shapes as VTU.

Files of a run: figures as JSON, histories as CSV, and pictures.

Deformed shapes over time as VTU files, with a collection that ParaView opens.
"""

from __future__ import annotations

import csv
import json
import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any
from xml.sax.saxutils import quoteattr

import numpy as np

from clubface.errors import InputError
from clubface.fem.heads import MeshedHead, ShellHead, SolidHead
from clubface.fem.result import FIGURES, Impact, turned
from clubface.support.checks import plain
from clubface.support.files import prepared_folder, whole_file, whole_text, write_text


def document(found: Impact) -> dict[str, Any]:
    """Return figures and launch in the order of the table, and the inputs to which they belong, in SI units."""
    figures = {name: getattr(found, name) for name in FIGURES}
    ran = {"elements": found.elements, "stopped": found.stopped or "", "provenance": found.provenance}
    return {**found.outcome(), **found.flown(), **figures, **ran}


def write_run(found: Impact, folder: str | os.PathLike[str], *, animation: bool = False) -> list[Path]:
    """Write figures, histories and pictures of one impact, even of one that stopped early.

    Parameters
    ----------
    found
        The run.
    folder
        Made if it does not exist.
    animation
        Whether to write the moving section, which needs frames.

    Returns
    -------
    list
        The files.
    """
    path = prepared_folder(folder)
    figures = write_text(path / "figures.json", json.dumps(plain(document(found)), indent=2) + "\n")
    tables = [_columns(path / f"{name}.csv", getattr(found, name)) for name in ("contact", "motion", "energy")]
    if not len(found.patch["time"]):
        return [figures, *tables]
    from clubface import plots
    from clubface.fem import pictures, section_picture as sections

    drawn = [plots.save(pictures.impact_figure(found), path / "impact.png")]
    drawn.append(plots.save(pictures.patch_figure(found), path / "patch.png"))
    if len(found.frames) > 1:
        drawn.append(plots.save(sections.section_figure(found), path / "section.png"))
        if animation:
            drawn.append(sections.animate(found, path / "impact.gif"))
    return [figures, *tables, *drawn]


def write_paper(runs: Mapping[str, Impact], folder: str | os.PathLike[str]) -> list[Path]:
    """Write the first run, figures 3 to 7 of Roh and Lee drawn from all, and the contact models beside the first.

    Parameters
    ----------
    runs
        Runs of their case by the method of contact.
    folder
        Made if it does not exist.
    """
    from clubface import plots
    from clubface.fem import pictures

    found = next(iter(runs.values()))
    written = write_run(found, folder)
    if not len(found.patch["time"]):
        return written
    path = prepared_folder(folder)
    drawn = {"paper": pictures.paper_figure(runs), "models": pictures.models_figure(found)}
    return [*written, *(plots.save(figure, path / f"{name}.png") for name, figure in drawn.items())]


def write_sweep(
    rows: Sequence[Mapping[str, Any]], folder: str | os.PathLike[str], *, published: bool = False
) -> list[Path]:
    """Draw a sweep as figure 8 of Roh and Lee, with or without their numbers."""
    from clubface import plots
    from clubface.fem import pictures

    return [plots.save(pictures.sweep_figure(rows, published=published), prepared_folder(folder) / "sweep.png")]


def draw_face(rows: Sequence[Mapping[str, Any]], path: Path) -> Path:
    """Draw what was measured over a face."""
    from clubface import plots
    from clubface.fem.pictures import face_figure

    return plots.save(face_figure(rows), path)


def _columns(path: Path, arrays: Mapping[str, Any]) -> Path:
    """Write arrays over the same records as CSV, a vector as three columns; SI."""
    columns: dict[str, list[float]] = {}
    for name, values in arrays.items():
        if values.ndim == 1:
            columns[name] = values.tolist()
        else:
            for index, axis in enumerate(("normal", "up", "toe")):
                columns[f"{name}_{axis}"] = values[:, index].tolist()
    with whole_text(path) as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(columns)
        writer.writerows(zip(*columns.values(), strict=True))
    return path


PARAVIEW = [0, 1, 2, 3, 5, 4]
"""Places of xx, yy, zz, xy, yz, xz among ours."""


def write_series(found: Impact, folder: str | os.PathLike[str], name: str) -> list[Path]:
    """Write every kept shape as a VTU file, and a collection of them with their times.

    The axes are those of the world (x towards the target, y up, z to the right), with the origin at the clubhead's CG
    at first touch; for a ball thrown at a plane, x is the normal of the plane. Lengths are in m and times in s. Points
    carry ``displacement`` from the shape at first touch. Cells carry ``piece``: 0 for the core, then the other pieces
    of the ball, then the parts of a meshed head; shells are quadrilaterals with their ``thickness`` [m] (0 for
    hexahedra). With fields, cells also carry ``stress`` [Pa] and ``strain`` (components xx, yy, zz, xy, yz, xz),
    ``pressure``, ``von_mises`` [Pa] and ``plastic_strain``. Those of shells belong to the outer side;
    ``von_mises_inner`` belongs to the inner side.

    Parameters
    ----------
    found
        A run with frames.
    folder
        An existing folder.
    name
        Start of the file names: ``<name>-0000.vtu`` and so on, and ``<name>.pvd``.

    Returns
    -------
    list
        The files, the collection last.

    Raises
    ------
    InputError
        The run kept no shapes.
    """
    import meshlane

    if not len(found.frames):
        raise InputError("frames", 0, "1 or more; ask for them in the settings of the run")
    ball = found.ball.mesh
    shapes = found.world_positions()
    cells: list[Any] = [("hexahedron", np.asarray(ball["elements"], dtype=np.int32))]
    of_cells: dict[str, list[Any]] = {
        "piece": [np.asarray(ball["piece"], dtype=np.int32)],
        "thickness": [np.zeros(len(ball["elements"]))],
    }
    if found.head is not None:
        kind, corners, parts, thickness = _cells(found.head)
        cells.append((kind, corners.astype(np.int32) + len(ball["nodes"])))
        of_cells["piece"].append((parts + len(found.ball.pieces)).astype(np.int32))
        of_cells["thickness"].append(thickness)
        shapes = np.concatenate([shapes, found.world_positions(found.head_frames)], axis=1)
    target, stem = Path(folder), file_stem(name)
    written = []
    for number, shape in enumerate(shapes):
        moved: dict[str, Any] = {"displacement": (shape - shapes[0]).astype(np.float32)}
        path = target / f"{stem}-{number:04d}.vtu"
        data = of_cells | _felt(found, number)
        with whole_file(path) as file:
            grid = meshlane.Mesh(shapes[0], cells, point_data=moved, cell_data=data)
            meshlane.write(file.name, grid, file_format="vtu")
        written.append(path)
    return [*written, _collection(target / f"{stem}.pvd", found.frame_times.tolist(), written)]


def _cells(head: MeshedHead) -> tuple[str, Any, Any, Any]:
    """Return kind, nodes, part and thickness [m] of the elements of a head."""
    if isinstance(head, ShellHead):
        return "quad", head.quads, head.part_of_elements(), head.thickness
    assert isinstance(head, SolidHead)
    none = np.zeros(head.elements)
    return "hexahedron", head.hexahedra, none, none


def _felt(found: Impact, frame: int) -> dict[str, list[Any]]:
    """Return stress and strain of all cells in a frame, a list of the bodies' arrays each."""
    data: dict[str, list[Any]] = {}
    for fields in (found.fields, found.head_fields):
        if fields is None:
            continue
        shells = fields.stress.ndim == 4
        outer, inner = ((frame, slice(None), side) if shells else (frame,) for side in (0, 1))
        arrays = {
            "stress": turned(fields.stress[outer], found.attitude)[:, PARAVIEW],
            "strain": turned(fields.strain[outer], found.attitude)[:, PARAVIEW],
            "pressure": fields.pressure[outer],
            "von_mises": fields.von_mises[outer],
            "von_mises_inner": fields.von_mises[inner],
            "plastic_strain": fields.plastic_strain[frame],
        }
        for name, array in arrays.items():
            data.setdefault(name, []).append(array.astype("float32"))
    return data


def file_stem(name: str) -> str:
    """Return ``name`` with what a file name cannot hold replaced by a hyphen."""
    kept = "".join(letter if letter.isalnum() or letter in "-_ ." else "-" for letter in name).strip(" .")
    return kept[:100] or "case"


def _collection(path: Path, times: list[float], files: list[Path]) -> Path:
    entries = "".join(
        f'    <DataSet timestep="{time!r}" part="0" file={quoteattr(file.name)}/>\n'
        for time, file in zip(times, files, strict=True)
    )
    return write_text(
        path,
        '<?xml version="1.0"?>\n<VTKFile type="Collection" version="0.1" byte_order="LittleEndian">\n'
        f"  <Collection>\n{entries}  </Collection>\n</VTKFile>\n",
    )
