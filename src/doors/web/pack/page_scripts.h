// Which scripts a page carries, and in which order. The files of web/page/ are modules that import
// each other; a page carries them joined, since modules inside one file cannot import each other.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace poinsot {

// The names of scripts, each after those that it imports.
struct PageScripts {
    std::vector<std::string> plain;      // as they are: what unpacks the others
    std::vector<std::string> packed;     // by LZMA
    std::vector<std::string> workbench;  // as they are: those that the workbench adds
};

using TextOfScript = std::function<std::string(const std::string& name)>;

// Follows the imports of start.js, scripting.js and workbench.js.
PageScripts page_scripts(const TextOfScript& text_of);

// The modules as one script without comments and indents. Precondition: an import statement is one
// line, no two modules give a name of their top level to different things, and what compact_script
// asks.
std::string joined_scripts(const std::vector<std::string>& names, const TextOfScript& text_of);

}  // namespace poinsot
