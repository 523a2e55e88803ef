// accuracy_table [BODIES [NAME]]: prints the largest residuals of the exact free motion in every
// family of bodies, relative to an oracle with hundreds of digits, and of the heavy top in every
// family of tops (as many), relative to a Taylor integration; with NAME, only of families whose
// name contains it. Exit code 1 if one is out of bounds.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <future>
#include <string_view>
#include <thread>
#include <vector>

#include "mechanics/families.h"
#include "mechanics/top_families.h"

namespace {

// The heavy tops' part of the table; false if a family is out of bounds.
bool print_tops(int n_tops, int n_threads, std::string_view wanted) {
    namespace tops = poinsot::tops;
    fmt::print("\nworst residuals over {} heavy tops a family, four instants each\n", n_tops);
    fmt::print("{:<40}{:>10}{:>10}\n", "family", "omega", "attitude");
    bool good = true;
    for (const tops::Family& family : tops::all()) {
        if (std::string_view(family.name).find(wanted) == std::string_view::npos) continue;
        std::vector<std::future<tops::Residuals>> parts;
        for (int k = 0; k < n_threads; ++k) {
            parts.push_back(std::async(std::launch::async, [&family, n_tops, n_threads, k] {
                return tops::measure(family, n_tops * k / n_threads, n_tops * (k + 1) / n_threads);
            }));
        }
        tops::Residuals worst;
        for (auto& part : parts) {
            const tops::Residuals r = part.get();
            worst.omega = std::max(worst.omega, r.omega);
            worst.attitude = std::max(worst.attitude, r.attitude);
        }
        const bool ok =
            worst.omega <= tops::bounds.omega && worst.attitude <= tops::bounds.attitude;
        good = good && ok;
        fmt::print("{:<40}{:>10.2g}{:>10.2g}{}\n", family.name, worst.omega, worst.attitude,
                   ok ? "" : "  out of bounds");
        std::fflush(stdout);
    }
    fmt::print("bounds: omega {} of its norm, attitude {} by component of the quaternion\n",
               tops::bounds.omega, tops::bounds.attitude);
    return good;
}

// The free motions' part of the table; false if a family is out of bounds.
bool print_bodies(int n_bodies, int n_threads, std::string_view wanted) {
    using namespace poinsot::families;
    fmt::print("worst residuals over {} bodies a family, three or four instants each\n", n_bodies);
    fmt::print("{:<40}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}{:>8}\n", "family", "omega", "attitude",
               "herpolh.", "energy", "momentum", "|q| - 1", "finite");
    bool good = true;
    for (const Family& family : all()) {
        if (family.name.find(wanted) == std::string_view::npos) continue;
        std::vector<std::future<Residuals>> parts;
        for (int k = 0; k < n_threads; ++k) {
            const int first = static_cast<int>(static_cast<long long>(n_bodies) * k / n_threads);
            const int last =
                static_cast<int>(static_cast<long long>(n_bodies) * (k + 1) / n_threads);
            parts.push_back(std::async(std::launch::async, [&family, first, last] {
                return measure(family, first, last);
            }));
        }
        Residuals r;
        for (auto& part : parts) r = worse(r, part.get());
        const bool ok = within_bounds(family, r);
        good = good && ok;
        fmt::print("{:<40}{:>10.2g}{:>10.2g}{:>10.2g}{:>10.2g}{:>10.2g}{:>10.2g}{:>8}{}\n",
                   family.name, r.omega, r.attitude_rad, r.herpolhode, r.energy, r.momentum,
                   r.unit_quaternion, r.n_not_finite == 0 ? "all" : "NOT",
                   ok ? "" : "  out of bounds");
        std::fflush(stdout);
    }
    fmt::print("bounds: omega 2e-15 of its norm, attitude 2e-15 rad, herpolhode 3e-15 relative\n");
    return good;
}

}  // namespace

int main(int argc, char** argv) {
    const int n_bodies = argc > 1 ? std::atoi(argv[1]) : 10000;
    const std::string_view wanted = argc > 2 ? argv[2] : "";
    if (n_bodies < 1) {
        fmt::print(stderr, "accuracy_table: the number of bodies a family is at least 1\n");
        return 2;
    }
    const int n_threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    const bool bodies_good = print_bodies(n_bodies, n_threads, wanted);
    const bool tops_good = print_tops(n_bodies, n_threads, wanted);
    return bodies_good && tops_good ? 0 : 1;
}
