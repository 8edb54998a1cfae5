CASADI_SYMBOL_EXPORT int jac_${name}(const casadi_real **arg, casadi_real **res, casadi_int *iw, casadi_real *w,
                                     int mem) {
  (void)iw, (void)w, (void)mem;
  return res[0] ? ${name}_jacobian(arg[0], res[0]) : 0;
}

/* Sizes, a pattern being {rows, columns, 1} where it is dense and {rows, 1, 0, 0} where it is empty. */
CASADI_SYMBOL_EXPORT casadi_int ${name}_n_in(void) { return 1; }
CASADI_SYMBOL_EXPORT casadi_int ${name}_n_out(void) { return 1; }
CASADI_SYMBOL_EXPORT const char *${name}_name_in(casadi_int i) { return i == 0 ? "$argument" : NULL; }
CASADI_SYMBOL_EXPORT const char *${name}_name_out(casadi_int i) { return i == 0 ? "$result" : NULL; }
CASADI_SYMBOL_EXPORT const casadi_int *${name}_sparsity_in(casadi_int i) {
  static const casadi_int dense[3] = {${name}_WIDTH, 1, 1};
  return i == 0 ? dense : NULL;
}
CASADI_SYMBOL_EXPORT const casadi_int *${name}_sparsity_out(casadi_int i) {
  static const casadi_int dense[3] = {${name}_HEIGHT, 1, 1};
  return i == 0 ? dense : NULL;
}
CASADI_SYMBOL_EXPORT int ${name}_work(casadi_int *sz_arg, casadi_int *sz_res, casadi_int *sz_iw,
                                      casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 1;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}

/* The Jacobian takes the $result as well, of which it makes no use. */
CASADI_SYMBOL_EXPORT casadi_int jac_${name}_n_in(void) { return 2; }
CASADI_SYMBOL_EXPORT casadi_int jac_${name}_n_out(void) { return 1; }
CASADI_SYMBOL_EXPORT const char *jac_${name}_name_in(casadi_int i) {
  return i == 0 ? "$argument" : i == 1 ? "out_$result" : NULL;
}
CASADI_SYMBOL_EXPORT const char *jac_${name}_name_out(casadi_int i) {
  return i == 0 ? "jac_${result}_$argument" : NULL;
}
CASADI_SYMBOL_EXPORT const casadi_int *jac_${name}_sparsity_in(casadi_int i) {
  static const casadi_int empty[4] = {${name}_HEIGHT, 1, 0, 0};
  return i == 0 ? ${name}_sparsity_in(0) : i == 1 ? empty : NULL;
}
CASADI_SYMBOL_EXPORT const casadi_int *jac_${name}_sparsity_out(casadi_int i) {
  static const casadi_int dense[3] = {${name}_HEIGHT, ${name}_WIDTH, 1};
  return i == 0 ? dense : NULL;
}
CASADI_SYMBOL_EXPORT int jac_${name}_work(casadi_int *sz_arg, casadi_int *sz_res, casadi_int *sz_iw,
                                          casadi_int *sz_w) {
  if (sz_arg) *sz_arg = 2;
  if (sz_res) *sz_res = 1;
  if (sz_iw) *sz_iw = 0;
  if (sz_w) *sz_w = 0;
  return 0;
}
