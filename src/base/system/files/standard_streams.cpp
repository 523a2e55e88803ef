#include "system/files/standard_streams.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "error/error.h"

namespace poinsot {

void occupy_closed_streams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (::fcntl(stream, F_GETFD) >= 0) continue;
        // A new descriptor is the lowest free one: this stream, since those below it are open.
        const int opened = ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
        if (opened >= 0 && opened != stream) {
            // Another thread has taken the stream in the meantime.
            ::close(opened);
        } else if (opened < 0) {
            throw EnvironmentError(std::string("cannot open /dev/null in place of a closed "
                                               "standard stream: ") +
                                   std::strerror(errno));
        }
    }
}

}  // namespace poinsot
