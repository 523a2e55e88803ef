// toml++'s only translation unit; built with NDEBUG, since its assertions abort on bad input.
#include "scene/toml_document.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <charconv>
#include <string>
#include <system_error>
#include <utility>

#include "scene/scene_error.h"

#if TOML_SHARED_LIB || !defined(NDEBUG)
#error "toml++ must be compiled in, without assertions: malformed scenes would abort the program"
#endif

namespace poinsot {

namespace {

SourceLocation location(const toml::source_region& region, const std::string& file_name) {
    return {file_name, static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
}

bool stands_before(const TomlEntry& a, const TomlEntry& b) {
    return std::pair(a.where.line, a.where.column) < std::pair(b.where.line, b.where.column);
}

TomlValue plain(const toml::node& node, const std::string& file_name) {
    TomlValue value;
    value.where = location(node.source(), file_name);
    if (const auto* boolean = node.as_boolean()) {
        value.type = TomlValue::Type::boolean;
        value.boolean = boolean->get();
    } else if (const auto* integer = node.as_integer()) {
        value.type = TomlValue::Type::integer;
        value.integer = integer->get();
        value.number = static_cast<double>(integer->get());
    } else if (const auto* number = node.as_floating_point()) {
        value.type = TomlValue::Type::number;
        value.number = number->get();
    } else if (const auto* text = node.as_string()) {
        value.type = TomlValue::Type::text;
        value.text = text->get();
    } else if (const auto* array = node.as_array()) {
        value.type = TomlValue::Type::array;
        for (const toml::node& item : *array) value.items.push_back(plain(item, file_name));
    } else if (const auto* table = node.as_table()) {
        value.type = TomlValue::Type::table;
        for (const auto& [key, item] : *table) {
            value.entries.push_back({std::string(key.str()), location(key.source(), file_name),
                                     plain(item, file_name)});
        }
        std::stable_sort(value.entries.begin(), value.entries.end(), stands_before);
    } else {
        value.type = TomlValue::Type::date;
    }
    return value;
}

}  // namespace

std::string_view name_of(TomlValue::Type type) {
    switch (type) {
        case TomlValue::Type::boolean:
            return "a boolean";
        case TomlValue::Type::integer:
            return "an integer";
        case TomlValue::Type::number:
            return "a number";
        case TomlValue::Type::text:
            return "a string";
        case TomlValue::Type::date:
            return "a date or time";
        case TomlValue::Type::array:
            return "an array";
        case TomlValue::Type::table:
            break;
    }
    return "a table";
}

TomlValue parse_toml(std::string_view text, const std::string& file_name) {
    refuse_hostile_bytes(text, {file_name, 1, 1});
    refuse_hostile_structure(text, {file_name, 1, 1});
    try {
        return plain(toml::parse(text), file_name);
    } catch (const toml::parse_error& error) {
        // "Error while parsing array: missing comma": the rest of the sentence is kept.
        std::string_view what = error.description();
        if (what.starts_with("Error while ")) what.remove_prefix(12);
        throw SceneError(location(error.source(), file_name),
                         fmt::format("not valid TOML: {}; correct this line", echo(what)));
    }
}

TomlValue parse_override_value(std::string_view text, const SourceLocation& where) {
    const std::string assignment = fmt::format("value = {}", text);
    refuse_hostile_bytes(assignment, {where.file, 0, 0});
    try {
        refuse_hostile_structure(assignment, {where.file, 0, 0});
        TomlValue root = plain(toml::parse(assignment), where.file);
        if (root.entries.size() == 1) return std::move(root.entries[0].value);
    } catch (const SceneError&) {
        // Text, such as title=ωt.
    } catch (const toml::parse_error&) {
        // A bare word, such as draft or 1920x1080, or a number that TOML writes differently: .5
    }
    TomlValue value;
    const auto [end, failed] =
        std::from_chars(text.data(), text.data() + text.size(), value.number);
    const bool number = failed == std::errc{} && end == text.data() + text.size();
    value.type = number ? TomlValue::Type::number : TomlValue::Type::text;
    value.text = text;
    return value;
}

}  // namespace poinsot
