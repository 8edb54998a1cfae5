import { describe, expect, test } from "vitest";
import { Units } from "../../src/quantities/units";
import { fromLink, type LinkContext, toLink } from "../../src/state/link";
import type { Settings } from "../../src/state/settings";
import { changed, initialState, type State } from "../../src/state/state";
import { description, equipment } from "../described";

const usual = initialState(equipment, "golf");
const settings: Settings = {
  wind: { kind: "amount", quantity: "speed", usual: { value: 0, unit: "mph" } },
  shown: { kind: "choice", options: ["carry", "side"], usual: "carry" },
  grip: { kind: "amount", quantity: "friction", usual: { value: 0.3, unit: "1" } },
  bag: { kind: "several", options: ({ clubs }) => Object.keys(clubs), usual: "" },
};
const context: LinkContext = {
  equipment,
  units: new Units(description),
  inputs: description.inputs,
  scenes: ["shot", "models"],
  settings,
  usual,
};

describe("the link", () => {
  test("the first state is short and readable", () => {
    expect(toLink(usual, context)).toBe("#club=driver&speed=105mph");
  });

  test("holds the whole state", () => {
    const state: State = {
      scene: "models",
      club: "7-iron",
      ball: "conforming",
      model: "rings",
      parameters: "three-dimensional-impact-models/as-printed",
      hand: "left",
      system: "metric",
      theme: "dark",
      delivery: {
        speed: { value: 41.5, unit: "m/s" },
        face: { value: -2.25, unit: "deg" },
        closure: { value: 1e-7, unit: "deg/s" },
        toe: { value: 8, unit: "mm" },
      },
      settings: {
        wind: { value: 10, unit: "mph" },
        grip: { value: 0.36, unit: "1" },
        shown: "side",
        bag: "driver,7-iron",
      },
    };
    const read = fromLink(toLink(state, context), context);
    expect(read.problems).toEqual([]);
    expect(read.state).toEqual(state);
  });

  test("spaces, plus signs and escapes are read", () => {
    const { state, problems } = fromLink("#club=driver&speed=105+mph&face=2%20deg&attack=-1.3deg", context);
    expect(problems).toEqual([]);
    expect(state.delivery).toEqual({
      speed: { value: 105, unit: "mph" },
      face: { value: 2, unit: "deg" },
      attack: { value: -1.3, unit: "deg" },
    });
  });

  test("what cannot be read is reported, and the rest is kept", () => {
    const { state, problems } = fromLink("#club=broom&speed=fast&face=2deg&path=3&breeze=5mph&%E0%A4%A=1&=", context);
    expect(problems).toHaveLength(6);
    expect(problems[0]).toContain("broom");
    expect(state.club).toBe("driver");
    expect(state.delivery).toEqual({ speed: usual.delivery.speed, face: { value: 2, unit: "deg" } });
  });

  test("settings of scenes are checked like the rest", () => {
    const { state, problems } = fromLink("#wind=5&shown=height&bag=driver,broom&wind=2m/s", context);
    expect(problems).toHaveLength(3);
    expect(state.settings).toEqual({ wind: { value: 2, unit: "m/s" } });
  });

  test("names of objects are no clubs", () => {
    const { state, problems } = fromLink("#club=constructor&model=__proto__&toString=1", context);
    expect(problems).toHaveLength(3);
    expect(state.club).toBe("driver");
  });
});

describe("changes", () => {
  test("another club changes speed and attack angle as the tour does, and takes its own loft", () => {
    const lofted = changed(
      usual,
      { kind: "delivery", amounts: { loft: { value: 12, unit: "deg" }, face: { value: 1, unit: "deg" } } },
      equipment,
    );
    const iron = changed(lofted, { kind: "club", club: "7-iron" }, equipment);
    expect(iron.delivery.speed).toEqual({ value: 84, unit: "mph" });
    expect(iron.delivery.attack).toEqual({ value: -3.9, unit: "deg" });
    expect(iron.delivery.loft).toBeUndefined();
    expect(iron.delivery.face).toEqual({ value: 1, unit: "deg" });
  });

  test("a setting goes back to what is usual", () => {
    const chosen = changed(usual, { kind: "settings", settings: { shown: "side" } }, equipment);
    expect(chosen.settings).toEqual({ shown: "side" });
    expect(changed(chosen, { kind: "settings", settings: { shown: null } }, equipment)).toEqual(usual);
  });

  test("a parameter set that another model does not have is left", () => {
    const printed: State = { ...usual, model: "rings", parameters: "three-dimensional-impact-models/as-printed" };
    expect(changed(printed, { kind: "model", model: "response" }, equipment).parameters).toBe("");
    expect(changed(printed, { kind: "hand", hand: "left" }, equipment).parameters).not.toBe("");
  });
});
