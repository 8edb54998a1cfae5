/* What a launch and its derivatives cost through the C interface: cost MODEL SHOT.csv SHOTS prints the shortest time
 * (ms) of a launch with all its outputs, of all their derivatives by nine variables, the mean ball speed and the mean
 * derivative of backspin by loft. The delivery of the shots runs from 98 to 102 % of that of the table. */
#define _POSIX_C_SOURCE 199309L
#include <clubface.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { VARIABLES = 9, LOFT = 3 };
static const char *const NAMES[VARIABLES] = {"speed", "attack", "path", "loft",   "face",
                                             "lie",   "toe",    "high", "closure"};

static double now(void) {
  struct timespec time;
  clock_gettime(CLOCK_MONOTONIC, &time);
  return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

static void finish(ClubfaceResult *result) {
  if (clubface_error(result)) {
    fprintf(stderr, "%s\n", clubface_error(result));
    exit(1);
  }
  clubface_free(result);
}

int main(int count, char **words) {
  if (count != 4) return 2;
  const char *model = words[1];
  size_t rows = (size_t)atoi(words[3]), inputs_count = clubface_count(CLUBFACE_COLUMNS_INPUTS);
  size_t outputs_count = clubface_count(CLUBFACE_COLUMNS_OUTPUTS), threads = rows > 1 ? 0 : 1;
  double *inputs = (double *)calloc(inputs_count * rows, sizeof(double));
  double *parameters = (double *)calloc((size_t)clubface_default_parameters(model, NULL), sizeof(double));
  double *outputs = (double *)calloc(outputs_count * rows, sizeof(double));
  double *values = (double *)calloc(outputs_count * (1 + VARIABLES) * rows, sizeof(double));
  size_t *wanted = (size_t *)calloc(outputs_count, sizeof(size_t)), variables[VARIABLES], parameter = 0;
  for (size_t i = 0; i < outputs_count; i++) wanted[i] = i;
  for (int i = 0; i < VARIABLES; i++) variables[i] = (size_t)clubface_column(CLUBFACE_COLUMNS_INPUTS, NAMES[i]);

  char line[256], kind[16], name[64];
  double value;
  FILE *file = fopen(words[2], "r");
  if (!file) return 1;
  while (fgets(line, sizeof line, file)) {
    if (sscanf(line, "%15[a-z],%63[a-z0-9_],%lf", kind, name, &value) != 3) continue;
    if (strcmp(kind, "input")) {
      parameters[parameter] = value;
      parameter++;
      continue;
    }
    int is_varied = 0;
    for (int i = 0; i < VARIABLES; i++) is_varied |= !strcmp(name, NAMES[i]);
    for (size_t row = 0; row < rows; row++)
      inputs[(size_t)clubface_column(CLUBFACE_COLUMNS_INPUTS, name) * rows + row] =
        value * (is_varied && rows > 1 ? 0.98 + 0.04 * (double)row / (double)(rows - 1) : 1.0);
  }
  fclose(file);

  double shortest[2] = {1e9, 1e9};
  for (int work = 0; work < 2; work++) {
    double begin = now();
    for (int run = 0; run < 6 || now() - begin < 0.5; run++) {
      double start = now();
      finish(work == 0 ? clubface_launches(model, inputs, parameters, rows, 0.0, threads, outputs)
                       : clubface_sensitivities(model, inputs, parameters, rows, wanted, outputs_count, variables,
                                                VARIABLES, 0.0, threads, values));
      double taken = now() - start;
      if (run > 0 && taken < shortest[work]) shortest[work] = taken;
    }
  }
  double speed = 0.0, slope = 0.0;
  size_t backspin = (size_t)clubface_column(CLUBFACE_COLUMNS_OUTPUTS, "backspin");
  for (size_t row = 0; row < rows; row++) {
    speed += outputs[(size_t)clubface_column(CLUBFACE_COLUMNS_OUTPUTS, "ball_speed") * rows + row] / (double)rows;
    slope += values[(backspin * (1 + VARIABLES) + 1 + LOFT) * rows + row] / (double)rows;
  }
  printf("%.9g %.9g %.9g %.9g\n", shortest[0] * 1e3, shortest[1] * 1e3, speed, slope);
  return 0;
}
