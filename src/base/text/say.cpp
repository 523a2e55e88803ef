#include "text/say.h"

#include <cstdio>
#include <exception>
#include <string>

#include "text/printable.h"

namespace poinsot {

void say(std::string_view message) noexcept {
    if (message.ends_with('\n')) message.remove_suffix(1);
    if (message.empty()) return;
    try {
        std::string lines;
        while (true) {
            const std::size_t end = message.find('\n');
            lines += printable(message.substr(0, end), most_of_a_message) + "\n";
            if (end == std::string_view::npos) break;
            message.remove_prefix(end + 1);
        }
        std::fputs(lines.c_str(), stderr);
    } catch (const std::exception&) {
        // No memory is left to format the message.
        std::fputs("out of memory for a message\n", stderr);
    }
}

void say_over_line(std::string_view text) noexcept {
    std::fputc('\r', stderr);
    std::fwrite(text.data(), 1, text.size(), stderr);
    std::fputs("\x1b[K", stderr);
    std::fflush(stderr);
}

}  // namespace poinsot
