/* A thousand strikes over the face of a club, on all cores, as a table: toe and high (mm), ball speed (m/s), backspin
 * and sidespin (rpm). The club and its delivery come from a file that clubface writes:
 *
 *     clubface export inputs driver --speed "105 mph" --attack "2 deg" --model volumetric -o driver.csv
 *     cc batch.c $(pkg-config --cflags --libs clubface) -o batch
 *     ./batch volumetric driver.csv > strikes.csv
 */
#include <clubface.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define ROWS 1000
static const double RPM = 60.0 / (2.0 * 3.14159265358979323846);

static size_t place(ClubfaceColumns columns, const char *name) {
  ptrdiff_t found = clubface_column(columns, name);
  if (found < 0) {
    fprintf(stderr, "no column %s\n", name);
    exit(1);
  }
  return (size_t)found;
}

/* Reads lines "kind,name,value,unit": an input into all rows of its column, parameters one after another. */
static void read_shot(const char *path, double *inputs, double *parameters, ptrdiff_t parameters_count) {
  char line[256], kind[16], name[64];
  double value;
  ptrdiff_t parameter = 0;
  FILE *file = fopen(path, "r");
  if (!file) {
    fprintf(stderr, "%s cannot be read\n", path);
    exit(1);
  }
  while (fgets(line, sizeof line, file)) {
    if (sscanf(line, "%15[a-z],%63[a-z0-9_],%lf", kind, name, &value) != 3) continue; /* the heading */
    if (!strcmp(kind, "input")) {
      size_t column = place(CLUBFACE_COLUMNS_INPUTS, name);
      for (size_t row = 0; row < ROWS; row++) inputs[column * ROWS + row] = value;
    } else if (parameter < parameters_count) {
      parameters[parameter] = value;
      parameter++;
    }
  }
  fclose(file);
  if (parameter != parameters_count) {
    fprintf(stderr, "%s is of another model\n", path);
    exit(1);
  }
}

int main(int count, char **words) {
  if (count != 3) {
    fprintf(stderr, "usage: batch MODEL SHOT.csv\n");
    return 2;
  }
  const char *model = words[1];
  ptrdiff_t parameters_count = clubface_default_parameters(model, NULL);
  if (parameters_count < 0) {
    fprintf(stderr, "no model %s\n", model);
    return 1;
  }
  double *parameters = (double *)calloc((size_t)parameters_count + 1, sizeof(double));
  double *inputs = (double *)calloc(clubface_count(CLUBFACE_COLUMNS_INPUTS) * ROWS, sizeof(double));
  double *outputs = (double *)calloc(clubface_count(CLUBFACE_COLUMNS_OUTPUTS) * ROWS, sizeof(double));
  read_shot(words[2], inputs, parameters, parameters_count);

  /* 40 places from heel to toe, 25 from sole to crown; a column after another, a number for each row in it. */
  double *toe = inputs + place(CLUBFACE_COLUMNS_INPUTS, "toe") * ROWS;
  double *high = inputs + place(CLUBFACE_COLUMNS_INPUTS, "high") * ROWS;
  for (int row = 0; row < ROWS; row++) {
    toe[row] = -0.06 + 0.003 * (row % 40);
    high[row] = -0.024 + 0.002 * (row / 40);
  }

  ClubfaceResult *result = clubface_launches(model, inputs, parameters, ROWS, 0.0, 0, outputs);
  if (clubface_error(result)) { /* nothing was computed */
    fprintf(stderr, "%s\n", clubface_error(result));
    return 1;
  }
  const double *speed = outputs + place(CLUBFACE_COLUMNS_OUTPUTS, "ball_speed") * ROWS;
  const double *backspin = outputs + place(CLUBFACE_COLUMNS_OUTPUTS, "backspin") * ROWS;
  const double *sidespin = outputs + place(CLUBFACE_COLUMNS_OUTPUTS, "sidespin") * ROWS;
  int missed = 0;
  printf("toe,high,ball_speed,backspin,sidespin\n");
  for (int row = 0; row < ROWS; row++) {
    if (speed[row] != speed[row]) { /* not a number: this strike misses the face, the others stand */
      missed++;
      continue;
    }
    printf("%.1f,%.1f,%.9g,%.9g,%.9g\n", toe[row] * 1e3, high[row] * 1e3, speed[row], backspin[row] * RPM,
           sidespin[row] * RPM);
  }
  const char *rejected = clubface_text(result); /* JSON: row, input and message of each */
  fprintf(stderr, "%d of %d missed the face: %.70s...\n", missed, ROWS, rejected);
  clubface_free(result);
  free(parameters);
  free(inputs);
  free(outputs);
  return 0;
}
