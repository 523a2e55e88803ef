// The elementary functions, with the same digits on every processor. glibc selects a variant of
// sin, cos, exp, log, pow … by processor features, and the variants with fused multiply-add round
// differently. The definitions here replace glibc's in the program and in every library that it
// loads, including the encoders. SLEEF's "cinz" functions use no fused multiply-add and no dispatch
// by processor.
//
// Accuracy: 1.0 ulp of each function, over its whole range. Unlike glibc's, they do not set errno.
// Source: N. Shibata & F. Petrogalli, SLEEF: A Portable Vectorized Library of C Standard
// Mathematical Functions, IEEE Trans. Parallel Distrib. Syst. 31 (2020) 1316.
#include <sleef.h>

// <math.h> is not included: this file defines functions that it declares. Functions of which glibc
// has a single variant (cbrt, hypot, log10, all exactly rounded ones) remain glibc's.
extern "C" {

double sin(double x) noexcept { return Sleef_cinz_sind1_u10purec(x); }
double cos(double x) noexcept { return Sleef_cinz_cosd1_u10purec(x); }
double tan(double x) noexcept { return Sleef_cinz_tand1_u10purec(x); }
double asin(double x) noexcept { return Sleef_cinz_asind1_u10purec(x); }
double acos(double x) noexcept { return Sleef_cinz_acosd1_u10purec(x); }
double atan(double x) noexcept { return Sleef_cinz_atand1_u10purec(x); }
double atan2(double y, double x) noexcept { return Sleef_cinz_atan2d1_u10purec(y, x); }
double sinh(double x) noexcept { return Sleef_cinz_sinhd1_u10purec(x); }
double cosh(double x) noexcept { return Sleef_cinz_coshd1_u10purec(x); }
double tanh(double x) noexcept { return Sleef_cinz_tanhd1_u10purec(x); }
double asinh(double x) noexcept { return Sleef_cinz_asinhd1_u10purec(x); }
double acosh(double x) noexcept { return Sleef_cinz_acoshd1_u10purec(x); }
double atanh(double x) noexcept { return Sleef_cinz_atanhd1_u10purec(x); }
double exp(double x) noexcept { return Sleef_cinz_expd1_u10purec(x); }
double exp2(double x) noexcept { return Sleef_cinz_exp2d1_u10purec(x); }
double expm1(double x) noexcept { return Sleef_cinz_expm1d1_u10purec(x); }
double log(double x) noexcept { return Sleef_cinz_logd1_u10purec(x); }
double log2(double x) noexcept { return Sleef_cinz_log2d1_u10purec(x); }
double log1p(double x) noexcept { return Sleef_cinz_log1pd1_u10purec(x); }
double pow(double x, double y) noexcept { return Sleef_cinz_powd1_u10purec(x, y); }

// SLEEF's own sincos rounds differently from its sin and cos, and compilers may or may not merge
// two calls into sincos: so this one calls both.
void sincos(double x, double* sine, double* cosine) noexcept {
    *sine = sin(x);
    *cosine = cos(x);
}

float sinf(float x) noexcept { return Sleef_cinz_sinf1_u10purec(x); }
float cosf(float x) noexcept { return Sleef_cinz_cosf1_u10purec(x); }
float expf(float x) noexcept { return Sleef_cinz_expf1_u10purec(x); }
float exp2f(float x) noexcept { return Sleef_cinz_exp2f1_u10purec(x); }
float logf(float x) noexcept { return Sleef_cinz_logf1_u10purec(x); }
float log2f(float x) noexcept { return Sleef_cinz_log2f1_u10purec(x); }
float powf(float x, float y) noexcept { return Sleef_cinz_powf1_u10purec(x, y); }

void sincosf(float x, float* sine, float* cosine) noexcept {
    *sine = sinf(x);
    *cosine = cosf(x);
}
}
