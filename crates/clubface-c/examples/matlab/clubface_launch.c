/* Launches and their derivatives for MATLAB and Octave.
 *
 *     values = clubface_launch(model, inputs, parameters, outputs)
 *     [values, jacobian] = clubface_launch(model, inputs, parameters, outputs, variables)
 *
 * inputs has a row a shot and the columns of clubface, parameters are those of the model, both as "clubface export
 * inputs" writes them; outputs and variables are cells of names. values has a row a shot and a column an output; jacobian
 * is shot by output by variable. All values are in SI units and radians. A shot that cannot be computed is NaN, with a
 * warning.
 *
 * It is compiled in MATLAB or Octave, where prefix is the folder that libclubface is installed in:
 *
 *     mex clubface_launch.c -I<prefix>/include -L<prefix>/lib -lclubface
 */
#include <clubface.h>
#include <mex.h>
#include <string.h>

#define LONGEST_NAME 64

/* Ends the call with a message. */
static void refuse(const char *message) { mexErrMsgIdAndTxt("clubface:input", "%s", message); }

/* Takes the result of a computation: ends the call where it failed, warns of shots that have no launch. */
static void take(ClubfaceResult *result) {
  char message[1024];
  const char *error = clubface_error(result);
  strncpy(message, error ? error : clubface_text(result), sizeof message - 1);
  message[sizeof message - 1] = '\0';
  clubface_free(result);
  if (error) refuse(message);
  if (strcmp(message, "[]")) mexWarnMsgIdAndTxt("clubface:shots", "%s", message);
}

/* Returns the places of the names in a cell among columns, counted from 0; MATLAB frees the memory. */
static size_t *places(const mxArray *names, ClubfaceColumns columns) {
  size_t count = mxGetNumberOfElements(names);
  size_t *found = (size_t *)mxCalloc(count + 1, sizeof(size_t));
  for (size_t i = 0; i < count; i++) {
    char name[LONGEST_NAME];
    const mxArray *cell = mxGetCell(names, i);
    if (!cell || mxGetString(cell, name, sizeof name)) refuse("names must be text");
    ptrdiff_t column = clubface_column(columns, name);
    if (column < 0)
      mexErrMsgIdAndTxt("clubface:input", "there is no %s '%s'",
                        columns == CLUBFACE_COLUMNS_OUTPUTS ? "output" : "input", name);
    found[i] = (size_t)column;
  }
  return found;
}

void mexFunction(int results_count, mxArray *results[], int count, const mxArray *given[]) {
  char model[LONGEST_NAME];
  if (clubface_abi() != CLUBFACE_ABI) refuse("compiled for another version of libclubface: compile it again");
  if (count != (results_count > 1 ? 5 : 4)) refuse("give model, inputs, parameters, outputs, and variables of derivatives");
  if (mxGetString(given[0], model, sizeof model)) refuse("model must be text");
  ptrdiff_t parameters_count = clubface_default_parameters(model, NULL);
  if (parameters_count < 0) refuse("the model is unknown; clubface_describe lists them");
  if (!mxIsDouble(given[1]) || mxGetN(given[1]) != clubface_count(CLUBFACE_COLUMNS_INPUTS))
    refuse("inputs must be numbers with as many columns as clubface has inputs");
  if (!mxIsDouble(given[2]) || mxGetNumberOfElements(given[2]) != (size_t)parameters_count)
    refuse("parameters must be as many numbers as the model has parameters");
  if (!mxIsCell(given[3]) || (results_count > 1 && !mxIsCell(given[4])))
    refuse("names must be in a cell: {'backspin'}");

  const double *inputs = mxGetPr(given[1]), *parameters = mxGetPr(given[2]);
  size_t rows = mxGetM(given[1]), width = mxGetNumberOfElements(given[3]);
  const size_t *outputs = places(given[3], CLUBFACE_COLUMNS_OUTPUTS);
  results[0] = mxCreateDoubleMatrix(rows, width, mxREAL);
  double *values = mxGetPr(results[0]);
  if (results_count < 2) {
    double *all = (double *)mxCalloc(rows * clubface_count(CLUBFACE_COLUMNS_OUTPUTS) + 1, sizeof(double));
    take(clubface_launches(model, inputs, parameters, rows, 0.0, 0, all));
    for (size_t i = 0; i < width; i++) memcpy(values + i * rows, all + outputs[i] * rows, rows * sizeof(double));
    return;
  }

  size_t depth = mxGetNumberOfElements(given[4]);
  const size_t *variables = places(given[4], CLUBFACE_COLUMNS_INPUTS);
  double *all = (double *)mxCalloc(rows * width * (1 + depth) + 1, sizeof(double));
  take(clubface_sensitivities(model, inputs, parameters, rows, outputs, width, variables, depth, 0.0, 0, all));
  const mwSize sizes[3] = {(mwSize)rows, (mwSize)width, (mwSize)depth};
  results[1] = mxCreateNumericArray(3, sizes, mxDOUBLE_CLASS, mxREAL);
  double *jacobian = mxGetPr(results[1]);
  for (size_t i = 0; i < width; i++) {
    const double *block = all + i * (1 + depth) * rows; /* the values of an output, then its derivatives */
    memcpy(values + i * rows, block, rows * sizeof(double));
    for (size_t j = 0; j < depth; j++)
      memcpy(jacobian + (j * width + i) * rows, block + (1 + j) * rows, rows * sizeof(double));
  }
}
