// Any bytes as a label and as a caption: they must be set, or refused with an InputError.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "typeset/files/installed_fonts.h"
#include "typeset/typesetter.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const poinsot::Typesetter typesetter(poinsot::installed_fonts());
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    poinsot::TypeStyle style;
    style.size_px = 12.0;
    for (const poinsot::TypeMode mode : {poinsot::TypeMode::math, poinsot::TypeMode::text}) {
        style.mode = mode;
        style.max_width_px = mode == poinsot::TypeMode::text ? 200.0 : 0.0;
        try {
            typesetter.set(text, style);
        } catch (const poinsot::InputError&) {
            // A bad label is refused with a message.
        }
    }
    return 0;
}
