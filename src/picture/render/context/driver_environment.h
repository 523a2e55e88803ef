// The environment variables by which Mesa is debugged, which must not reach a picture.
#pragma once

namespace poinsot {

// Before the first context of Mesa's software renderer: removes from the environment what makes it
// crash or draw something else. What chooses another driver is refused, since it was meant.
// Throws EnvironmentError.
void prepare_driver_environment();

}  // namespace poinsot
