/** The place, in the units of a drawing, where a pointer is pressed or dragged; null while it only hovers. */
export function draggedPlace(event: PointerEvent): DOMPoint | null {
  const drawing = event.currentTarget as SVGSVGElement;
  if (event.type === "pointerdown") drawing.setPointerCapture(event.pointerId);
  else if (!drawing.hasPointerCapture(event.pointerId)) return null;
  const matrix = drawing.getScreenCTM();
  return matrix && new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse());
}
