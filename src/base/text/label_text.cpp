#include "text/label_text.h"

#include "text/utf8.h"

namespace poinsot {

std::string as_caption(std::string_view text) {
    std::string caption;
    char32_t before = 0;
    while (!text.empty()) {
        const Utf8Character character = first_character(text);
        const char32_t code = character.valid ? character.code : 0xfffd;
        if (code == '\\') {
            caption += "$\\backslash$";
        } else if (code == '~') {
            caption += "$\\sim$";
        } else if (code < 0x80 && std::string_view("$%&#_{}").find(static_cast<char>(code)) !=
                                      std::string_view::npos) {
            caption += '\\';
            caption += static_cast<char>(code);
        } else if (code == '-' || code == '\'' || code == '`') {
            // Two such characters would become one dash or quotation mark, and a hyphen before a
            // digit a minus sign.
            const char next = text.size() > 1 ? text[1] : '\0';
            const bool number = code == '-' && (next == '.' || (next >= '0' && next <= '9'));
            caption += static_cast<char>(code);
            if (number || static_cast<char32_t>(next) == code) caption += "{}";
        } else if (code == ' ' && before == ' ') {
            caption += "\\ ";
        } else if (is_hidden(code)) {
            caption += utf8_of(0xfffd);
        } else {
            caption += utf8_of(code);
        }
        before = code;
        text.remove_prefix(character.size);
    }
    return caption;
}

}  // namespace poinsot
