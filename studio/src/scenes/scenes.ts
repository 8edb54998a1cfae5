/** The scenes in the order of the page's head: a new one is a folder and an entry here. */

import type { SceneEntry } from "../context";
import { CONDITIONS } from "../state/conditions";
import type { Settings } from "../state/settings";
import { USED_CLUB } from "../state/used-club";
import { DESIGN_SETTINGS } from "./design/settings";
import { elementsSettings } from "./elements/settings";
import { flightSettings } from "./flight/settings";
import { LEARN_SETTINGS } from "./learn/settings";
import { mapSettings } from "./map/settings";
import { modelsScene } from "./models/models-scene";
import { sessionsSettings } from "./sessions/settings";
import { shotSettings } from "./shot/settings";
import { shotScene } from "./shot/shot-scene";

export const SCENES: readonly SceneEntry[] = [
  { name: "shot", title: "Shot", settings: shotSettings, load: () => shotScene },
  { name: "models", title: "Models", load: () => modelsScene },
  {
    name: "elements",
    title: "Finite elements",
    settings: elementsSettings,
    load: () => import("./elements/elements-scene").then(({ elementsScene }) => elementsScene),
  },
  {
    name: "flight",
    title: "Flight",
    settings: flightSettings,
    load: () => import("./flight/flight-scene").then(({ flightScene }) => flightScene),
  },
  {
    name: "map",
    title: "Face map",
    settings: mapSettings,
    load: () => import("./map/map-scene").then(({ mapScene }) => mapScene),
  },
  {
    name: "design",
    title: "Design",
    hasOwnShots: true,
    settings: DESIGN_SETTINGS,
    load: () => import("./design/design-scene").then(({ designScene }) => designScene),
  },
  {
    name: "learn",
    title: "Learn",
    hasOwnShots: true,
    settings: LEARN_SETTINGS,
    load: () => import("./learn/learn-scene").then(({ learnScene }) => learnScene),
  },
  {
    name: "sessions",
    title: "Your shots",
    hasOwnShots: true,
    settings: sessionsSettings,
    load: () => import("./sessions/sessions-scene").then(({ sessionsScene }) => sessionsScene),
  },
];

/** The settings of all scenes, and the conditions and the club that hold for every one of them. */
export const SETTINGS: Settings = Object.assign(
  {},
  CONDITIONS,
  USED_CLUB,
  ...SCENES.map(({ settings = {} }) => settings),
);
