// The JSON Schema of scene files, generated from the table of keys: each key's row gives its type.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "cli/documents.h"
#include "cli/option_texts.h"
#include "drawing/type/overlay.h"
#include "scene/scene_keys.h"
#include "text/json_text.h"
#include "text/units.h"

namespace poinsot {

namespace {

// Removes `words` from the beginning of a phrase; returns whether they were there.
bool take(std::string_view& phrase, std::string_view words) {
    if (!phrase.starts_with(words)) return false;
    phrase.remove_prefix(words.size());
    return true;
}

std::string strings(const std::vector<std::string>& names) {
    if (names.empty()) return R"("type": "string")";
    std::vector<std::string> quoted;
    quoted.reserve(names.size());
    for (const std::string& name : names) quoted.push_back(json_string(name));
    return fmt::format(R"("enum": [{}])", fmt::join(quoted, ", "));
}

// The schema of a number; with a unit it may also be a string. `bounds`: further members.
std::string number(const std::string& bounds, bool has_unit) {
    std::string bare = R"("type": "number")" + bounds;
    if (!has_unit) return bare;
    return R"("anyOf": [{)" + bare + R"(}, {"type": "string", "pattern": "[0-9].*[A-Za-z°]"}])";
}

// Removes "from -90 to 90" from the end of a phrase and returns it as members.
std::string bounds_of(std::string_view& phrase) {
    constexpr std::string_view from = " from ", to = " to ";
    const std::size_t least = phrase.find(from);
    if (least == std::string_view::npos) return "";
    const std::string_view both = phrase.substr(least + from.size());
    phrase = phrase.substr(0, least);
    const std::size_t most = both.find(to);
    return fmt::format(R"(, "minimum": {}, "maximum": {})", both.substr(0, most),
                       both.substr(most + to.size()));
}

// The schema members for the type phrase of a row, such as "three rows of three numbers". An
// unknown phrase allows any value, and a test reports it.
std::string members_of(std::string_view phrase, const std::vector<std::string>& names,
                       bool has_unit) {
    if (phrase == "true or false") return R"("type": "boolean")";
    if (const std::size_t either = phrase.find(" or "); either != std::string_view::npos)
        return fmt::format(R"("anyOf": [{{{}}}, {{{}}}])",
                           members_of(phrase.substr(0, either), names, has_unit),
                           members_of(phrase.substr(either + 4), names, has_unit));
    if (phrase == "a string" || phrase == "a ratio in a string" || phrase == "strings")
        return strings(names);
    if (phrase == "a file's name") return R"("type": "string", "pattern": "\\.toml$")";
    const std::string bounds = bounds_of(phrase);
    if (phrase == "a number" || phrase == "numbers") return number(bounds, has_unit);
    if (phrase == "a positive number" || phrase == "positive numbers")
        return number(R"(, "minimum": 0, "exclusiveMinimum": true)", has_unit);
    if (phrase == "an integer" || phrase == "integers") return R"("type": "integer")" + bounds;
    if (take(phrase, "a list of "))
        return fmt::format(R"("type": "array", "items": {{{}}})",
                           members_of(phrase, names, has_unit));
    constexpr std::array<std::string_view, 7> counts{"",      "one ",  "two ", "three ",
                                                     "four ", "five ", "six "};
    for (std::size_t n = 1; n < counts.size(); ++n) {
        if (!take(phrase, counts[n])) continue;
        take(phrase, "rows of ");
        // "four numbers w, x, y, z" also names the numbers.
        const std::string_view item = phrase.starts_with("numbers ") ? "numbers" : phrase;
        return fmt::format(R"("type": "array", "items": {{{}}}, "minItems": {}, "maxItems": {})",
                           members_of(item, names, has_unit), n, n);
    }
    return "";
}

// The names that a key accepts: its own, or those of the list that its summary refers to.
std::vector<std::string> names_of(const SceneKey& key) {
    if (!key.names.empty()) return {key.names.begin(), key.names.end()};
    constexpr std::string_view sends = "see `poinsot list ";
    const std::size_t at = key.summary.find(sends);
    if (at == std::string_view::npos) return {};
    const std::string_view rest = key.summary.substr(at + sends.size());
    const std::string_view list = rest.substr(0, rest.find('`'));
    std::vector<std::string> names = words_of(list);
    // `show` also accepts the names of overlays.
    if (list == "elements")
        for (const OverlayName& overlay : overlays()) names.emplace_back(overlay.name);
    return names;
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

std::string schema_of_key(const SceneKey& key) {
    const std::string members =
        members_of(key.type, names_of(key), unit_named(key.unit).has_value());
    return fmt::format(
        R"({{"description": {}{}{}}})",
        json_string(fmt::format("{}{}{}; {}", key.type, key.unit.empty() ? "" : " in ", key.unit,
                                key.summary)),
        members.empty() ? "" : ", ", members);
}

std::string members_of_table(const Node& table, const std::string& indent) {
    std::string text = indent + "\"type\": \"object\",\n" + indent +
                       "\"additionalProperties\": false,\n" + indent + "\"properties\": {\n";
    const std::string deeper = indent + "  ";
    for (std::size_t i = 0; i < table.below.size(); ++i) {
        const Node& node = table.below[i];
        text += fmt::format("{}{}: ", deeper, json_string(node.name));
        if (node.key != nullptr)
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
