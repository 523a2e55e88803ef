// Any bytes as a compare.toml: it must be read, or be refused with its place in one line.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "compare/compare_file.h"
#include "error/error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    try {
        const poinsot::CompareFile file = poinsot::parse_compare_file(text, "compare.toml");
        for (const auto& entry : file.entries)
            if (!poinsot::matches_glob(entry.glob, "*")) std::abort();
        for (const poinsot::IgnoredRegion& region : file.given_limits_of("turn").ignore)
            if (region.rectangle) static_cast<void>(region.in(1280, 720));
    } catch (const poinsot::InputError& error) {
        const std::string_view what = error.what();
        if (!what.starts_with("compare.toml:") || what.find('\n') != std::string_view::npos)
            std::abort();
    }
    return 0;
}
