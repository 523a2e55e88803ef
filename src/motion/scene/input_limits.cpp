// Checks that refuse a text before it is parsed.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "scene/scene_error.h"
#include "scene/toml/toml_document.h"
#include "text/utf8.h"

namespace poinsot {

namespace {

constexpr int most_brackets = 16;
constexpr int most_key_parts = 16;

// Follows TOML's lexical structure far enough to tell brackets and dots from text in strings and
// comments. Where the scanner and a parser could disagree (a string that is not closed on its
// line), the parser stops with an error and parses nothing after it.
class StructureScanner {
 public:
    explicit StructureScanner(std::string_view text) : text_(text) {}

    // Called at each character that was not consumed; returns how many bytes to consume.
    std::size_t step(std::size_t at) {
        const char c = text_[at];
        if (c == '#') return to_line_end(at);
        if (c == '"' || c == '\'') return past_string(at);
        if (c == '[' || c == '{') ++depth_;
        if ((c == ']' || c == '}') && depth_ > 0) --depth_;
        if (c == '.') {
            ++n_dots_;
        } else if (c == '=' || c == ',' || c == '[' || c == '{' || c == '\n') {
            n_dots_ = 0;
        }
        return 1;
    }

    int depth() const { return depth_; }
    int n_dots() const { return n_dots_; }

 private:
    std::size_t to_line_end(std::size_t at) const {
        return std::min(text_.find('\n', at), text_.size()) - at;
    }

    std::size_t past_string(std::size_t at) const {
        const char quote = text_[at];
        const std::string triple(3, quote);
        const bool multiline = text_.substr(at, 3) == triple;
        std::size_t i = at + (multiline ? 3 : 1);
        for (; i < text_.size(); ++i) {
            if (quote == '"' && text_[i] == '\\') {
                ++i;
            } else if (multiline && text_.substr(i, 3) == triple) {
                // Up to two quotes may precede the closing three.
                i += 3;
                while (i < text_.size() && text_[i] == quote) ++i;
                return i - at;
            } else if (!multiline && text_[i] == quote) {
                return i + 1 - at;
            } else if (!multiline && text_[i] == '\n') {
                return i - at;
            }
        }
        return text_.size() - at;
    }

    std::string_view text_;
    int depth_ = 0;
    int n_dots_ = 0;
};

// The location after a character; only text from a file has locations.
void advance(SourceLocation& where, const Utf8Character& character) {
    if (where.line == 0) return;
    ++where.column;
    if (character.code == '\n') {
        ++where.line;
        where.column = 1;
    }
}

void refuse_bytes(std::string_view text, SourceLocation where) {
    for (std::size_t at = 0; at < text.size();) {
        const Utf8Character character = first_character(text.substr(at));
        if (!character.valid) {
            throw SceneError(where, fmt::format("byte 0x{:02x} is not UTF-8; save this text as "
                                                "UTF-8",
                                                static_cast<unsigned char>(text[at])));
        }
        const bool line_end =
            character.code == '\n' || (character.code == '\r' && text.substr(at, 2) == "\r\n");
        if (is_control(character.code) && !line_end && character.code != '\t') {
            throw SceneError(where, fmt::format("control character U+{:04X}; remove it",
                                                static_cast<std::uint32_t>(character.code)));
        }
        at += character.size;
        advance(where, character);
    }
}

// The location of a byte, computed only for messages.
SourceLocation location_of_byte(std::string_view text, std::size_t byte, SourceLocation where) {
    for (std::size_t at = 0; at < byte;) {
        const Utf8Character character = first_character(text.substr(at));
        at += character.size;
        advance(where, character);
    }
    return where;
}

// Outside strings and comments TOML is ASCII; some other characters cause undefined behaviour in
// toml++'s classification.
void refuse_unquoted(std::string_view text, std::size_t at, const SourceLocation& start) {
    if (static_cast<unsigned char>(text[at]) < 0x80) return;
    const Utf8Character character = first_character(text.substr(at));
    throw SceneError(location_of_byte(text, at, start),
                     fmt::format("\"{}\" stands outside of quotes; put text in quotes",
                                 printable(text.substr(at, character.size))));
}

}  // namespace

void refuse_hostile_bytes(std::string_view text, const SourceLocation& start) {
    if (text.size() > most_scene_bytes) {
        throw SceneError(
            {start.file, 0, 0},
            fmt::format("larger than {} MiB; a scene is a short text file, name that one",
                        most_scene_bytes >> 20));
    }
    refuse_bytes(text, start);
}

void refuse_hostile_structure(std::string_view text, const SourceLocation& start) {
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    StructureScanner scanner(text);
    for (std::size_t at = text.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
         at < text.size();) {
        refuse_unquoted(text, at, start);
        const std::size_t consumed = scanner.step(at);
        if (scanner.depth() > most_brackets) {
            throw SceneError(location_of_byte(text, at, start),
                             fmt::format("brackets nested more than {} deep; no key of a scene "
                                         "needs that, remove them",
                                         most_brackets));
        }
        if (scanner.n_dots() >= most_key_parts) {
            throw SceneError(location_of_byte(text, at, start),
                             fmt::format("a key of more than {} parts; no key of a scene has that "
                                         "many, shorten it",
                                         most_key_parts));
        }
        at += consumed;
    }
}

}  // namespace poinsot
