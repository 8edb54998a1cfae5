/** The strike in one sentence. */

import { type Context, delivered } from "../../context";

export function headlineDelivery(context: Context): string {
  const { state, formatter, equipment } = context;
  const text = (name: string): string => formatter.text(name, delivered(context, name), state.system);
  return (
    `${equipment.clubs[state.club].label} (${state.hand}-handed), ball ${equipment.balls[state.ball].label}: ` +
    `${text("speed")}, attack ${text("attack")}, path ${text("path")}, loft ${text("loft")}, face ${text("face")}, ` +
    `struck at ${text("toe")}, ${text("high")}.`
  );
}
