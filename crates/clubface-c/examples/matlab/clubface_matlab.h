/* The functions of clubface.h that loadlibrary of MATLAB can call, in the types that it knows: a result is a void *. */
#include <stddef.h>
#include <stdint.h>

uint32_t clubface_abi(void);
size_t clubface_count(uint32_t columns);
ptrdiff_t clubface_column(uint32_t columns, const char *name);
ptrdiff_t clubface_default_parameters(const char *model, double *parameters);
void clubface_default_flight(double *inputs);
void *clubface_launches(const char *model, const double *inputs, const double *parameters, size_t rows,
                        double tolerance, size_t threads, double *outputs);
void *clubface_sensitivity(const char *model, const double *inputs, const double *parameters, double tolerance,
                           double *outputs, double *jacobian);
void *clubface_flights(const double *inputs, size_t rows, size_t threads, double *outputs);
const char *clubface_error(const void *result);
const char *clubface_text(const void *result);
void clubface_free(void *result);
