/** Pictures of every scene of the static site. `SCREENSHOTS=folder npm run screenshots`. */

import { TestStudio } from "../browser/site";
import { drawScene } from "../pictures";

const SHOT = "#club=driver&speed=105mph&attack=2deg&path=4deg&loft=13deg&face=1deg&toe=8mm&high=4mm&units=golf";
/** Each scene by its link, and by what it shows when it is whole. */
const SCENES: Record<string, [link: string, ready: string]> = {
  shot: [SHOT, "[data-quantity]"],
  elements: [
    SHOT.replace("#", "#scene=elements&impact_moment=260us&"),
    ".status[data-status='done'][data-mesh='fine']",
  ],
  flight: [SHOT.replace("#", "#scene=flight&wind=12mph&wind_from=60deg&"), "[data-stage=range] canvas"],
  map: [SHOT.replace("#", "#scene=map&map=carry&"), "[data-loss=carry]"],
  design: [
    SHOT.replace("#", "#scene=design&cg_x=45mm&upwards=iyy&struck_by=handicap-10-driver&"),
    ".optimum path.contour",
  ],
  models: [SHOT.replace("#", "#scene=models&"), ".models td"],
  learn: [SHOT.replace("#", "#scene=learn&lesson=gear&"), ".answer data"],
};

const studio = new TestStudio({}, 100e3);

for (const [name, [link, ready]] of Object.entries(SCENES))
  drawScene(name, {
    timeout: 120e3,
    show: async (screen) => {
      await studio.renew(screen);
      const { page } = await studio.open(link, ready);
      await page.waitForTimeout(500);
      return page;
    },
  });
