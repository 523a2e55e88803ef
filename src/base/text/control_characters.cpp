#include "text/control_characters.h"

#include "text/utf8.h"

namespace poinsot {

bool has_control_characters(std::string_view text) {
    while (!text.empty()) {
        const Utf8Character character = first_character(text);
        if (character.valid && is_control(character.code)) return true;
        text.remove_prefix(character.size);
    }
    return false;
}

}  // namespace poinsot
