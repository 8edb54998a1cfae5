/** Names as people write them, for what a link or a file calls by its key; a key that is unknown stands for itself. */

import type { Description } from "../core/types";
import type { Equipment } from "./equipment";

interface Known {
  equipment: Equipment;
  description: Pick<Description, "models">;
}

export const clubName = ({ equipment }: Pick<Known, "equipment">, key: string): string =>
  equipment.clubs[key]?.label ?? key;

export const ballName = ({ equipment }: Pick<Known, "equipment">, key: string): string =>
  equipment.balls[key]?.label ?? key;

export const modelName = ({ description }: Pick<Known, "description">, key: string): string =>
  description.models.find(({ name }) => name === key)?.title ?? key;

/** The name of a published parameter set; "" stands for the usual one. */
export const setName = ({ equipment }: Pick<Known, "equipment">, key: string): string =>
  key ? (equipment.sets.find(({ name }) => name === key)?.label ?? key) : "usual";
