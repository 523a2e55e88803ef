// Work that may take long before drawing starts: messages meanwhile, and its end.
#pragma once

#include <limits>
#include <memory>
#include <string>

#include "production/session/task.h"

namespace poinsot {

// During its lifetime it reports the current work after one second and then every ten seconds.
// Ctrl-C ends the process at once, because no open file could be lost. A page in a browser, which
// has one thread, keeps only the time limit (src/doors/web/host/).
class SlowWorkNotice {
 public:
    // Throws EnvironmentError if Ctrl-C has come before.
    SlowWorkNotice(std::string what, const Task& task,
                   double limit_s = std::numeric_limits<double>::infinity());
    ~SlowWorkNotice();
    SlowWorkNotice(const SlowWorkNotice&) = delete;
    SlowWorkNotice& operator=(const SlowWorkNotice&) = delete;

    // How long all of it will take, once that is known.
    void expect(double estimate_s);
    // Whether the work has taken longer than the limit. Throws EnvironmentError where a host asks
    // to stop.
    bool is_over() const;

 private:
    struct Teller;
    std::unique_ptr<Teller> teller_;
};

}  // namespace poinsot
