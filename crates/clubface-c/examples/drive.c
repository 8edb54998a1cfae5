/* A drive: launch, derivatives and flight.
 *
 *     cc drive.c $(pkg-config --cflags --libs clubface) -o drive
 */
#include <clubface.h>
#include <stdio.h>
#include <stdlib.h>

#define MODEL "response"
static const double DEGREE = 3.14159265358979323846 / 180.0;

static size_t place(ClubfaceColumns columns, const char *name) {
  ptrdiff_t found = clubface_column(columns, name);
  if (found < 0) {
    fprintf(stderr, "no column %s\n", name);
    exit(1);
  }
  return (size_t)found;
}

/* Frees a result; ends the program with the reason of one that failed. */
static void finish(ClubfaceResult *result) {
  const char *error = clubface_error(result);
  if (error) {
    fprintf(stderr, "%s\n", error);
    exit(1);
  }
  clubface_free(result);
}

int main(void) {
  if (clubface_abi() != CLUBFACE_ABI) {
    fprintf(stderr, "this program was compiled for another version of clubface\n");
    return 1;
  }
  /* A driver, a ball, and a delivery of 105 mph; what is not named is 0. */
  static const struct { const char *name; double value; } GIVEN[] = {
    {"speed", 46.9392},      {"attack", 0.03},        {"loft", 0.22},          {"toe", 0.005},
    {"club_mass", 0.2},      {"cg_x", 0.0354},        {"cg_y", 0.0035},        {"ixx", 2.5e-4},
    {"iyy", 4.7e-4},         {"izz", 2.7e-4},         {"static_loft", 0.17},   {"bulge", 0.305},
    {"roll", 0.305},         {"face_width", 0.11},    {"face_height", 0.058},  {"characteristic_time", 2.4e-4},
    {"hand", 1.0},           {"ball_mass", 0.0459},   {"ball_radius", 0.02134}, {"ball_inertia", 8.2e-6},
  };
  size_t inputs_count = clubface_count(CLUBFACE_COLUMNS_INPUTS);
  size_t outputs_count = clubface_count(CLUBFACE_COLUMNS_OUTPUTS);
  size_t parameters_count = (size_t)clubface_default_parameters(MODEL, NULL);
  size_t width = inputs_count + parameters_count;
  double *inputs = (double *)calloc(inputs_count, sizeof(double));
  double *outputs = (double *)calloc(outputs_count, sizeof(double));
  double *jacobian = (double *)calloc(outputs_count * width, sizeof(double));
  double *parameters = (double *)calloc(parameters_count, sizeof(double));
  clubface_default_parameters(MODEL, parameters);
  for (size_t i = 0; i < sizeof GIVEN / sizeof *GIVEN; i++)
    inputs[place(CLUBFACE_COLUMNS_INPUTS, GIVEN[i].name)] = GIVEN[i].value;

  finish(clubface_sensitivity(MODEL, inputs, parameters, 0.0, outputs, jacobian));
  size_t speed = place(CLUBFACE_COLUMNS_OUTPUTS, "ball_speed"), spin = place(CLUBFACE_COLUMNS_OUTPUTS, "backspin");
  size_t toe = place(CLUBFACE_COLUMNS_INPUTS, "toe");
  printf("ball speed %.2f m/s, backspin %.0f rpm\n", outputs[speed], outputs[spin] * 60 / (360 * DEGREE));
  printf("a millimetre more to the toe: %+.3f m/s\n", jacobian[speed * width + toe] * 1e-3);

  /* The ball flies as it was launched, in default air on a fairway. */
  static const char *const LAUNCH[] = {"ball_mass",  "ball_radius", "ball_inertia", "velocity_x", "velocity_y",
                                       "velocity_z", "spin_x",      "spin_y",       "spin_z"};
  double *flight = (double *)calloc(clubface_count(CLUBFACE_COLUMNS_FLIGHT_INPUTS), sizeof(double));
  double *flown = (double *)calloc(clubface_count(CLUBFACE_COLUMNS_FLIGHT_OUTPUTS), sizeof(double));
  clubface_default_flight(flight);
  for (size_t i = 0; i < sizeof LAUNCH / sizeof *LAUNCH; i++) {
    ptrdiff_t from = clubface_column(CLUBFACE_COLUMNS_OUTPUTS, LAUNCH[i]);
    size_t to = place(CLUBFACE_COLUMNS_FLIGHT_INPUTS, LAUNCH[i]);
    flight[to] = from >= 0 ? outputs[from] : inputs[place(CLUBFACE_COLUMNS_INPUTS, LAUNCH[i])];
  }
  finish(clubface_flights(flight, 1, 1, flown));
  printf("carry %.1f m, %.1f m to the right\n", flown[place(CLUBFACE_COLUMNS_FLIGHT_OUTPUTS, "carry")],
         flown[place(CLUBFACE_COLUMNS_FLIGHT_OUTPUTS, "side")]);

  /* An error says which input is at fault. */
  inputs[place(CLUBFACE_COLUMNS_INPUTS, "speed")] = -1.0;
  ClubfaceResult *refused = clubface_sensitivity(MODEL, inputs, parameters, 0.0, outputs, jacobian);
  printf("refused: %s\n", clubface_error(refused));
  clubface_free(refused);
  free(inputs);
  free(outputs);
  free(jacobian);
  free(parameters);
  free(flight);
  free(flown);
  return 0;
}
