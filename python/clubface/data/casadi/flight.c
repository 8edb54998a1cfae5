static void set_flight(const double *launch, double *inputs) {
  memcpy(inputs, FLIGHT_FIXED, sizeof FLIGHT_FIXED);
  for (int i = 0; i < flight_WIDTH; i++) inputs[flight_VARIABLES[i]] = launch ? launch[i] : 0.0;
}

CASADI_SYMBOL_EXPORT int flight(const casadi_real **arg, casadi_real **res, casadi_int *iw, casadi_real *w,
                                int mem) {
  double inputs[FLIGHT_INPUTS], outputs[FLIGHT_OUTPUTS];
  (void)iw, (void)w, (void)mem;
  if (!fits()) return 1;
  set_flight(arg[0], inputs);
  if (failed(clubface_flights(inputs, 1, 1, outputs))) return 1;
  for (int i = 0; res[0] && i < flight_HEIGHT; i++) res[0][i] = outputs[flight_ROWS[i]];
  return 0;
}

static int flight_jacobian(const double *launch, double *jacobian) {
  double inputs[FLIGHT_INPUTS], outputs[FLIGHT_OUTPUTS], all[FLIGHT_OUTPUTS * FLIGHT_INPUTS];
  if (!fits()) return 1;
  set_flight(launch, inputs);
  if (failed(clubface_flight_sensitivity(inputs, outputs, all))) return 1;
  for (int i = 0; i < flight_HEIGHT; i++)
    for (int j = 0; j < flight_WIDTH; j++)
      jacobian[j * flight_HEIGHT + i] = all[flight_ROWS[i] * FLIGHT_INPUTS + flight_VARIABLES[j]];
  return 0;
}
