/** What can be chosen in the scene Design, and how far its sliders reach. */

import type { Settings } from "../../state/settings";

/** A number of the club that can be changed. */
export interface Variable {
  /** The input of the core. */
  name: string;
  label: string;
  /** What a step more of it is called, and the step in the unit that people read. */
  more: string;
  step: number;
  unit: string;
  /** How far the slider goes to either side of the club's own value, as people write it; a share of it where given so. */
  reach: string | number;
  /** Ends of the slider where the club's own value is infinite. */
  ends?: readonly [string, string];
}

export const CG: Variable[] = [
  { name: "cg_x", label: "CG behind the face", more: "CG back", step: 1, unit: "mm", reach: "15 mm" },
  { name: "cg_y", label: "CG below the face centre", more: "CG down", step: 1, unit: "mm", reach: "10 mm" },
  { name: "cg_z", label: "CG towards the heel", more: "CG towards the heel", step: 1, unit: "mm", reach: "10 mm" },
];

export const INERTIA: Variable[] = [
  { name: "iyy", label: "Inertia, vertical", more: "inertia against twisting", step: 100, unit: "g cm2", reach: 0.3 },
  { name: "izz", label: "Inertia, heel to toe", more: "inertia against tilting", step: 100, unit: "g cm2", reach: 0.3 },
  {
    name: "ixx",
    label: "Inertia, to the target",
    more: "inertia against rolling",
    step: 100,
    unit: "g cm2",
    reach: 0.3,
  },
];

export const PRODUCTS: Variable[] = [
  { name: "ixy", label: "Product xy", more: "product xy", step: 50, unit: "g cm2", reach: "800 g cm2" },
  { name: "ixz", label: "Product xz", more: "product xz", step: 50, unit: "g cm2", reach: "800 g cm2" },
  { name: "iyz", label: "Product yz", more: "product yz", step: 50, unit: "g cm2", reach: "800 g cm2" },
];

export const FACE: Variable[] = [
  { name: "club_mass", label: "Mass of the head", more: "mass", step: 5, unit: "g", reach: "30 g" },
  { name: "static_loft", label: "Loft", more: "loft", step: 1, unit: "deg", reach: "5 deg" },
  {
    name: "bulge",
    label: "Bulge",
    more: "flatter bulge",
    step: 20,
    unit: "mm",
    reach: "150 mm",
    ends: ["150 mm", "1000 mm"],
  },
  {
    name: "roll",
    label: "Roll",
    more: "flatter roll",
    step: 20,
    unit: "mm",
    reach: "150 mm",
    ends: ["150 mm", "1000 mm"],
  },
  {
    name: "characteristic_time",
    label: "Spring of the face",
    more: "spring of the face",
    step: 10,
    unit: "us",
    reach: "80 us",
  },
];

export const OUTLINE: Variable[] = [
  { name: "face_width", label: "Width of the face", more: "wider", step: 5, unit: "mm", reach: "25 mm" },
  { name: "face_height", label: "Height of the face", more: "higher", step: 5, unit: "mm", reach: "20 mm" },
];

/** All numbers of the club. */
export const VARIABLES: Variable[] = [...CG, ...INERTIA, ...PRODUCTS, ...FACE, ...OUTLINE];

/** The space of the head. */
export const SPACE: Variable[] = [
  { name: "face_to_back", label: "Face to back", more: "longer", step: 1, unit: "mm", reach: "20 mm" },
  { name: "sole_to_crown", label: "Sole to crown", more: "higher", step: 1, unit: "mm", reach: "15 mm" },
  { name: "heel_to_toe", label: "Heel to toe", more: "wider", step: 1, unit: "mm", reach: "20 mm" },
  { name: "volume", label: "Volume", more: "larger", step: 10, unit: "cm3", reach: "100 cm3" },
  { name: "free_mass", label: "Free mass", more: "free mass", step: 5, unit: "g", reach: "25 g" },
];

/** What the axes of the optimum chart may be: what a launch depends on. */
export const AXES: Variable[] = [...CG, ...INERTIA, ...FACE];

export const OBJECTIVES = ["carry", "total", "ball_speed", "spread"] as const;
export type ObjectiveName = (typeof OBJECTIVES)[number];

export const STRIKE = "strike";
export const HEAVIER = ["slower", "same"] as const;

export const DESIGN_SETTINGS: Settings = {
  ...Object.fromEntries(
    [...VARIABLES, ...SPACE].map(
      ({ name, unit }) => [name, { kind: "of-club", quantity: name, usual: { value: Number.NaN, unit } }] as const,
    ),
  ),
  heavier: { kind: "choice", options: HEAVIER, usual: "slower" },
  struck_by: { kind: "choice", options: ({ golfers }) => [STRIKE, ...Object.keys(golfers)], usual: STRIKE },
  best: { kind: "choice", options: OBJECTIVES, usual: "carry" },
  across: { kind: "choice", options: AXES.map(({ name }) => name), usual: "cg_x" },
  upwards: { kind: "choice", options: AXES.map(({ name }) => name), usual: "cg_y" },
};
