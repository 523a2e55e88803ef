// Reads a label character by character and knows the column of each; used by both parsers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "typeset/label_error.h"
#include "typeset/label_tree.h"

namespace poinsot {

constexpr int label_length_limit = 4096;  // characters
constexpr int label_nesting_limit = 32;   // nested groups, arguments and scripts

// A character for messages: the character itself if it is printable, with its code point if that
// helps.
std::string describe(char32_t character);

class LabelCursor {
 public:
    // throws: LabelError if the label is not valid UTF-8, contains control characters other than
    // line feed and tab, or is longer than label_length_limit.
    explicit LabelCursor(std::string_view utf8);

    bool at_end() const { return position_ == characters_.size(); }
    // The next character, or 0 at the end.
    char32_t peek(std::size_t ahead = 0) const {
        return position_ + ahead < characters_.size() ? characters_[position_ + ahead] : 0;
    }
    // The character `back` positions before the next one, or 0 before the start.
    char32_t previous(std::size_t back = 1) const {
        return position_ >= back ? characters_[position_ - back] : 0;
    }
    int column() const { return static_cast<int>(position_) + 1; }
    LabelCharacter take();
    void skip_spaces();
    // Reads the name after a backslash: letters, or one other character. throws: LabelError at the
    // end of the label.
    std::string take_command_name();

    // throws: LabelError "expected …, found …" at the next character.
    [[noreturn]] void fail_expected(const std::string& what) const;

    // Counts the nesting depth of the parser; throws LabelError beyond label_nesting_limit.
    class Nesting {
     public:
        explicit Nesting(LabelCursor& cursor);
        ~Nesting() { --cursor_.depth_; }
        Nesting(const Nesting&) = delete;
        Nesting& operator=(const Nesting&) = delete;

     private:
        LabelCursor& cursor_;
    };

 private:
    std::vector<char32_t> characters_;
    std::size_t position_ = 0;
    int depth_ = 0;
};

}  // namespace poinsot
