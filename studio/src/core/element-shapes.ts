/** What is drawn of a meshed ball and its shapes: the sides of its elements on the surface and in the middle plane. */

/** Corners of the sides of a hexahedron in binary order, counterclockwise seen from outside. */
const SIDES = [
  [0, 2, 3, 1],
  [4, 5, 7, 6],
  [0, 1, 5, 4],
  [1, 3, 7, 5],
  [3, 2, 6, 7],
  [2, 0, 4, 6],
];
/** How near the middle plane a node must be to lie in it [m]. */
const NEAR = 1e-9;

/** Quadrilaterals: four places among the nodes that are kept, and the piece of the body that each belongs to. */
export interface Quads {
  corners: Uint32Array;
  pieces: Uint8Array;
}

export interface Drawn {
  /** Numbers of the nodes that are kept. */
  nodes: Uint32Array;
  /** The surface before the middle plane (towards the heel) comes first. */
  surface: Quads;
  /** How many quadrilaterals of the surface lie towards the heel. */
  half: number;
  /** The middle plane, through the face normal and up the face. */
  section: Quads;
}

interface Side {
  corners: number[];
  piece: number;
  count: number;
}

/** The sides of elements by their nodes, with the number of elements that share each. */
function sides(elements: ArrayLike<number>, piece: ArrayLike<number>): Side[] {
  const known = new Map<string, Side>();
  for (let element = 0; element * 8 < elements.length; element += 1) {
    for (const side of SIDES) {
      const corners = side.map((corner) => elements[8 * element + corner]);
      const key = [...corners].sort((a, b) => a - b).join();
      const before = known.get(key);
      if (before) before.count += 1;
      else known.set(key, { corners, piece: piece[element], count: 1 });
    }
  }
  return [...known.values()];
}

/** What is drawn of a ball about the origin, whose nodes have x, y, z one after the other. */
export function drawnParts(nodes: ArrayLike<number>, elements: ArrayLike<number>, piece: ArrayLike<number>): Drawn {
  const toe = (node: number): number => nodes[3 * node + 2];
  const all = sides(elements, piece);
  const outer = all.filter(({ count }) => count === 1);
  const middle = ({ corners }: Side): number => corners.reduce((sum, node) => sum + toe(node), 0);
  const heel = outer.filter((side) => middle(side) < 0);
  const surface = [...heel, ...outer.filter((side) => middle(side) >= 0)];
  const section = all.filter(({ corners }) => corners.every((node) => Math.abs(toe(node)) < NEAR));
  const kept = new Map<number, number>();
  const quads = (list: Side[]): Quads => ({
    corners: Uint32Array.from(
      list.flatMap(({ corners }) =>
        corners.map((node) => {
          const place = kept.get(node) ?? kept.size;
          kept.set(node, place);
          return place;
        }),
      ),
    ),
    pieces: Uint8Array.from(list, (side) => side.piece),
  });
  const [surfaceQuads, sectionQuads] = [quads(surface), quads(section)];
  return { nodes: Uint32Array.from(kept.keys()), surface: surfaceQuads, half: heel.length, section: sectionQuads };
}
