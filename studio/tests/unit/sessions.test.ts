import { expect, test } from "vitest";
import { Units } from "../../src/quantities/units";
import { clubsOf, landing, measuredColumns, shotRows } from "../../src/scenes/sessions/shot-rows";
import { initialLive, type ResultDocument, type TableDocument, withShots } from "../../src/state/session";
import { description } from "../described";

const units = new Units(description);
const SHOTS: TableDocument = {
  columns: {
    shot: { label: "shot" },
    club: { label: "club" },
    ball_speed_mps: { label: "ball speed", quantity: "ball_speed", unit: "m/s" },
    launch_deg: { label: "launch angle", quantity: "launch", unit: "deg" },
    carry_m: { label: "carry", quantity: "carry", unit: "m" },
    side_m: { label: "side", quantity: "side", unit: "m" },
    computed: { label: "computed" },
  },
  rows: [
    { shot: 1, club: "7i", ball_speed_mps: 50, launch_deg: 18, carry_m: 130, side_m: -50, computed: "carry side" },
    { shot: 2, club: "7i", ball_speed_mps: null, launch_deg: 20, carry_m: null, side_m: null, computed: "" },
    { shot: 3, club: "driver", ball_speed_mps: 60, launch_deg: 12, carry_m: null, side_m: null, computed: "" },
  ],
};
const PATHS: TableDocument = {
  columns: {},
  rows: [
    { shot: 3, along_m: 0, height_m: 0, side_m: 0 },
    { shot: 3, along_m: 180, height_m: 0, side_m: 4 },
  ],
};
const result = (rows: TableDocument["rows"]): ResultDocument => ({
  kind: "shot-list",
  title: "",
  values: {},
  tables: { shots: { ...SHOTS, rows }, paths: PATHS },
  summary: [],
  notes: [{ code: "x", text: "newest" }],
});

test("shots have their values in SI, and know which are computed", () => {
  const [first, second] = shotRows(units, SHOTS, PATHS);
  expect(first.values.launch).toBeCloseTo((18 * Math.PI) / 180, 15);
  expect(first.values.ball_speed).toBe(50);
  expect([...first.computed]).toEqual(["carry", "side"]);
  expect(second.values).not.toHaveProperty("ball_speed");
  expect(measuredColumns(SHOTS).map(({ quantity }) => quantity)).toEqual(["ball_speed", "launch", "carry", "side"]);
});

test("a shot lands where carry and side say, or else at the end of its flight path, or nowhere", () => {
  const [first, second, third] = shotRows(units, SHOTS, PATHS);
  expect(landing(first)).toEqual([120, -50]);
  expect(landing(second)).toBeNull();
  expect(landing(third)).toEqual([180, 4]);
});

test("clubs are counted in the order in which they come", () => {
  expect(clubsOf(shotRows(units, SHOTS, undefined))).toEqual([
    ["7i", 2],
    ["driver", 1],
  ]);
});

test("the shots of another event come behind those of the last", () => {
  const live = withShots(withShots(initialLive(), result(SHOTS.rows.slice(0, 2))), result(SHOTS.rows.slice(2)));
  expect(live.shots.rows.map(({ shot }) => shot)).toEqual([1, 2, 3]);
  expect(live.paths.rows.length).toBe(4);
  expect(live.notes.map(({ text }) => text)).toEqual(["newest"]);
});
