/** How widely the impacts of a golfer scatter. */

import type { Distribution } from "../../equipment/equipment";

/** Standard deviations towards the toe and up the face [m] of all shots, mishits among them. */
export function deviationsOf({ variables, covariance, mishit_share, mishit_scale }: Distribution): [number, number] {
  const wider = 1 + mishit_share * (mishit_scale ** 2 - 1);
  const deviation = (name: string): number => {
    const place = variables.indexOf(name);
    return place < 0 ? 0 : Math.sqrt(covariance[place][place] * wider);
  };
  return [deviation("toe"), deviation("high")];
}
