"""Meshes of solid elements as mesh generators write them."""

import numpy as np

PATHS = ((0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6), (0, 7, 4, 6), (0, 4, 5, 6), (0, 5, 1, 6))
"""Corners of the six tetrahedra round a diagonal of a hexahedron, whose corners go round the bottom, then the top."""


def tetrahedra_of(hexahedra):
    """Return six tetrahedra for each hexahedron; those of hexahedra in rows fit each other."""
    return np.asarray(hexahedra)[:, PATHS].reshape(-1, 4)


def gmsh_solids(path, nodes, groups, sides=()):
    """Write elements [mm] of physical volumes by name, and some triangles that belong to no group; return the path."""
    kinds = {4: 4, 8: 5, 10: 11, 6: 6, 5: 7}
    names = [f'3 {number} "{name}"' for number, name in enumerate(groups, 1)]
    lines = [f"{number} {x!r} {y!r} {z!r}" for number, (x, y, z) in enumerate(np.asarray(nodes).tolist(), 1)]
    rows = [(2, 99, side) for side in sides]
    rows += [(kinds[len(row)], number, row) for number, own in enumerate(groups.values(), 1) for row in own]
    elements = [
        f"{number} {kind} 2 {group} {group} " + " ".join(str(int(node) + 1) for node in row)
        for number, (kind, group, row) in enumerate(rows, 1)
    ]
    text = [
        "$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", str(len(names)), *names, "$EndPhysicalNames",
        "$Nodes", str(len(lines)), *lines, "$EndNodes", "$Elements", str(len(elements)), *elements, "$EndElements", "",
    ]  # fmt: skip
    path.write_text("\n".join(text))
    return path


def abaqus_solids(path, nodes, groups):
    """Write elements of sets by name: C3D4, C3D10 or C3D8; return the path."""
    lines = ["*HEADING", "*NODE"]
    lines += [f"{number}, {x!r}, {y!r}, {z!r}" for number, (x, y, z) in enumerate(np.asarray(nodes).tolist(), 1)]
    number = 0
    for name, own in groups.items():
        lines.append(f"*ELEMENT, TYPE=C3D{len(own[0])}, ELSET={name}")
        for row in own:
            number += 1
            lines.append(", ".join(str(int(each)) for each in (number, *(node + 1 for node in row))))
    path.write_text("\n".join([*lines, ""]))
    return path


def nastran_solids(path, nodes, groups):
    """Write elements of properties with a metal of steel [MPa, t/mm3]: CTETRA or CHEXA; return the path."""
    lines = ["BEGIN BULK", "MAT1,1,193000.,,0.29,7.8-9"]
    lines += [f"GRID,{number},,{x:.9},{y:.9},{z:.9}" for number, (x, y, z) in enumerate(np.asarray(nodes).tolist(), 1)]
    number = 0
    for place, (name, own) in enumerate(groups.items(), 1):
        lines += [f"$ {name}", f"PSOLID,{place},1"]
        for row in own:
            number += 1
            cells = [str(int(node) + 1) for node in row]
            lines.append(f"{'CTETRA' if len(row) == 4 else 'CHEXA'},{number},{place}," + ",".join(cells[:6]))
            if cells[6:]:
                lines.append("," + ",".join(cells[6:]))
    path.write_text("\n".join([*lines, "ENDDATA", ""]))
    return path


def lsdyna_solids(path, nodes, groups):
    """Write elements of parts by title, tetrahedra as hexahedra that repeat nodes; return the path."""
    lines = ["*KEYWORD", "*NODE"]
    for number, place in enumerate(np.asarray(nodes).tolist(), 1):
        lines.append(f"{number:8d}" + "".join(f"{each:16.8f}" for each in place))
    number = 0
    for part, (name, own) in enumerate(groups.items(), 1):
        lines += ["*PART", name, f"{part:10d}{1:10d}{1:10d}", "*ELEMENT_SOLID"]
        for row in own:
            number += 1
            all_eight = [*row, *[row[-1]] * (8 - len(row))]
            lines.append("".join(f"{int(each):8d}" for each in (number, part, *(node + 1 for node in all_eight))))
    path.write_text("\n".join([*lines, "*END", ""]))
    return path
