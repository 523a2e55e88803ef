#include "web/pack/page_scripts.h"

#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "web/pack/page_parts.h"

namespace poinsot {
namespace {

TextOfScript texts(const std::map<std::string, std::string>& files) {
    return [files](const std::string& name) { return files.at(name); };
}

std::string text_of_page(const std::string& name) {
    for (const PageFile& file : page_files())
        if (file.name == name) return file.text;
    ADD_FAILURE() << "there is no " << name;
    return "";
}

using Names = std::vector<std::string>;

TEST(PageScripts, StandAfterThoseThatTheyImport) {
    const PageScripts scripts =
        page_scripts(texts({{"start.js", "import {a} from './a.js';\na();\n"},
                            {"a.js", "// import {b} from './b.js';\nexport const a = 1;\n"},
                            {"scripting.js",
                             "import {c} from './c.js';\nimport {b} from "
                             "'./b.js';\nimport {a} from './a.js';\n"},
                            {"c.js", "import {b} from './b.js';\n"},
                            {"b.js", "import {c} from './c.js';\n"},
                            {"workbench.js", "import {c} from './c.js';\nimport './d.js';\n"},
                            {"d.js", ""}}));
    EXPECT_EQ(scripts.plain, (Names{"a.js", "start.js"}));
    EXPECT_EQ(scripts.packed, (Names{"b.js", "c.js", "scripting.js"}));
    EXPECT_EQ(scripts.workbench, (Names{"d.js", "workbench.js"}));
}

TEST(PageScripts, AreJoinedWithoutImportsAndExports) {
    EXPECT_EQ(joined_scripts({"b.js", "a.js"},
                             texts({{"a.js", "// a\nimport {b} from './b.js';\n\nf(b);\n"},
                                    {"b.js",
                                     "export const b = 'export ';\n  important = 1;\n"
                                     "export async function g() {}\n"}})),
              "const b = 'export ';\nimportant = 1;\nasync function g() {}\nf(b);\n");
}

// Each exactly once, each import before its use, and no name with two meanings once all are joined.
TEST(PageScripts, OfThePageCanBeJoined) {
    const PageScripts scripts = page_scripts(text_of_page);
    Names all = scripts.plain;
    for (const Names& more : {scripts.packed, scripts.workbench})
        all.insert(all.end(), more.begin(), more.end());
    const std::regex import("import (?:.* from )?'\\./(.*)';");
    const std::regex declaration("(?:async )?(?:function|class|const|let) (\\w+).*");
    std::set<std::string> joined, declared;
    for (const std::string& name : all) {
        EXPECT_TRUE(joined.insert(name).second) << name;
        std::istringstream text(text_of_page(name));
        for (std::string line; std::getline(text, line);) {
            std::smatch found;
            if (line.starts_with("import ")) {
                ASSERT_TRUE(std::regex_match(line, found, import)) << name << ": " << line;
                EXPECT_TRUE(joined.contains(found[1])) << name << " before " << found[1];
            }
            if (line.starts_with("export ")) line.erase(0, 7);
            if (!std::regex_match(line, found, declaration)) continue;
            EXPECT_TRUE(declared.insert(found[1]).second) << name << ": " << found[1];
        }
    }
    std::size_t n_scripts = 0;
    for (const PageFile& file : page_files()) n_scripts += file.name.ends_with(".js");
    EXPECT_EQ(all.size(), n_scripts);
    EXPECT_GT(declared.size(), 100u);
}

}  // namespace
}  // namespace poinsot
