#include "cli/progress_bar.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "text/printable.h"
#include "text/say.h"

namespace poinsot {

ProgressBar::ProgressBar(bool quiet) : quiet_(quiet), terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
    if (bar_open_) say(" ");
}

Task ProgressBar::task() {
    if (quiet_) return {};
    return {.say = [](const std::string& line) { say(line); },
            .begin = [this](const std::string& what, std::int64_t total) { begin(what, total); },
            .done = [this](std::int64_t done) { at(done); },
            .finish = [this](const std::string& made) { finish(made); }};
}

void ProgressBar::begin(const std::string& what, std::int64_t total) {
    what_ = what;
    total_ = total;
    last_shown_ = started_ = Clock::now();
}

void ProgressBar::at(std::int64_t done) {
    using namespace std::chrono_literals;
    if (total_ <= 0) return;

    // A terminal is updated ten times a second, a log every five seconds.
    const auto now = Clock::now();
    if (now - last_shown_ < (terminal_ ? Clock::duration(100ms) : Clock::duration(5s))) return;
    last_shown_ = now;

    const double elapsed_s = std::chrono::duration<double>(now - started_).count();
    const double rate = static_cast<double>(done) / std::max(elapsed_s, 1e-9);
    const double left_s = static_cast<double>(total_ - done) / std::max(rate, 1e-9);
    if (!terminal_) {
        say(fmt::format("{}: frame {} of {}, {:.1f} frames/s, {:.0f} s left", printable(what_),
                        done, total_, rate, left_s));
        return;
    }
    constexpr int width = 30;
    const int filled = static_cast<int>(width * done / total_);
    say_over_line(fmt::format(
        "{} [{}{}] {}/{}  {:.1f} frames/s  {:.0f} s left ", printable(what_, 40),
        std::string(static_cast<std::size_t>(filled), '#'),
        std::string(static_cast<std::size_t>(width - filled), '.'), done, total_, rate, left_s));
    bar_open_ = true;
}

void ProgressBar::finish(const std::string& made) {
    if (bar_open_) say_over_line("");
    bar_open_ = false;
    const double elapsed_s = std::chrono::duration<double>(Clock::now() - started_).count();
    say(fmt::format("{}: {} frame{} made in {:.2f} s", printable(made), total_,
                    total_ == 1 ? "" : "s", elapsed_s));
}

}  // namespace poinsot
