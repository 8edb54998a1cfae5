/* What goes wrong and how a program learns of it: a model that does not exist, a value that is not allowed, and one
 * shot of three that cannot be computed.
 *
 *     cc errors.c $(pkg-config --cflags --libs clubface) -o errors
 */
#include <clubface.h>
#include <stdio.h>
#include <stdlib.h>

enum { ROWS = 3 };

static void set(double *inputs, const char *name, double value) {
  ptrdiff_t column = clubface_column(CLUBFACE_COLUMNS_INPUTS, name);
  if (column < 0) {
    fprintf(stderr, "no input %s\n", name);
    exit(1);
  }
  for (int row = 0; row < ROWS; row++) inputs[column * ROWS + row] = value;
}

/* Prints what came of a computation and frees it. */
static void show(const char *label, ClubfaceResult *result) {
  const char *error = clubface_error(result); /* JSON: input, value, message; null if there is none */
  printf("%s: %s\n", label, error ? error : clubface_text(result));
  clubface_free(result);
}

int main(void) {
  if (clubface_abi() != CLUBFACE_ABI) {
    fprintf(stderr, "compiled for interface %d, but the library has %u\n", CLUBFACE_ABI, (unsigned)clubface_abi());
    return 1;
  }
  double *inputs = (double *)calloc(clubface_count(CLUBFACE_COLUMNS_INPUTS) * ROWS, sizeof(double));
  double *outputs = (double *)calloc(clubface_count(CLUBFACE_COLUMNS_OUTPUTS) * ROWS, sizeof(double));
  double *parameters = (double *)calloc((size_t)clubface_default_parameters("response", NULL), sizeof(double));
  clubface_default_parameters("response", parameters);
  set(inputs, "speed", 46.9);
  set(inputs, "loft", 0.22);
  set(inputs, "club_mass", 0.2);
  set(inputs, "cg_x", 0.0354);
  set(inputs, "ixx", 2.5e-4);
  set(inputs, "iyy", 4.7e-4);
  set(inputs, "izz", 2.7e-4);
  set(inputs, "static_loft", 0.17);
  set(inputs, "bulge", 0.305);
  set(inputs, "roll", 0.305);
  set(inputs, "face_width", 0.11);
  set(inputs, "face_height", 0.058);
  set(inputs, "characteristic_time", 2.4e-4);
  set(inputs, "hand", 1.0);
  set(inputs, "ball_mass", 0.0459);
  set(inputs, "ball_radius", 0.02134);
  set(inputs, "ball_inertia", 8.2e-6);

  show("no such model", clubface_launches("no such model", inputs, parameters, ROWS, 0.0, 1, outputs));

  /* What concerns all shots is an error, and no output is written. */
  show("tolerance", clubface_launches("response", inputs, parameters, ROWS, 7.0, 1, outputs));

  /* What concerns one shot leaves the others alone: its outputs are not a number, and the text names its row. */
  inputs[clubface_column(CLUBFACE_COLUMNS_INPUTS, "toe") * ROWS + 1] = 0.4;
  show("a miss", clubface_launches("response", inputs, parameters, ROWS, 0.0, 1, outputs));
  for (int row = 0; row < ROWS; row++) {
    double speed = outputs[clubface_column(CLUBFACE_COLUMNS_OUTPUTS, "ball_speed") * ROWS + row];
    if (speed == speed)
      printf("shot %d: %.9f m/s\n", row, speed);
    else
      printf("shot %d: none\n", row);
  }
  free(parameters);
  free(inputs);
  free(outputs);
  return 0;
}
