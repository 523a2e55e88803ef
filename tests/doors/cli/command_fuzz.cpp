// Any bytes as a command line, one argument per line: the line must be parsed, or refused with a
// short message. No command is run; values that commands parse later are parsed here, and a scene
// is changed by --set.
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include "cli/instants.h"
#include "cli/option_values.h"
#include "cli/program.h"
#include "cli/scenes.h"
#include "error/error.h"
#include "scene/files/load_scene.h"

namespace {

constexpr const char* a_scene =
    "[body]\nmoments_kg_m2 = [3.0, 2.0, 1.0]\n[start]\nomega_rad_s = [0.01, 2.0, 0.01]\n";

// Calls a function that may throw an InputError.
template <typename Call>
void refusable(const Call& call) {
    try {
        call();
    } catch (const poinsot::InputError& error) {
        if (std::string_view(error.what()).empty()) std::abort();
    }
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
    // Help is printed when it is requested.
    if (std::freopen("/dev/null", "w", stdout) == nullptr) std::abort();
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::vector<std::string> words{"poinsot"};
    std::string_view rest(reinterpret_cast<const char*>(data), size);
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        // The shell ends an argument at a zero byte.
        words.emplace_back(std::string(rest.substr(0, end)).c_str());
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    std::vector<const char*> arguments;
    for (const std::string& word : words) arguments.push_back(word.c_str());
    refusable(
        [&] { poinsot::read_command_line(static_cast<int>(arguments.size()), arguments.data()); });
    for (std::size_t k = 1; k < words.size(); ++k) {
        refusable([&] { poinsot::parse_frames(words[k]); });
        // "-" would read standard input.
        if (words[k] != "-") refusable([&] { poinsot::parse_times(words[k]); });
        refusable([&] { poinsot::parse_number("--time", words[k], "an instant"); });
        refusable([&] { poinsot::parse_whole("--depth", words[k], "8 or 16"); });
    }
    const std::vector<std::string> given(words.begin() + 1, words.end());
    refusable([&] { poinsot::parse_scene(a_scene, "fuzz.toml", poinsot::overrides_of(given)); });
    if (given.size() > 1)
        refusable([&] {
            poinsot::jobs_of({given.begin() + 1, given.end()}, given.front(),
                             poinsot::OutputKind::film);
        });
    return 0;
}
