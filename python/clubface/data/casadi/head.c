/* $title, as functions for CasADi:
 *
 *     impact = casadi.external("impact", "./impact.so")   launch by delivery
 *     flight = casadi.external("flight", "./impact.so")   flight by velocity and spin
 *
 * made by clubface $version. This file belongs to you. Compile it with the C library of clubface:
 *
 *     cc -O2 -shared -fPIC impact.c $$(pkg-config --cflags --libs clubface) -o impact.so
 *
 * All values are in SI units and radians.
$tables
 */
#include <clubface.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#define INPUTS $inputs
#define OUTPUTS $outputs
#define FLIGHT_INPUTS $flight_inputs
#define FLIGHT_OUTPUTS $flight_outputs
#define PARAMETERS $parameters
#define TOLERANCE $tolerance

#ifndef casadi_real
#define casadi_real double
#endif
#ifndef casadi_int
#define casadi_int long long int
#endif
#ifndef CASADI_SYMBOL_EXPORT
#if defined(_WIN32) || defined(__CYGWIN__)
#define CASADI_SYMBOL_EXPORT __declspec(dllexport)
#else
#define CASADI_SYMBOL_EXPORT __attribute__((visibility("default")))
#endif
#endif

static const char MODEL[] = "$model";

/* Inputs of the impact in the order of clubface; what the delivery replaces is 0. */
static const double FIXED[INPUTS] = {
$fixed
};

static const double MODEL_PARAMETERS[PARAMETERS] = {
$parameter_values
};

/* Inputs of the flight: ball, launch (which is replaced), air, wind and ground. */
static const double FLIGHT_FIXED[FLIGHT_INPUTS] = {
$flight_fixed
};

/* Prints why a result failed, frees it, and returns whether it did. */
static int failed(ClubfaceResult *result) {
  const char *reason = clubface_error(result);
  const char *rejected = clubface_text(result);
  if (!reason && rejected[0] == '[' && rejected[1] != ']') reason = rejected;
  if (reason) fprintf(stderr, "clubface: %s\n", reason);
  clubface_free(result);
  return reason != NULL;
}

/* Whether the library has the columns that this file was written for. */
static int fits(void) {
  if (clubface_abi() == CLUBFACE_ABI && clubface_count(CLUBFACE_COLUMNS_INPUTS) == INPUTS &&
      clubface_count(CLUBFACE_COLUMNS_OUTPUTS) == OUTPUTS &&
      clubface_count(CLUBFACE_COLUMNS_FLIGHT_INPUTS) == FLIGHT_INPUTS &&
      clubface_count(CLUBFACE_COLUMNS_FLIGHT_OUTPUTS) == FLIGHT_OUTPUTS)
    return 1;
  fprintf(stderr, "clubface: this function was exported for another version of libclubface; export it again\n");
  return 0;
}
