// Work on many things at once, the results in their order.
#pragma once

#include <cstddef>
#include <functional>

namespace poinsot {

// Calls work(0) … work(n − 1), each once, on up to n_threads threads, the caller's among them;
// returns when all are done. Of the exceptions thrown that of the least index is thrown on, and no
// further work is begun then.
void in_parallel(std::size_t n, int n_threads, const std::function<void(std::size_t)>& work);

}  // namespace poinsot
