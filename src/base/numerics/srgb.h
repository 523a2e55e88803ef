// The transfer function of sRGB (IEC 61966-2-1): encoded values to linear light and back, both from
// 0 to 1.
#pragma once

namespace poinsot {

double linear_from_srgb(double encoded);
double srgb_from_linear(double light);

}  // namespace poinsot
