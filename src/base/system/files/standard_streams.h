// The standard streams of the process.
#pragma once

namespace poinsot {

// Opens /dev/null in place of standard input, output and error if they are closed. Otherwise the
// next file would get such a descriptor, and messages for standard error would go into this file.
// As before, reading the input, or writing to the others, fails. Throws EnvironmentError.
void occupy_closed_streams();

}  // namespace poinsot
