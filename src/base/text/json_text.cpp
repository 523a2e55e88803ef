#include "text/json_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace poinsot {

std::string json_number(double value) {
    return std::isfinite(value) ? fmt::format("{}", value) : "null";
}

std::string json_list(std::span<const std::string> values) {
    return fmt::format("[{}]", fmt::join(values, ", "));
}

std::string json_lines(std::span<const std::string> values, int indent) {
    if (values.empty()) return "[]";
    const std::string before = "\n" + std::string(static_cast<std::size_t>(indent) + 2, ' ');
    return fmt::format("[{}{}\n{:{}}]", before, fmt::join(values, "," + before), "", indent);
}

JsonObject& JsonObject::json(std::string_view key, std::string_view value) {
    members_.push_back(fmt::format("{}: {}", json_string(key), value));
    return *this;
}

JsonObject& JsonObject::add(std::string_view key, std::string_view text) {
    return json(key, json_string(text));
}

std::string JsonObject::line() const { return fmt::format("{{{}}}", fmt::join(members_, ", ")); }

std::string JsonObject::lines() const {
    return fmt::format("{{\n  {}\n}}\n", fmt::join(members_, ",\n  "));
}

}  // namespace poinsot
