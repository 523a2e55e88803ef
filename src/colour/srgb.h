// sRGB's encoded values and linear light, both from 0 to 1: the transfer function of IEC 61966-2-1.
#pragma once

namespace poinsot {

double linear_from_srgb(double encoded);
double srgb_from_linear(double light);

}  // namespace poinsot
