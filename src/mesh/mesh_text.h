// Words of a text mesh file, and refusals that say where in it they stand. Inside of src/mesh only.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace poinsot {

// A cursor that hands out words as views into the text, so that the place of each stays known.
class MeshText {
 public:
    // A byte-order mark at the beginning is passed over.
    MeshText(std::string_view text, std::string_view name)
        : text_(text), name_(name), position_(text.starts_with("\xef\xbb\xbf") ? 3 : 0) {}

    // Next word of the line; empty at its end and at a comment ("#"). A backslash at the end of a
    // line continues it.
    std::string_view word_in_line();

    // Past the end of the line; false at the end of the text.
    bool next_line();

    // Next word of the text, whatever its line; empty at the end of the text.
    std::string_view word();

    // The rest of the line is passed over, its words unread.
    void skip_line();

    // Throws InputError "name:line:column: what", the place being the word's.
    [[noreturn]] void refuse(std::string_view word, std::string_view what) const;

    // A coordinate in m; throws as refuse does if the word is no number, not finite or beyond
    // largest_mesh_coordinate_m.
    double coordinate(std::string_view word) const;

 private:
    std::string_view take_word();

    std::string_view text_;
    std::string_view name_;
    std::size_t position_;
};

// The word as it may stand in a message: printable, and cut if long.
std::string quoted(std::string_view word);

}  // namespace poinsot
