#include <fmt/format.h>

#include <cstdint>

#include "scene/scene_error.h"
#include "text/utf8.h"

namespace poinsot {

std::string echo(std::string_view text) {
    constexpr std::size_t most_characters = 200;
    std::string safe;
    std::size_t n_characters = 0;
    while (!text.empty()) {
        if (++n_characters > most_characters) return safe + "…";
        const Utf8Character character = first_character(text);
        if (!character.valid) {
            safe += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[0]));
        } else if (is_control(character.code)) {
            safe += fmt::format("\\u{:04x}", static_cast<std::uint32_t>(character.code));
        } else {
            safe += text.substr(0, character.size);
        }
        text.remove_prefix(character.size);
    }
    return safe;
}

}  // namespace poinsot
