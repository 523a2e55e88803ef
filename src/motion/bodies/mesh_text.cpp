#include "bodies/mesh_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <system_error>

#include "bodies/mesh_reader.h"
#include "error/error.h"
#include "text/numbers.h"
#include "text/printable.h"

namespace poinsot {

namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

// Length of a backslash and line end at the beginning of rest; 0 if there is none.
std::size_t continuation(std::string_view rest) {
    if (rest.starts_with("\\\n")) return 2;
    return rest.starts_with("\\\r\n") ? 3 : 0;
}

}  // namespace

std::string quoted(std::string_view word) {
    constexpr std::size_t longest = 40;
    return word.size() <= longest ? fmt::format("\"{}\"", printable(word))
                                  : fmt::format("\"{}…\"", printable(word.substr(0, longest)));
}

std::string_view MeshText::take_word() {
    const std::size_t begin = position_;
    while (position_ < text_.size() && !is_blank(text_[position_]) && text_[position_] != '\n' &&
           continuation(text_.substr(position_)) == 0) {
        ++position_;
    }
    return text_.substr(begin, position_ - begin);
}

std::string_view MeshText::word_in_line() {
    while (position_ < text_.size()) {
        if (const std::size_t n = continuation(text_.substr(position_)); n > 0) {
            position_ += n;
        } else if (is_blank(text_[position_])) {
            ++position_;
        } else {
            break;
        }
    }
    if (position_ == text_.size() || text_[position_] == '\n' || text_[position_] == '#') {
        return text_.substr(position_, 0);
    }
    return take_word();
}

bool MeshText::next_line() {
    // A backslash does not continue a comment: it ends with its line.
    while (!word_in_line().empty()) {
    }
    skip_line();
    return position_ < text_.size();
}

void MeshText::skip_line() {
    const std::size_t end = text_.find('\n', position_);
    position_ = end == std::string_view::npos ? text_.size() : end + 1;
}

std::string_view MeshText::word() {
    while (position_ < text_.size() && (is_blank(text_[position_]) || text_[position_] == '\n')) {
        ++position_;
    }
    const std::size_t begin = position_;
    while (position_ < text_.size() && !is_blank(text_[position_]) && text_[position_] != '\n') {
        ++position_;
    }
    return text_.substr(begin, position_ - begin);
}

void MeshText::refuse(std::string_view word, std::string_view what) const {
    const std::string_view before =
        text_.substr(0, static_cast<std::size_t>(word.data() - text_.data()));
    const auto line = std::ranges::count(before, '\n') + 1;
    const std::size_t line_end = before.rfind('\n');
    const std::string_view in_line =
        line_end == std::string_view::npos ? before : before.substr(line_end + 1);
    // Columns count characters: UTF-8 continuation bytes are not counted.
    const auto column =
        std::ranges::count_if(
            in_line, [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }) +
        1;
    throw InputError({std::string(name_), static_cast<int>(line), static_cast<int>(column)},
                     fmt::format("{}:{}:{}: {}", printable(name_), line, column, what));
}

double MeshText::coordinate(std::string_view word) const {
    // A plus sign is usual in these files, but not known to read_double.
    const std::string_view digits = without_plus(word);
    double value = 0.0;
    const char* const digits_end = digits.data() + digits.size();
    const auto [end, error] = read_double(digits, value);
    if (word.empty()) refuse(word, "a coordinate is missing; give three, in metres");
    if (error == std::errc::invalid_argument || end != digits_end) {
        refuse(word,
               fmt::format("{} is not a number; give the coordinate in metres", quoted(word)));
    }
    if (!(std::abs(value) <= largest_mesh_coordinate_m)) {
        refuse(word, fmt::format("{} is not a coordinate within ±{:.0e} m; scale the mesh",
                                 quoted(word), largest_mesh_coordinate_m));
    }
    return value;
}

}  // namespace poinsot
