/** Quantities of launch and flight by which shots are compared, in the order of the tables. */
export const LAUNCH_AND_FLIGHT: readonly string[] = [
  "ball_speed",
  "smash",
  "launch",
  "azimuth",
  "backspin",
  "sidespin",
  "spin_axis",
  "carry",
  "side",
  "total",
  "apex",
  "landing_angle",
];
/** The same with the contact, where impacts are compared. */
export const IMPACT_AND_FLIGHT: readonly string[] = [...LAUNCH_AND_FLIGHT, "contact_time", "peak_force"];
