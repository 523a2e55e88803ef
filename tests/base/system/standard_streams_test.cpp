// A closed standard stream's descriptor is not given to a file.
#include "system/files/standard_streams.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>

namespace poinsot {
namespace {

// In a process of its own: closes the streams of these bits, and returns 0 if all is as it should
// be.
int after_closing(unsigned closed) {
    for (int stream = 0; stream < 3; ++stream)
        if ((closed >> stream & 1U) != 0) ::close(stream);
    occupy_closed_streams();
    for (int stream = 0; stream < 3; ++stream)
        if (::fcntl(stream, F_GETFD) < 0) return 1;
    if (::open("/dev/null", O_RDWR) <= STDERR_FILENO) return 2;
    // As with a closed descriptor, no byte is read or written.
    char byte = 'x';
    for (int stream = 0; stream < 3; ++stream) {
        if ((closed >> stream & 1U) == 0) continue;
        const ssize_t n =
            stream == STDIN_FILENO ? ::read(stream, &byte, 1) : ::write(stream, &byte, 1);
        if (n >= 0 || errno != EBADF) return 3;
    }
    return 0;
}

TEST(StandardStreams, AreOccupiedIfClosed) {
    for (unsigned closed = 0; closed < 8; ++closed)
        EXPECT_EXIT(std::_Exit(after_closing(closed)), testing::ExitedWithCode(0), "") << closed;
}

}  // namespace
}  // namespace poinsot
