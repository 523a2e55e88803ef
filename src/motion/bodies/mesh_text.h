// Tokenizer of text mesh files; its errors name line and column. Included only inside
// src/motion/bodies.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace poinsot {

// A cursor that returns words as views into the text, so that the position of each word is known.
class MeshText {
 public:
    // Skips a byte-order mark at the beginning.
    MeshText(std::string_view text, std::string_view name)
        : text_(text), name_(name), position_(text.starts_with("\xef\xbb\xbf") ? 3 : 0) {}

    // The next word of the line; empty at the end of the line and at a comment ("#"). A backslash
    // at the end of a line continues it.
    std::string_view word_in_line();

    // Moves to the next line; returns false at the end of the text.
    bool next_line();

    // The next word of the text on any line; empty at the end of the text.
    std::string_view word();

    // Skips the rest of the line.
    void skip_line();

    // Throws InputError "name:line:column: what" with the position of the word.
    [[noreturn]] void refuse(std::string_view word, std::string_view what) const;

    // Returns a coordinate in m; throws as refuse() does if the word is not a number, not finite or
    // beyond largest_mesh_coordinate_m.
    double coordinate(std::string_view word) const;

 private:
    std::string_view take_word();

    std::string_view text_;
    std::string_view name_;
    std::size_t position_;
};

// The word as a message may show it: printable, and truncated if long.
std::string quoted(std::string_view word);

}  // namespace poinsot
