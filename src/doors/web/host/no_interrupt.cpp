// Stands in for system/interrupt.cpp: nothing interrupts what a page computes.
#include "system/interrupt.h"

namespace poinsot {

void stop_if_interrupted() {}

}  // namespace poinsot
