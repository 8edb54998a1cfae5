"""Repair of shell meshes from files for the core: close seams, orient normals outward, split triangles.

Every step works on arrays and notes its changes; messages use the file's element numbers.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from clubface.fem.geometry import area_vectors
from clubface.fem.mesh_files import Mesh

MERGED = 1e-4
"""Tolerance for coincident nodes, relative to the size of the head: 0.01 mm for a driver. Files with five digits leave
gaps of 0.001 mm at seams, and no element of a head is smaller than the tolerance."""
LEAST_ANGLE = 0.05
"""Smallest corner angle of a quadrilateral that is left uncut, measured as the area of the corner's triangle over the
parallelogram of the diagonals, which is 0.5 for a square. The core accepts 0.02 and more."""
SAMPLE = 500
"""Maximum number of nodes of a piece whose distances to other pieces are computed."""
WINDOW = 200
"""Maximum number of neighbours along a line that are compared with a node."""
DIRECTION = (0.4815, 0.6297, 0.6098)
"""Direction of that line: no edge of a head is perpendicular to it."""


@dataclass
class Shells:
    """Shell elements under repair."""

    mesh: Mesh
    points: NDArray[Any]  # positions of nodes, shape (n, 3)
    node_ids: NDArray[Any]  # node numbers in the file; 0 for an added node
    corners: NDArray[Any]  # nodes of elements, shape (m, 4); the last node of a triangle is -1
    ids: NDArray[Any]  # element numbers in the file
    group: NDArray[Any]  # group index of each element
    thickness: NDArray[Any]  # of each element

    def keep(self, chosen: NDArray[Any]) -> None:
        """Keep only the chosen elements."""
        self.corners, self.ids = self.corners[chosen], self.ids[chosen]
        self.group, self.thickness = self.group[chosen], self.thickness[chosen]


def repaired(mesh: Mesh, group: NDArray[Any], face: NDArray[Any]) -> Shells:
    """Return the shells of a mesh as connected, convex quadrilaterals with outward normals, as far as possible.

    ``group`` is the index of each element's group, and ``face`` says which groups belong to the face. Changes are
    noted. Raises FileError if an element repeats a node, has no area, or shares an edge with two others.
    """
    shells = Shells(mesh, mesh.points, mesh.node_ids, mesh.corners.copy(), mesh.ids, group, mesh.thickness)
    _take_triangles(shells)
    _merge_nodes(shells)
    _drop_unused(shells)
    _check_doubles(shells)
    _cut_bad_quadrilaterals(shells)
    _turn_outward(shells, face)
    _split_triangles(shells)
    return shells


def _take_triangles(shells: Shells) -> None:
    """Treat quadrilaterals whose last two nodes coincide as triangles; reject other repeated nodes."""
    corners = shells.corners
    corners[corners[:, 2] == corners[:, 3], 3] = -1
    ordered = np.sort(corners, axis=1)
    doubled = (ordered[:, 1:] == ordered[:, :-1]).any(axis=1)
    if doubled.any():
        row = int(np.argmax(doubled))
        nodes = [int(shells.node_ids[each]) for each in corners[row] if each >= 0]
        raise shells.mesh.error(f"element {shells.ids[row]} is inverted or degenerate: it lists a node twice, {nodes}")


def _merge_nodes(shells: Shells) -> None:
    """Merge coincident nodes; elements that lose an edge become triangles or are dropped."""
    corners, count, near = merged(shells.points, shells.corners)
    if not count:
        return
    quads = corners[:, 3] >= 0
    # Remove corners equal to the previous one; later corners move up.
    for place in range(4):
        same = quads & (corners[:, place] == corners[:, place - 1])
        corners[same, place:3] = corners[same, place + 1 :]
        corners[same, 3] = -1
        quads &= ~same
    a, b, c, d = corners.T
    lost = (a == b) | (b == c) | (c == a) | (quads & (b == d))
    shells.corners = corners
    text = f"{count} nodes within {near:.2g} of another (in the file's unit) are merged"
    if lost.any():
        some = ", ".join(str(each) for each in shells.ids[lost][:3])
        text += f"; {int(lost.sum())} elements then have no area and are left out, such as {some}"
        shells.keep(~lost)
    if not len(shells.ids):
        raise shells.mesh.error("all elements are smaller than the tolerance for coincident nodes")
    shells.mesh.notes.append(text)


def merged(points: NDArray[Any], corners: NDArray[Any]) -> tuple[NDArray[Any], int, float]:
    """Return corners with coincident nodes merged, the number of nodes removed, and the tolerance used."""
    used = np.unique(corners[corners >= 0])
    near = MERGED * float(np.ptp(points[used], axis=0).max())
    root = _coincident(points[used], near)
    to = np.arange(len(points))
    to[used] = used[root]
    return np.where(corners >= 0, to[corners], -1), int((root != np.arange(len(root))).sum()), near


def _coincident(points: NDArray[Any], near: float) -> NDArray[Any]:
    """Return for each point the index of the first point within ``near`` of it, possibly itself."""
    along = points @ np.array(DIRECTION)
    order = np.argsort(along, kind="stable")
    ranked, places = along[order], points[order]
    root = np.arange(len(points))
    for step in range(1, min(WINDOW, len(points))):
        close = ranked[step:] - ranked[:-step] <= near
        if not close.any():
            break
        first = np.flatnonzero(close)
        first = first[np.linalg.norm(places[first + step] - places[first], axis=1) <= near]
        one, other = root[order[first]], root[order[first + step]]
        np.minimum.at(root, order[first + step], np.minimum(one, other))
        np.minimum.at(root, order[first], np.minimum(one, other))
    while (root[root] != root).any():
        root = root[root]
    return root


def _drop_unused(shells: Shells) -> None:
    used, corners = np.unique(shells.corners, return_inverse=True)
    shift = int(used[0] == -1)  # -1 marks the missing corner of triangles
    shells.corners = corners.reshape(-1, 4) - shift
    used = used[shift:]
    shells.points, shells.node_ids = shells.points[used], shells.node_ids[used]


def _check_doubles(shells: Shells) -> None:
    """Raise FileError if two elements have the same nodes."""
    ordered = np.sort(shells.corners, axis=1)
    _, first, back = np.unique(ordered, axis=0, return_index=True, return_inverse=True)
    doubled = np.flatnonzero(first[back.reshape(-1)] != np.arange(len(ordered)))
    if len(doubled):
        one, other = shells.ids[first[back.reshape(-1)[doubled[0]]]], shells.ids[doubled[0]]
        raise shells.mesh.error(f"elements {one} and {other} have the same nodes; remove one of them")


def _edges(corners: NDArray[Any]) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any]]:
    """Return the edges of elements: ordered end nodes, shape (k, 2), element, and position within the element."""
    element, place = np.nonzero(corners >= 0)
    after = (place + 1) % np.where(corners[element, 3] >= 0, 4, 3)
    return np.stack([corners[element, place], corners[element, after]], axis=1), element, place


def _turn_outward(shells: Shells, face: NDArray[Any]) -> None:
    """Orient the elements of each connected surface counterclockwise as seen from outside."""
    nodes, element, _ = _edges(shells.corners)
    keys, edge, count = np.unique(np.sort(nodes, axis=1), axis=0, return_inverse=True, return_counts=True)
    edge = edge.reshape(-1)
    if (count > 2).any():
        row = int(np.argmax(count > 2))
        three = ", ".join(str(each) for each in shells.ids[element[edge == row]][:4])
        ends = " and ".join(str(each) for each in shells.node_ids[keys[row]])
        raise shells.mesh.error(
            f"elements {three} share the edge between nodes {ends}; T-joints of walls, such as ribs, are not supported"
        )
    order = np.argsort(edge, kind="stable")
    pairs = order[np.repeat(count == 2, count)].reshape(-1, 2)
    same = (nodes[pairs[:, 0]] == nodes[pairs[:, 1]]).all(axis=1)
    flip, piece = _orient_pieces(len(shells.corners), element[pairs], same)
    _check_pieces(shells, piece)
    _note_open_edges(shells, keys[count == 1], element[order][np.repeat(count == 1, count)])
    area = _area_vectors(shells) * np.where(flip, -1.0, 1.0)[:, None]
    centre = _centres(shells)
    size = np.linalg.norm(area, axis=1)
    middle = (size[:, None] * centre).sum(axis=0) / max(float(size.sum()), 1e-300)
    outflow = np.einsum("ij,ij->i", area, centre - middle)
    of_face = face[shells.group]
    for each in range(int(piece.max()) + 1):
        own = piece == each
        inward = float(outflow[own].sum())
        if abs(inward) < 1e-3 * float(size[own].sum()) ** 1.5:  # a plate has no inside: its face must point forward
            inward = float(area[own & of_face, 0].sum())
        if inward < 0.0:
            flip[own] ^= True
    if not flip.any():
        return
    corners = shells.corners[flip]
    shells.corners[flip] = np.where(corners[:, 3:] < 0, corners[:, [0, 2, 1, 3]], corners[:, [0, 3, 2, 1]])
    parts = "all" if flip.all() else f"{int(flip.sum())} of {len(flip)}"
    shells.mesh.notes.append(
        f"the normals of {parts} elements pointed inward and were reversed, starting with element {shells.ids[flip][0]}"
    )


def _check_pieces(shells: Shells, piece: NDArray[Any]) -> None:
    """Raise FileError if the mesh is in pieces, such as both sides of walls, or parts with open seams."""
    sizes = np.bincount(piece)
    if len(sizes) == 1:
        return
    some = ", ".join(
        f"{size} with element {shells.ids[np.argmax(piece == each)]}" for each, size in enumerate(sizes[:4])
    )
    least = piece == int(np.argmin(sizes))
    one, other = (shells.points[np.unique(shells.corners[rows][shells.corners[rows] >= 0])] for rows in (least, ~least))
    distances = np.concatenate([np.linalg.norm(other - place, axis=1) for place in one[:SAMPLE]])
    away = float(distances[distances > 0.0].min())  # pieces that touch only at a node remain separate
    raise shells.mesh.error(
        f"a mesh must be in one piece, but this one is in {len(sizes)} that share no edge, of {some} elements; nodes of"
        f" the smallest are {away:.3g} from the others (in the file's unit): merge the nodes at seams, and mesh each"
        " wall once, on its middle surface"
    )


def _note_open_edges(shells: Shells, edges: NDArray[Any], element: NDArray[Any]) -> None:
    """Note edges that belong to a single element, as at a hole or slit."""
    if not len(edges):
        return
    ends = shells.points[edges]
    length = float(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).sum())
    shells.mesh.notes.append(
        f"the surface is open, as at a hole or a slit: along {length:.3g} (in the file's unit), elements such as"
        f" {shells.ids[element[0]]} have no neighbour at an edge"
    )


def _orient_pieces(count: int, pairs: NDArray[Any], same: NDArray[Any]) -> tuple[NDArray[Any], NDArray[Any]]:
    """Return which elements to reverse so that neighbours agree within each piece, and the piece of each element."""
    neighbours: list[list[tuple[int, bool]]] = [[] for _ in range(count)]
    for (one, other), alike in zip(pairs.tolist(), same.tolist(), strict=True):
        neighbours[one].append((other, alike))
        neighbours[other].append((one, alike))
    flip, piece = np.zeros(count, bool), np.full(count, -1)
    pieces = 0
    for start in range(count):
        if piece[start] >= 0:
            continue
        piece[start] = pieces
        heap, members = [start], [start]
        while heap:
            at = heap.pop()
            for other, alike in neighbours[at]:
                if piece[other] < 0:
                    piece[other], flip[other] = pieces, flip[at] ^ alike
                    heap.append(other)
                    members.append(other)
        if 2 * int(flip[members].sum()) > len(members):  # reverse the minority
            flip[members] ^= True
        pieces += 1
    return flip, piece


def _area_vectors(shells: Shells) -> NDArray[Any]:
    corners = shells.corners.copy()
    corners[:, 3] = np.where(corners[:, 3] >= 0, corners[:, 3], corners[:, 0])
    return area_vectors(shells.points, corners)


def _centres(shells: Shells) -> NDArray[Any]:
    there = (shells.corners >= 0)[..., None]
    return np.where(there, shells.points[shells.corners], 0.0).sum(axis=1) / there.sum(axis=1)


def _cut_bad_quadrilaterals(shells: Shells) -> None:
    """Cut quadrilaterals with an angle of nearly 180 degrees or more into triangles; reject elements without area."""
    corners = shells.corners
    length = float(np.ptp(shells.points, axis=0).max())
    area = np.linalg.norm(_area_vectors(shells), axis=1)
    flat = area < (1e-5 * length) ** 2
    quads = np.flatnonzero(corners[:, 3] >= 0)
    places = shells.points[corners[quads]]
    across = np.cross(places[:, 2] - places[:, 0], places[:, 3] - places[:, 1])
    # Twice the area of each corner's triangle over the parallelogram of the diagonals; 0.5 in a square.
    turns = np.cross(places - np.roll(places, 1, axis=1), np.roll(places, -1, axis=1) - places)
    square = np.maximum(np.einsum("ij,ij->i", across, across), 1e-300)
    angles = np.einsum("ijk,ik->ij", turns, across) / square[:, None]
    bad = angles.min(axis=1) < LEAST_ANGLE
    at = angles.argmin(axis=1)
    rows = np.arange(len(quads))
    # The diagonal from the worst corner leaves one triangle at each neighbouring corner.
    sibling = np.minimum(angles[rows, (at + 1) % 4], angles[rows, (at + 3) % 4])
    flat[quads[bad & (sibling <= LEAST_ANGLE)]] = True
    if flat.any():
        row = int(np.argmax(flat))
        nodes = ", ".join(str(shells.node_ids[each]) for each in corners[row] if each >= 0)
        raise shells.mesh.error(
            f"element {shells.ids[row]} is inverted or degenerate: its nodes {nodes} must go around it in order and"
            " enclose an area; correct or refine the mesh there"
        )
    cut = quads[bad]
    if not len(cut):
        return
    start = at[bad]
    a, b, c, d = (corners[cut, (start + each) % 4] for each in range(4))
    none = np.full(len(cut), -1)
    some = ", ".join(str(each) for each in shells.ids[cut][:3])
    kept = np.ones(len(corners), bool)
    kept[cut] = False
    shells.keep(np.concatenate([np.flatnonzero(kept), cut, cut]))
    whole = len(shells.corners) - 2 * len(cut)
    shells.corners[whole:] = np.concatenate([np.stack([a, b, c, none], axis=1), np.stack([a, c, d, none], axis=1)])
    shells.mesh.notes.append(
        f"quadrilaterals with an angle of nearly 180 degrees are cut into triangles: {len(cut)}, such as {some}"
    )


def _split_triangles(shells: Shells) -> None:
    """Split triangles into three quadrilaterals at their edge midpoints, and quadrilaterals between them to match.

    A quadrilateral with a midpoint on one edge gets one on another edge too, and so on to the next triangle, so that
    each is split into two, three or four and no hanging nodes remain.
    """
    triangles = shells.corners[:, 3] < 0
    if not triangles.any():
        return
    nodes, element, place = _edges(shells.corners)
    keys, edge = np.unique(np.sort(nodes, axis=1), axis=0, return_inverse=True)
    edge = edge.reshape(-1)
    of_place = np.full((len(shells.corners), 4), -1)
    of_place[element, place] = edge
    marked = _edges_to_halve(of_place, triangles, len(keys))
    middle = np.full(len(keys), -1)
    middle[marked] = len(shells.points) + np.arange(int(marked.sum()))
    points = [shells.points, shells.points[keys[marked]].mean(axis=1)]
    ids = [shells.node_ids, np.zeros(int(marked.sum()), np.int64)]
    corners = shells.corners
    middles = np.where(of_place >= 0, middle[of_place], -1)
    four = ~triangles & (middles >= 0).all(axis=1)
    bends = ~triangles & ~four & ((middles >= 0) & (np.roll(middles, -1, axis=1) >= 0)).any(axis=1)
    centred = triangles | four | bends
    centres = np.full(len(corners), -1)
    centres[centred] = sum(map(len, points)) + np.arange(int(centred.sum()))
    points.append(_centres(shells)[centred])
    ids.append(np.zeros(int(centred.sum()), np.int64))
    made, parent = [], []

    def add(rows: NDArray[Any], *columns: NDArray[Any]) -> None:
        made.append(np.stack([each[rows] for each in columns], axis=1))
        parent.append(np.flatnonzero(rows))

    for count, rows in ((3, triangles), (4, four)):
        for at in range(count):
            add(rows, corners[:, at], middles[:, at], centres, middles[:, (at - 1) % count])
    whole = ~triangles & (middles < 0).all(axis=1)
    add(whole, *(corners[:, at] for at in range(4)))
    for at in range(4):
        a, b, c, d = (corners[:, (at + each) % 4] for each in range(4))
        first, second, last = (middles[:, (at + each) % 4] for each in (0, 1, 2))
        if at < 2:
            two = ~triangles & ~four & (first >= 0) & (last >= 0)
            add(two, a, first, last, d)
            add(two, first, b, c, last)
        bent = ~triangles & ~four & (first >= 0) & (second >= 0)
        add(bent, b, second, centres, first)
        add(bent, second, c, d, centres)
        add(bent, centres, d, a, first)
    rows = np.concatenate(parent)
    split = len(corners) - int(triangles.sum()) - int(whole.sum())
    shells.points, shells.node_ids = np.concatenate(points), np.concatenate(ids)
    shells.keep(rows)
    shells.corners = np.concatenate(made)
    text = f"{int(triangles.sum())} triangles are split into three quadrilaterals each"
    if split:
        text += f", and {split} quadrilaterals between them into two to four"
    shells.mesh.notes.append(text)


def _edges_to_halve(of_place: NDArray[Any], triangles: NDArray[Any], count: int) -> NDArray[Any]:
    """Return the edges to halve: all edges of triangles, and as few others as give each quadrilateral an even number.

    From a quadrilateral with an odd number, a path leads through neighbours to the nearest other such one or to the
    edge of the surface; every edge it crosses is switched. Paths do not cross edges of triangles, so the odd ones of a
    surface pair up.

    ``of_place`` has the edges of each element, shape (m, 4), ``count`` in all; ``triangles`` marks the triangles.
    """
    marked = np.zeros(count, bool)
    marked[of_place[triangles, :3]] = True
    sides: list[list[int]] = [[] for _ in range(count)]
    for quad in np.flatnonzero(~triangles).tolist():
        for edge in of_place[quad].tolist():
            sides[edge].append(quad)
    way = ~marked
    odd = set(np.flatnonzero(~triangles & (marked[np.where(of_place >= 0, of_place, 0)].sum(axis=1) % 2 == 1)).tolist())
    for start in sorted(odd):
        if start not in odd:
            continue
        odd.remove(start)
        came: dict[int, tuple[int, int]] = {start: (-1, -1)}
        row, end = [start], None
        while row and end is None:
            after = []
            for at in row:
                for edge in of_place[at].tolist():
                    others = [each for each in sides[edge] if each != at]
                    if not way[edge] or (others and others[0] in came):
                        continue
                    if not others:  # the end of the surface
                        end = at
                        marked[edge] ^= True
                        break
                    came[others[0]] = (at, edge)
                    if others[0] in odd:
                        end = others[0]
                        odd.remove(end)
                        break
                    after.append(others[0])
                if end is not None:
                    break
            row = after
        while end is not None and came[end][0] >= 0:
            end, edge = came[end]
            marked[edge] ^= True
    return marked
