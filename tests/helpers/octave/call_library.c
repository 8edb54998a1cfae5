/* [result, arguments] = call_library(name, ...): calls a function of clubface_matlab.h; the arguments are copies that
 * it may have written to. A result of clubface is a number, its address. */
#include <clubface_matlab.h>
#include <mex.h>
#include <string.h>

static mxArray *arguments;
static int count;
static char text[128];

static mxArray *argument(int i) {
  if (i >= count) mexErrMsgTxt("too few arguments");
  return mxGetCell(arguments, i);
}

static double number(int i) {
  if (mxGetNumberOfElements(argument(i)) != 1) mexErrMsgTxt("a single number is needed");
  return mxGetScalar(argument(i));
}

static double *numbers(int i) {
  if (!mxIsDouble(argument(i))) mexErrMsgTxt("an array of double is needed");
  return mxGetPr(argument(i));
}

static const char *words(int i) {
  if (!mxIsChar(argument(i)) || mxGetString(argument(i), text, sizeof text)) mexErrMsgTxt("text is needed");
  return text;
}

static void *address(int i) { return (void *)(size_t)number(i); }

void mexFunction(int results_count, mxArray *results[], int given_count, const mxArray *given[]) {
  char name[64];
  (void)results_count;
  count = given_count - 1;
  mxGetString(given[0], name, sizeof name);
  arguments = mxCreateCellMatrix(1, (mwSize)count);
  for (int i = 0; i < count; i++) mxSetCell(arguments, i, mxDuplicateArray(given[i + 1]));
  double value = 0.0;
  const char *said = NULL;
  int wanted, is_text = 0;
  if (!strcmp(name, "clubface_count")) {
    wanted = 1;
    value = (double)clubface_count((uint32_t)number(0));
  } else if (!strcmp(name, "clubface_column")) {
    wanted = 2;
    value = (double)clubface_column((uint32_t)number(0), words(1));
  } else if (!strcmp(name, "clubface_default_flight")) {
    wanted = 1;
    clubface_default_flight(numbers(0));
  } else if (!strcmp(name, "clubface_sensitivity")) {
    wanted = 6;
    value = (double)(size_t)clubface_sensitivity(words(0), numbers(1), numbers(2), number(3), numbers(4), numbers(5));
  } else if (!strcmp(name, "clubface_flights")) {
    wanted = 4;
    value = (double)(size_t)clubface_flights(numbers(0), (size_t)number(1), (size_t)number(2), numbers(3));
  } else if (!strcmp(name, "clubface_error")) {
    wanted = is_text = 1;
    said = clubface_error(address(0));
  } else if (!strcmp(name, "clubface_free")) {
    wanted = 1;
    clubface_free(address(0));
  } else {
    mexErrMsgTxt("this function is not known here");
    return;
  }
  if (count != wanted) mexErrMsgTxt("too many arguments");
  results[0] = is_text ? mxCreateString(said ? said : "") : mxCreateDoubleScalar(value);
  results[1] = arguments;
}
