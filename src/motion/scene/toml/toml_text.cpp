#include "scene/toml/toml_text.h"

#include <fmt/format.h>

#include <cstdint>

#include "text/utf8.h"

namespace poinsot {

namespace {

template <typename Values>
std::string list(const Values& values) {
    std::string text = "[";
    for (const auto& value : values) {
        if (text.size() > 1) text += ", ";
        text += toml_text(value);
    }
    return text + "]";
}

}  // namespace

std::string toml_text(bool value) { return value ? "true" : "false"; }

std::string toml_text(int value) { return fmt::format("{}", value); }

std::string toml_text(double value) {
    std::string text = fmt::format("{}", value);
    if (text.find_first_of(".en") == std::string::npos) text += ".0";
    return text;
}

std::string toml_text(std::string_view value) {
    std::string text = "\"";
    while (!value.empty()) {
        const Utf8Character character = first_character(value);
        if (character.code == '"' || character.code == '\\') {
            text += '\\';
            text += value[0];
        } else if (character.code == '\n') {
            text += "\\n";
        } else if (character.code == '\t') {
            text += "\\t";
        } else if (character.valid && is_hidden(character.code)) {
            // Escaped, so that records can be read as text and stored in XML (SVG).
            const auto number = static_cast<std::uint32_t>(character.code);
            text += number < 0x10000 ? fmt::format("\\u{:04X}", number)
                                     : fmt::format("\\U{:08X}", number);
        } else {
            text += value.substr(0, character.size);
        }
        value.remove_prefix(character.size);
    }
    return text + "\"";
}

std::string toml_text(const Eigen::Vector3d& value) {
    return toml_text(std::span<const double>(value.data(), 3));
}

std::string toml_text(const Eigen::Vector4d& value) {
    return toml_text(std::span<const double>(value.data(), 4));
}

std::string toml_text(const Eigen::Matrix3d& value) {
    std::string text = "[";
    for (int i = 0; i < 3; ++i) {
        const Eigen::Vector3d row = value.row(i);
        text += (i > 0 ? ", " : "") + toml_text(row);
    }
    return text + "]";
}

std::string toml_text(std::span<const double> values) { return list(values); }
std::string toml_text(std::span<const std::string> values) { return list(values); }

}  // namespace poinsot
