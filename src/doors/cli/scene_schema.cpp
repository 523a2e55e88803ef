// The JSON Schema of scene files, generated from the table of keys: each key's row gives its type.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <vector>

#include "cli/documents.h"
#include "cli/option_texts.h"
#include "scene/scene_keys.h"
#include "text/json_text.h"
#include "text/units.h"

namespace poinsot {

namespace {

std::string text_members(const ValueType& type) {
    std::vector<std::string> quoted;
    for (const std::string& name : words_of(type)) quoted.push_back(json_string(name));
    if (quoted.empty()) return R"("type": "string")";
    return fmt::format(R"("enum": [{}])", fmt::join(quoted, ", "));
}

std::string bounds_members(const Bounds& bounds) {
    std::string members;
    if (bounds.least) members += fmt::format(R"(, "minimum": {})", bound_text(*bounds.least));
    if (bounds.without_least) members += R"(, "exclusiveMinimum": true)";
    if (bounds.most) members += fmt::format(R"(, "maximum": {})", bound_text(*bounds.most));
    return members;
}

// The schema members for a single value.
std::string value_members(const ValueType& type) {
    if (type.kind == ValueType::Kind::boolean) return R"("type": "boolean")";
    if (type.kind == ValueType::Kind::text) return text_members(type);
    if (type.kind == ValueType::Kind::integer)
        return R"("type": "integer")" + bounds_members(type.bounds);
    std::string number = R"("type": "number")" + bounds_members(type.bounds);
    // A string may hold a number with a unit, unless strings of this key mean something else.
    if (!unit_named(type.unit) || !type.or_text.empty()) return number;
    return fmt::format(R"("anyOf": [{{{}}}, {{"type": "string", "pattern": "[0-9].*[A-Za-z°]"}}])",
                       number);
}

std::string list_of(const std::string& items, const ValueType::Size& size) {
    std::string members = fmt::format(R"("type": "array", "items": {{{}}})", items);
    if (size.least > 0) members += fmt::format(R"(, "minItems": {})", size.least);
    if (size.most != ValueType::Size{}.most)
        members += fmt::format(R"(, "maxItems": {})", size.most);
    return members;
}

std::string members_of(const ValueType& type) {
    std::string members = value_members(type);
    if (type.size) members = list_of(members, *type.size);
    if (type.n_rows > 0) members = list_of(members, {type.n_rows, type.n_rows});
    if (!type.or_text.empty())
        members = fmt::format(R"("anyOf": [{{{}}}, {{"type": "string", "pattern": {}}}])", members,
                              json_string(type.or_pattern));
    if (type.or_boolean)
        members = fmt::format(R"("anyOf": [{{"type": "boolean"}}, {{{}}}])", members);
    if (!type.unit.empty()) members += fmt::format(R"(, "x-unit": {})", json_string(type.unit));
    return members;
}

// A table of the file with its contents, or a key.
struct Node {
    std::string name;
    const SceneKey* key = nullptr;
    bool is_array = false;
    std::vector<Node> below;
};

Node& node_below(Node& parent, std::string_view part) {
    const bool is_array = part.ends_with("[]");
    const std::string name(is_array ? part.substr(0, part.size() - 2) : part);
    for (Node& node : parent.below)
        if (node.name == name) return node;
    return parent.below.emplace_back(Node{name, nullptr, is_array, {}});
}

Node tree_of_keys() {
    Node root;
    for (const SceneKey& key : scene_keys()) {
        Node* at = &root;
        for (std::string_view path = key.path; !path.empty();) {
            const std::size_t end = std::min(path.find('.'), path.size());
            at = &node_below(*at, path.substr(0, end));
            path.remove_prefix(std::min(end + 1, path.size()));
        }
        at->key = &key;
    }
    return root;
}

// The TOML text of a default is also its JSON text.
std::string schema_of_key(const SceneKey& key) {
    const std::string_view initial = key.default_text();
    return fmt::format(R"({{"description": {}, {}{}{}}})", json_string(key.explanation()),
                       members_of(key.type), initial.empty() ? "" : R"(, "default": )", initial);
}

std::string members_of_table(const Node& table, const std::string& indent) {
    std::string text = indent + "\"type\": \"object\",\n" + indent +
                       "\"additionalProperties\": false,\n" + indent + "\"properties\": {\n";
    const std::string deeper = indent + "  ";
    for (std::size_t i = 0; i < table.below.size(); ++i) {
        const Node& node = table.below[i];
        text += fmt::format("{}{}: ", deeper, json_string(node.name));
        if (node.key != nullptr && !node.below.empty())
            text += fmt::format("{{\"anyOf\": [{}, {{\n{}\n{}}}]}}", schema_of_key(*node.key),
                                members_of_table(node, deeper + "  "), deeper);
        else if (node.key != nullptr)
            text += schema_of_key(*node.key);
        else if (node.is_array)
            text += fmt::format("{{\"type\": \"array\", \"items\": {{\n{}\n{}}}}}",
                                members_of_table(node, deeper + "  "), deeper);
        else
            text += fmt::format("{{\n{}\n{}}}", members_of_table(node, deeper + "  "), deeper);
        text += i + 1 < table.below.size() ? ",\n" : "\n";
    }
    return text + indent + "}";
}

}  // namespace

std::string scene_schema() {
    return fmt::format(
        "{{\n  \"$schema\": \"http://json-schema.org/draft-04/schema#\",\n"
        "  \"title\": \"poinsot scene\",\n  \"required\": [\"body\"],\n{}\n}}\n",
        members_of_table(tree_of_keys(), "  "));
}

}  // namespace poinsot
