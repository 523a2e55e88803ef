// A page has one thread: long work is ended by looking at the clock now and then, without messages.
#include "production/session/slow_work_notice.h"

#include <ctime>

namespace poinsot {

namespace {

double now_s() {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

struct SlowWorkNotice::Teller {
    double end_s;
};

SlowWorkNotice::SlowWorkNotice(std::string, const Task&, double limit_s)
    : teller_(new Teller{now_s() + limit_s}) {}
SlowWorkNotice::~SlowWorkNotice() = default;
void SlowWorkNotice::expect(double) {}
bool SlowWorkNotice::is_over() const { return now_s() > teller_->end_s; }

}  // namespace poinsot
