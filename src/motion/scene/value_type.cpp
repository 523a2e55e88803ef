#include "scene/value_type.h"

#include <fmt/format.h>

#include <array>

namespace poinsot {

namespace {

// "pale", "dashed" or "omitted", with the quotes.
std::string choice_of(std::span<const std::string_view> names) {
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i > 0) text += i + 1 < names.size() ? ", " : " or ";
        text += fmt::format("\"{}\"", names[i]);
    }
    return text;
}

std::string_view noun(const ValueType& type) {
    switch (type.kind) {
        case ValueType::Kind::number:
            return "number";
        case ValueType::Kind::integer:
            return "integer";
        case ValueType::Kind::boolean:
            return "boolean";
        case ValueType::Kind::text:
            break;
    }
    return type.list.empty() ? "string" : "name";
}

// "positive numbers", "integers from 0 to 64", "names in `poinsot list views`".
std::string values(const ValueType& type, std::string_view ending) {
    const bool is_positive = type.bounds.least == 0.0 && type.bounds.without_least;
    return fmt::format("{}{}{}{}{}", is_positive ? "positive " : "", noun(type), ending,
                       is_positive ? "" : type.bounds.words(),
                       type.list.empty() ? "" : fmt::format(" in `poinsot list {}`", type.list));
}

std::string count(std::size_t n) {
    constexpr std::array<std::string_view, 5> words{"no", "one", "two", "three", "four"};
    return n < words.size() ? std::string(words[n]) : fmt::format("{}", n);
}

std::string list_words(const ValueType& type) {
    const ValueType::Size size = *type.size;
    const std::string items = values(type, "s");
    if (size.least == size.most) {
        const std::string rows = type.n_rows > 0 ? count(type.n_rows) + " rows of " : "";
        return fmt::format("{}{} {}{}{}", rows, count(size.least), items,
                           type.names_of_values.empty() ? "" : " ", type.names_of_values);
    }
    if (!type.names.empty()) return fmt::format("a list of {}", choice_of(type.names));
    const bool is_limited = size.most != ValueType::Size{}.most;
    return is_limited ? fmt::format("a list of {} to {} {}", size.least, size.most, items)
                      : fmt::format("a list of {}", items);
}

std::string value_words(const ValueType& type) {
    if (type.size) return list_words(type);
    if (type.kind == ValueType::Kind::boolean) return "true or false";
    if (!type.names.empty()) return choice_of(type.names);
    return (type.kind == ValueType::Kind::integer ? "an " : "a ") + values(type, "");
}

}  // namespace

std::string bound_text(double bound) {
    std::string text = fmt::format("{}", bound);
    // Powers of ten from 1e5 on as such; exponents without a leading zero.
    const std::size_t n_zeros = text.size() - 1;
    if (n_zeros >= 5 && text[0] == '1' && text.find_first_not_of('0', 1) == std::string::npos)
        return fmt::format("1e{}", n_zeros);
    if (const std::size_t zero = text.find("e-0"); zero != std::string::npos)
        text.erase(zero + 2, 1);
    return text;
}

std::string Bounds::words() const {
    if (least && most) return fmt::format(" from {} to {}", bound_text(*least), bound_text(*most));
    if (!least) return "";
    return fmt::format(" {} {}", without_least ? "greater than" : "of at least",
                       bound_text(*least));
}

std::string ValueType::words() const {
    return fmt::format("{}{}{}{}{}{}", or_boolean ? "true, false or " : "", value_words(*this),
                       unit.empty() ? "" : " in ", unit, or_text.empty() ? "" : " or ", or_text);
}

}  // namespace poinsot
