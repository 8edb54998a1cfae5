"""A mesh of one's own and the file of its head, for the tests of such heads."""

from typing import Any

import numpy as np

from clubface.fem.heads import Group
from fem_runs import coarse_head

HEAD = """\
name = "own head"
kind = "mesh"
file = "head.msh"
unit = "mm"
loft = "11.5 deg"
bulge = "305 mm"
roll = "305 mm"

[[groups]]
name = "face"
thickness = "2.8 mm"
face = true

[[groups]]
name = "crown"
thickness = "1.3 mm"

[[groups]]
name = "sole"
thickness = "1.6 mm"
youngs = "110 GPa"

[[groups]]
name = "skirt"
thickness = "1.4 mm"

[[masses]]
name = "weight"
x = "-40 mm"
y = "-22 mm"
z = "0 mm"
mass = "60 g"
"""

GROUPS = (
    Group(name="face", thickness="2.8 mm", face=True),
    *(Group(name=name, thickness="1.4 mm") for name in ("crown", "sole", "skirt")),
)


def write_mesh(folder, name="head.msh", scale=1e3, change=lambda quads: quads):
    """Write the coarse head of the paper as a mesh with groups, lengths in mm; return its path."""
    import meshio

    head = coarse_head()
    cells: list[Any] = []
    sets: dict[str, list[Any]] = {part.name: [] for part in head.parts}
    start = 0
    for number, part in enumerate(head.parts):
        quads = head.quads[start : start + part.elements].astype(np.int64)
        cells.append(("quad", change(quads) if number == 0 else quads))
        start += part.elements
        for each in head.parts:
            sets[each.name].append(np.arange(part.elements) if each is part else np.array([], dtype=np.int64))
    # A point that no element uses.
    points = np.vstack([head.nodes * scale, [[0.0, 0.0, 0.0]]])
    tags = [np.full(len(quads), number + 1) for number, (_, quads) in enumerate(cells)]
    fields = {part.name: np.array([number + 1, 2]) for number, part in enumerate(head.parts)}
    data: dict[str, Any] = {"gmsh:physical": tags, "gmsh:geometrical": tags}
    path = folder / name
    if path.suffix == ".msh":
        meshio.write(path, meshio.Mesh(points, cells, cell_data=data, field_data=fields), "gmsh22", binary=False)
    else:
        meshio.write(path, meshio.Mesh(points, cells, cell_sets=sets))
    return path
