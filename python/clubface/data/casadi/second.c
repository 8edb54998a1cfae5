/* Second derivatives: differences of fourth order of the first ones, made symmetric. */
CASADI_SYMBOL_EXPORT int jac_jac_${name}(const casadi_real **arg, casadi_real **res, casadi_int *iw, casadi_real *w,
                                         int mem) {
  static const double LEAST[${name}_WIDTH] = {$sizes}, PLACES[4] = {-2.0, -1.0, 1.0, 2.0};
  static const double WEIGHTS[4] = {1.0 / 12.0, -8.0 / 12.0, 8.0 / 12.0, -1.0 / 12.0};
  const int first = ${name}_HEIGHT * ${name}_WIDTH;
  double *second = res[0], x[${name}_WIDTH];
  (void)iw, (void)mem;
  if (!second) return 0;
  memset(second, 0, sizeof(double) * first * ${name}_WIDTH);
  for (int k = 0; k < ${name}_WIDTH; k++) {
    double size = fmax(fabs(arg[0] ? arg[0][k] : 0.0), LEAST[k]), step = $step * (size > 0.0 ? size : 1.0);
    for (int point = 0; point < 4; point++) {
      for (int j = 0; j < ${name}_WIDTH; j++) x[j] = arg[0] ? arg[0][j] : 0.0;
      x[k] += PLACES[point] * step;
      if (${name}_jacobian(x, w)) return 1;
      for (int i = 0; i < first; i++) second[k * first + i] += WEIGHTS[point] / step * w[i];
    }
  }
  for (int k = 0; k < ${name}_WIDTH; k++)
    for (int j = 0; j < k; j++)
      for (int i = 0; i < ${name}_HEIGHT; i++) {
        double *one = &second[k * first + j * ${name}_HEIGHT + i];
        double *other = &second[j * first + k * ${name}_HEIGHT + i];
        *one = *other = 0.5 * (*one + *other);
      }
  return 0;
}
CASADI_SYMBOL_EXPORT casadi_int jac_jac_${name}_n_in(void) { return 3; }
CASADI_SYMBOL_EXPORT casadi_int jac_jac_${name}_n_out(void) { return 2; }
CASADI_SYMBOL_EXPORT const casadi_int *jac_jac_${name}_sparsity_in(casadi_int i) {
  static const casadi_int empty[${name}_WIDTH + 3] = {${name}_HEIGHT, ${name}_WIDTH};
  return i == 2 ? empty : jac_${name}_sparsity_in(i);
}
CASADI_SYMBOL_EXPORT const casadi_int *jac_jac_${name}_sparsity_out(casadi_int i) {
  static const casadi_int dense[3] = {${name}_HEIGHT * ${name}_WIDTH, ${name}_WIDTH, 1};
  static const casadi_int empty[${name}_HEIGHT + 3] = {${name}_HEIGHT * ${name}_WIDTH, ${name}_HEIGHT};
  return i == 0 ? dense : i == 1 ? empty : NULL;
}
CASADI_SYMBOL_EXPORT int jac_jac_${name}_work(casadi_int *sz_arg, casadi_int *sz_res, casadi_int *sz_iw,
                                              casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 3;
  if (sz_res) *sz_res = 2;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = ${name}_HEIGHT * ${name}_WIDTH;
  return 0;
}
