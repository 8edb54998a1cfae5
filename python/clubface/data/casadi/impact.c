static void set_impact(const double *delivery, double *inputs, double *parameters) {
  memcpy(inputs, FIXED, sizeof FIXED);
  memcpy(parameters, MODEL_PARAMETERS, sizeof MODEL_PARAMETERS);
  for (int i = 0; i < impact_WIDTH; i++) {
    double value = delivery ? delivery[i] : 0.0;
    if (impact_VARIABLES[i] < INPUTS)
      inputs[impact_VARIABLES[i]] = value;
    else
      parameters[impact_VARIABLES[i] - INPUTS] = value;
  }
}

CASADI_SYMBOL_EXPORT int impact(const casadi_real **arg, casadi_real **res, casadi_int *iw, casadi_real *w,
                                int mem) {
  double inputs[INPUTS], parameters[PARAMETERS], outputs[OUTPUTS];
  (void)iw, (void)w, (void)mem;
  if (!fits()) return 1;
  set_impact(arg[0], inputs, parameters);
  if (failed(clubface_launches(MODEL, inputs, parameters, 1, TOLERANCE, 1, outputs))) return 1;
  for (int i = 0; res[0] && i < impact_HEIGHT; i++) res[0][i] = outputs[impact_ROWS[i]];
  return 0;
}

/* Writes the derivatives by columns. */
static int impact_jacobian(const double *delivery, double *jacobian) {
  double inputs[INPUTS], parameters[PARAMETERS], values[impact_HEIGHT * (1 + impact_WIDTH)];
  if (!fits()) return 1;
  set_impact(delivery, inputs, parameters);
  if (failed(clubface_sensitivities(MODEL, inputs, parameters, 1, impact_ROWS, impact_HEIGHT, impact_VARIABLES,
                                    impact_WIDTH, TOLERANCE, 1, values)))
    return 1;
  for (int i = 0; i < impact_HEIGHT; i++)
    for (int j = 0; j < impact_WIDTH; j++) jacobian[j * impact_HEIGHT + i] = values[i * (1 + impact_WIDTH) + 1 + j];
  return 0;
}
