/* Complex functions of Microsoft's C library, which NumPy and SciPy call and the Wine 8.0 of Debian 12 lacks: computed
 * by those of mingw for long double, since it takes the others from Microsoft. Here a long double is a double. */
#include <complex.h>

typedef struct { double re, im; } Double;
typedef struct { float re, im; } Float;

#define WIDE(z) __builtin_complex((long double)(z).re, (long double)(z).im)
#define EXPORTED(type, name) __declspec(dllexport) type wine_##name
#define FUNCTION(type, name, wide) \
    EXPORTED(type, name)(type z) { long double complex w = wide(WIDE(z)); return (type){creall(w), cimagl(w)}; }
#define POWER(type, name) \
    EXPORTED(type, name)(type z, type p) \
    { \
        long double complex w = cpowl(WIDE(z), WIDE(p)); \
        return (type){creall(w), cimagl(w)}; \
    }
#define REAL(type, part, name, wide) \
    EXPORTED(part, name)(type z) { return wide(WIDE(z)); }
#define FUNCTIONS(name) \
    FUNCTION(Double, name, name##l) FUNCTION(Double, name##l, name##l) FUNCTION(Float, name##f, name##l)
#define REALS(name) \
    REAL(Double, double, name, name##l) REAL(Double, double, name##l, name##l) REAL(Float, float, name##f, name##l)

FUNCTIONS(ccos) FUNCTIONS(ccosh) FUNCTIONS(csin) FUNCTIONS(csinh) FUNCTIONS(ctan) FUNCTIONS(ctanh) FUNCTIONS(catan)
FUNCTIONS(cexp) FUNCTIONS(clog) FUNCTIONS(csqrt)
POWER(Double, cpow) POWER(Double, cpowl) POWER(Float, cpowf)
REALS(cabs) REALS(carg) REALS(creal) REALS(cimag)
