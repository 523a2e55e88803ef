#include "typeset/font_source.h"

#include <fmt/format.h>

#include "error/error.h"

namespace poinsot {

const std::array<std::string_view, 7>& font_names() {
    static constexpr std::array<std::string_view, 7> names{
        "latinmodern-math.otf", "lmsans10-regular.otf",  "lmsans10-bold.otf",
        "lmsans10-oblique.otf", "lmroman10-regular.otf", "lmroman10-bold.otf",
        "lmroman10-italic.otf"};
    return names;
}

FontFile no_font(std::string_view name) {
    throw EnvironmentError(fmt::format("the font {} was not given; give its bytes", name));
}

FontSource fonts_in_memory(std::span<const FontBytes> fonts) {
    FontSource source;
    source.open = [known = std::vector(fonts.begin(), fonts.end())](std::string_view name) {
        for (const FontBytes& font : known)
            if (font.name == name) return FontFile(font.bytes, font.name);
        no_font(name);
    };
    return source;
}

}  // namespace poinsot
