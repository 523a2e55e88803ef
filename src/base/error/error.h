// The errors that every layer may throw: the public header <poinsot/error.h>.
#pragma once

#include "error/poinsot/error.h"
