/* A flight into the wind: where the ball lands, its path, and what 100 rpm more of backspin are worth.
 *
 *     cc flight.c $(pkg-config --cflags --libs clubface) -lm -o flight
 */
#include <clubface.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double PI = 3.14159265358979323846;

static size_t place(ClubfaceColumns columns, const char *name) {
  ptrdiff_t found = clubface_column(columns, name);
  if (found < 0) {
    fprintf(stderr, "no column %s\n", name);
    exit(1);
  }
  return (size_t)found;
}

/* An array of a result by its name; ends the program if there is none. */
static const double *array(const ClubfaceResult *result, const char *name, size_t *length) {
  for (size_t i = 0; i < clubface_array_count(result); i++)
    if (!strcmp(clubface_array_name(result, i), name)) {
      ClubfaceKind kind;
      const void *numbers = clubface_array(result, i, length, &kind);
      if (kind == CLUBFACE_KIND_FLOAT64) return (const double *)numbers;
    }
  fprintf(stderr, "no array %s\n", name);
  exit(1);
}

int main(void) {
  size_t inputs_count = clubface_count(CLUBFACE_COLUMNS_FLIGHT_INPUTS);
  size_t outputs_count = clubface_count(CLUBFACE_COLUMNS_FLIGHT_OUTPUTS);
  double *inputs = (double *)calloc(inputs_count, sizeof(double));
  double *outputs = (double *)calloc(outputs_count, sizeof(double));
  double *jacobian = (double *)calloc(outputs_count * inputs_count, sizeof(double));

  /* Air, ground and ball as they are unless given; the launch, which has no default, is not a number until it is set. */
  clubface_default_flight(inputs);
  double speed = 70.0, launch = 12.0 * PI / 180.0, backspin = 2600.0 * PI / 30.0, sidespin = 300.0 * PI / 30.0;
  struct { const char *name; double value; } given[] = {
    {"velocity_x", speed * cos(launch)}, {"velocity_y", speed * sin(launch)}, {"velocity_z", 0.0},
    {"spin_x", 0.0}, {"spin_y", -sidespin}, {"spin_z", backspin},
    {"ball_mass", 0.0459}, {"ball_radius", 0.02134}, {"ball_inertia", 8.2e-6},
    {"wind_x", -5.0},
  };
  for (size_t i = 0; i < sizeof given / sizeof *given; i++)
    inputs[place(CLUBFACE_COLUMNS_FLIGHT_INPUTS, given[i].name)] = given[i].value;

  ClubfaceResult *result = clubface_flight_sensitivity(inputs, outputs, jacobian);
  if (clubface_error(result)) {
    fprintf(stderr, "%s\n", clubface_error(result));
    return 1;
  }
  clubface_free(result);
  size_t carry = place(CLUBFACE_COLUMNS_FLIGHT_OUTPUTS, "carry");
  size_t side = place(CLUBFACE_COLUMNS_FLIGHT_OUTPUTS, "side");
  double by_spin = jacobian[carry * inputs_count + place(CLUBFACE_COLUMNS_FLIGHT_INPUTS, "spin_z")];
  printf("carry %.6f m, side %.6f m\n", outputs[carry], outputs[side]);
  printf("100 rpm more backspin: %+.6f m\n", by_spin * 100.0 * PI / 30.0);

  size_t points, numbers;
  result = clubface_trajectory(inputs);
  if (clubface_error(result)) {
    fprintf(stderr, "%s\n", clubface_error(result));
    return 1;
  }
  const double *time = array(result, "time", &points), *position = array(result, "position", &numbers);
  double apex = 0.0;
  for (size_t i = 0; i < points; i++) apex = position[3 * i + 1] > apex ? position[3 * i + 1] : apex;
  printf("%.6f s in the air, apex near %.2f m\n", time[points - 1], apex);
  clubface_free(result);
  free(inputs);
  free(outputs);
  free(jacobian);
  return 0;
}
