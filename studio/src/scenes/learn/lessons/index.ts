/** The lessons in their order. */

import type { Lesson } from "../lesson";
import { curve } from "./curve";
import { descent } from "./descent";
import { gear } from "./gear";
import { height } from "./height";
import { monitors } from "./monitors";
import { rules } from "./rules";
import { spin } from "./spin";
import { wet } from "./wet";

export const LESSONS: readonly Lesson[] = [spin, curve, gear, height, descent, wet, rules, monitors];
