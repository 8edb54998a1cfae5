/** The equations that are integrated where a number is no formula of others. */

import { html, type TemplateResult } from "lit-html";

/** Of the flight, as docs/flight.md has them; bold letters are vectors. */
export const flightMotion = (): TemplateResult => html`
  <math display="block">
    <mi>m</mi><mover><mi mathvariant="bold">v</mi><mo>˙</mo></mover><mo>=</mo>
    <mi>m</mi><mi mathvariant="bold">g</mi><mo>−</mo>
    <mfrac><mn>1</mn><mn>2</mn></mfrac><mi>ρ</mi><mi>A</mi><msub><mi>C</mi><mi>D</mi></msub>
    <msub><mi>v</mi><mi>r</mi></msub><msub><mi mathvariant="bold">v</mi><mi>r</mi></msub><mo>+</mo>
    <mfrac><mn>1</mn><mn>2</mn></mfrac><mi>ρ</mi><mi>A</mi><msub><mi>C</mi><mi>L</mi></msub>
    <msub><mi>v</mi><mi>r</mi></msub>
    <mfrac><mi mathvariant="bold">ω</mi><mi>ω</mi></mfrac><mo>×</mo><msub><mi mathvariant="bold">v</mi><mi>r</mi></msub>
  </math>
  <math display="block">
    <msub><mi>I</mi><mi>b</mi></msub><mover><mi mathvariant="bold">ω</mi><mo>˙</mo></mover><mo>=</mo><mo form="prefix">−</mo>
    <mfrac><mn>1</mn><mn>2</mn></mfrac><mi>ρ</mi><mi>A</mi><msub><mi>C</mi><mi>M</mi></msub><mi>R</mi>
    <msup><msub><mi>v</mi><mi>r</mi></msub><mn>2</mn></msup><mfrac><mi mathvariant="bold">ω</mi><mi>ω</mi></mfrac>
  </math>
`;

/** Of both bodies while they touch. */
export const contactMotion = (): TemplateResult => html`
  <math display="block">
    <msub><mi>m</mi><mi>b</mi></msub><mover><msub><mi mathvariant="bold">v</mi><mi>b</mi></msub><mo>˙</mo></mover><mo>=</mo>
    <mi mathvariant="bold">F</mi><mo>,</mo><mspace width="1em"></mspace>
    <msub><mi>I</mi><mi>b</mi></msub><mover><msub><mi mathvariant="bold">ω</mi><mi>b</mi></msub><mo>˙</mo></mover><mo>=</mo>
    <msub><mi mathvariant="bold">r</mi><mi>b</mi></msub><mo>×</mo><mi mathvariant="bold">F</mi>
  </math>
  <math display="block">
    <msub><mi>m</mi><mi>c</mi></msub><mover><msub><mi mathvariant="bold">v</mi><mi>c</mi></msub><mo>˙</mo></mover><mo>=</mo>
    <mo form="prefix">−</mo><mi mathvariant="bold">F</mi><mo>,</mo><mspace width="1em"></mspace>
    <mover><mrow><mo>(</mo><msub><mi mathvariant="bold">I</mi><mi>c</mi></msub><msub><mi mathvariant="bold">ω</mi><mi>c</mi></msub><mo>)</mo></mrow><mo>˙</mo></mover>
    <mo>=</mo><mo form="prefix">−</mo><msub><mi mathvariant="bold">r</mi><mi>c</mi></msub><mo>×</mo><mi mathvariant="bold">F</mi>
  </math>
`;
