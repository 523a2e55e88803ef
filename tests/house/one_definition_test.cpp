// No two types of one name meet in one namespace: the linker would take either for both, without a
// word (ISO C++ [basic.def.odr]).
#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "places.h"

namespace {

namespace fs = std::filesystem;

// Comments, literals and preprocessor lines, each as one space.
std::string without_text(const std::string& source) {
    std::string code;
    const auto at = [&](std::size_t i) { return i < source.size() ? source[i] : '\0'; };
    bool line_begins = true;
    for (std::size_t i = 0; i < source.size();) {
        const char c = source[i];
        std::size_t end = i;
        if (c == '/' && at(i + 1) == '/') {
            end = source.find('\n', i);
        } else if (c == '/' && at(i + 1) == '*') {
            end = source.find("*/", i + 2) + 2;
        } else if (c == '#' && line_begins) {
            do end = source.find('\n', end + 1);
            while (end != std::string::npos && source[end - 1] == '\\');
        } else if (c == 'R' && at(i + 1) == '"') {
            const std::size_t open = source.find('(', i);
            const std::string mark = ")" + source.substr(i + 2, open - i - 2) + "\"";
            end = source.find(mark, open) + mark.size();
        } else if (c == '"' ||
                   (c == '\'' &&
                    (i == 0 || std::isalnum(static_cast<unsigned char>(source[i - 1])) == 0))) {
            for (end = i + 1; at(end) != c && end < source.size(); ++end)
                if (source[end] == '\\') ++end;
            ++end;
        }
        if (end == i) {
            line_begins = c == '\n' || (line_begins && (c == ' ' || c == '\t'));
            code += c;
            ++i;
        } else {
            code += ' ';
            i = std::min(end, source.size());
        }
    }
    return code;
}

std::vector<std::string> words_of(const std::string& code) {
    std::vector<std::string> words;
    const auto is_letter = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
    };
    for (std::size_t i = 0; i < code.size();) {
        std::size_t end = i;
        while (end < code.size() && is_letter(code[end])) ++end;
        if (end > i) {
            words.push_back(code.substr(i, end - i));
            i = end;
        } else {
            if (code.compare(i, 2, "::") == 0) {
                words.emplace_back("::");
                ++i;
            } else if (std::isspace(static_cast<unsigned char>(code[i])) == 0) {
                words.emplace_back(1, code[i]);
            }
            ++i;
        }
    }
    return words;
}

// The types that a file defines in named namespaces, "poinsot::Camera"; neither those within other
// types and functions nor those of unnamed namespaces, which other files do not see.
std::set<std::string> types_defined(const std::string& source) {
    const std::vector<std::string> words = words_of(without_text(source));
    const auto word = [&](std::size_t i) {
        return i < words.size() ? std::string_view(words[i]) : std::string_view();
    };
    std::set<std::string> found;
    std::vector<std::string> scopes;  // namespaces; "{" for whatever else is open
    const auto in_named_namespaces = [&] {
        for (const std::string& scope : scopes)
            if (scope == "{") return false;
        return true;
    };
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] == "}") {
            if (!scopes.empty()) scopes.pop_back();
        } else if (words[i] == "{") {
            scopes.emplace_back("{");
        } else if (words[i] == "namespace" && word(i - 1) != "using") {
            std::string name;
            while (word(i + 1) != "{" && word(i + 1) != "=" && i + 1 < words.size())
                name += words[++i];
            if (word(i + 1) != "{") continue;  // an alias
            scopes.push_back(name.empty() ? "{" : name);
            ++i;
        } else if (words[i] == "struct" || words[i] == "class" || words[i] == "union" ||
                   words[i] == "enum") {
            if (!in_named_namespaces()) continue;
            // A parameter of a template is declared so, too.
            if (word(i - 1) == "<" || word(i - 1) == ",") continue;
            std::size_t k = i + 1;
            if (word(k) == "struct" || word(k) == "class") ++k;
            while (word(k) == "[") {  // attributes
                while (word(k) != "]") ++k;
                while (word(k) == "]") ++k;
            }
            const std::string name(word(k));
            std::size_t after = k + 1;
            if (word(after) == "final") ++after;
            const bool defined = word(after) == "{" || word(after) == ":";
            if (defined && name != "{") {
                std::string qualified;
                for (const std::string& scope : scopes) qualified += scope + "::";
                found.insert(qualified + name);
            }
            // What follows up to the brace is read as usual.
            i = k;
        }
    }
    return found;
}

TEST(OneDefinition, FindsTypesOfNamedNamespacesAlone) {
    const std::string source = R"source(
        #define NOT struct Macro {
        // struct Comment {};
        namespace a::b { struct One { struct Inner {}; }; enum class Two : int { x };
        template <class T, class U = int> class Three final : public One {};
        struct Declared; Declared* of(struct Other* p);
        template <> struct Three<int> {};
        inline int f() { struct Local {}; return '{' + sizeof("struct Text {"); }
        namespace { struct Hidden {}; }
        namespace c { union Four { int i; }; } }
        struct [[nodiscard]] Five {};
    )source";
    EXPECT_EQ(types_defined(source), (std::set<std::string>{"a::b::One", "a::b::Two", "a::b::Three",
                                                            "a::b::c::Four", "Five"}));
}

TEST(OneDefinition, NoTwoFilesDefineTypesOfOneName) {
    std::map<std::string, std::vector<std::string>> files;  // of each type
    const fs::path src = poinsot::source_folder() / "src";
    for (const auto& entry : fs::recursive_directory_iterator(src)) {
        const std::string extension = entry.path().extension().string();
        if (extension != ".h" && extension != ".cpp") continue;
        std::ifstream file(entry.path());
        const std::string source{std::istreambuf_iterator<char>(file), {}};
        for (const std::string& type : types_defined(source))
            files[type].push_back(fs::relative(entry.path(), src).string());
    }
    EXPECT_GT(files.size(), 200u);
    for (const auto& [type, where] : files) {
        std::string list;
        for (const std::string& file : where) list += " src/" + file;
        EXPECT_EQ(where.size(), 1u) << type << " is defined in" << list
                                    << ": give one another name, or a namespace of its own";
    }
}

}  // namespace
