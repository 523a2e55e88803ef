#include "web/pack/page_scripts.h"

#include <algorithm>

#include "web/pack/compact_script.h"

namespace poinsot {

namespace {

constexpr std::string_view import_word = "import ", export_word = "export ";

// The lines of a text, without their ends.
std::vector<std::string_view> lines_of(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        lines.push_back(text.substr(0, text.find('\n')));
        text.remove_prefix(std::min(lines.back().size() + 1, text.size()));
    }
    return lines;
}

// "words.js" of "import {Words} from './words.js';".
std::string imported_by(std::string_view line) {
    const std::size_t begin = line.find("'./") + 3;
    return std::string(line.substr(begin, line.rfind('\'') - begin));
}

bool is_in(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

// Adds the modules that a module imports, and then the module itself. A module is added once, so
// that modules which import each other end, too.
void add_module(const std::string& name, const TextOfScript& text_of,
                std::vector<std::string>& seen, std::vector<std::string>& order) {
    if (is_in(seen, name)) return;
    seen.push_back(name);
    const std::string text = text_of(name);
    for (const std::string_view line : lines_of(text))
        if (line.starts_with(import_word)) add_module(imported_by(line), text_of, seen, order);
    order.push_back(name);
}

}  // namespace

PageScripts page_scripts(const TextOfScript& text_of) {
    PageScripts scripts;
    std::vector<std::string> seen;
    add_module("start.js", text_of, seen, scripts.plain);
    add_module("scripting.js", text_of, seen, scripts.packed);
    add_module("workbench.js", text_of, seen, scripts.workbench);
    return scripts;
}

std::string joined_scripts(const std::vector<std::string>& names, const TextOfScript& text_of) {
    std::string joined;
    for (const std::string& name : names) {
        const std::string code = compact_script(text_of(name));
        for (std::string_view line : lines_of(code)) {
            if (line.starts_with(import_word)) continue;
            if (line.starts_with(export_word)) line.remove_prefix(export_word.size());
            joined.append(line).append("\n");
        }
    }
    return joined;
}

}  // namespace poinsot
