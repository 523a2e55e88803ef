// Any bytes as the manifest of a folder of baselines: it must read back equal after writing, or be
// refused with its line.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "compare/baseline_manifest.h"
#include "error/error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    try {
        const poinsot::BaselineManifest manifest = poinsot::parse_manifest(text, "manifest.toml");
        const std::string written = poinsot::to_text(manifest);
        if (poinsot::parse_manifest(written, "manifest.toml") != manifest) std::abort();
    } catch (const poinsot::InputError& error) {
        const std::string_view what = error.what();
        if (!what.starts_with("manifest.toml:") || what.find('\n') != std::string_view::npos)
            std::abort();
    }
    return 0;
}
