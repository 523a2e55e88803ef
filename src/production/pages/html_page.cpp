#include "production/pages/html_page.h"

#include <fmt/format.h>

#include <array>
#include <cassert>
#include <charconv>
#include <span>
#include <utility>

#include "production/pages/page_parts.h"
#include "system/sha256.h"
#include "text/json_text.h"
#include "text/languages.h"
#include "text/markup.h"

namespace poinsot {

namespace {

// The scripts of a page, in the order in which they are joined.
constexpr std::array<std::string_view, 12> page_scripts{
    "words.js",    "film.js",  "link.js",   "loader.js", "program.js", "view.js",
    "controls.js", "notes.js", "figure.js", "bar.js",    "page.js",    "scripting.js"};

constexpr Phrase no_scripts{"Scripts are off, so you see a still picture.",
                            "Skripte sind ausgeschaltet; darum sehen Sie ein Standbild.",
                            "Les scripts sont désactivés ; vous voyez donc une image fixe.",
                            "Los scripts están desactivados; por eso ve una imagen fija.",
                            "Gli script sono disattivati: per questo si vede un’immagine fissa.",
                            "スクリプトが無効なため、静止画を表示しています。"};

const std::string& page_file(std::string_view name) {
    for (const PageFile& file : page_files())
        if (file.name == name) return file.text;
    assert(false && "every script is a file of page/");
    static const std::string none;
    return none;
}

std::string base64_of(std::string_view bytes) {
    return base64({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

// The source of a content policy that allows this text: 'sha256-…' (W3C, CSP Level 3 §2.3.1).
std::string hash_source(std::string_view text) {
    const std::string digits = sha256_of(text);
    std::vector<std::uint8_t> bytes;
    for (std::size_t i = 0; i + 1 < digits.size(); i += 2) {
        std::uint8_t byte = 0;
        std::from_chars(digits.data() + i, digits.data() + i + 2, byte, 16);
        bytes.push_back(byte);
    }
    return fmt::format("'sha256-{}'", base64(bytes));
}

std::string list_of(const std::vector<std::string>& texts) {
    std::vector<std::string> strings;
    for (const std::string& text : texts) strings.push_back(script_string(text));
    return json_list(strings);
}

std::string scene_json(const PageContents& contents) {
    std::string files;
    for (const auto& [name, bytes] : contents.files)
        files += fmt::format("{}{}: \"{}\"", files.empty() ? "" : ", ", script_string(name),
                             base64_of(bytes));
    return JsonObject()
        .json("name", script_string(contents.scene_name))
        .json("text", script_string(contents.scene_text))
        .json("overrides", list_of(contents.overrides))
        .json("files", "{" + files + "}")
        .json("controls", list_of(contents.controls))
        .add("language", contents.language)
        .add("width", contents.width_px)
        .add("height", contents.height_px)
        .add("poster_at_s", contents.poster_at_s)
        .line();
}

// The template with every {{name}} replaced; what replaces it is not looked at again.
std::string filled(std::string_view page,
                   std::span<const std::pair<std::string_view, std::string>> values) {
    std::string text;
    while (true) {
        const std::size_t open = page.find("{{");
        const std::size_t close = page.find("}}", open);
        text += page.substr(0, open);
        if (open == std::string_view::npos || close == std::string_view::npos) return text;
        const std::string_view name = page.substr(open + 2, close - open - 2);
        for (const auto& [known, value] : values)
            if (known == name) text += value;
        page.remove_prefix(close + 2);
    }
}

}  // namespace

std::string html_page(const PageContents& contents) {
    std::string script;
    for (const std::string_view name : page_scripts) script += page_file(name) + "\n";
    const std::string& style = page_file("page.css");
    const std::array<std::pair<std::string_view, std::string>, 13> values{{
        {"language", escaped_markup(contents.language)},
        {"ground", escaped_markup(contents.ground)},
        {"version", POINSOT_VERSION},
        {"title", escaped_markup(contents.title)},
        {"script-hash", hash_source(script)},
        {"style-hash", hash_source(style)},
        {"style", style},
        {"poster", "data:image/png;base64," + base64(contents.poster_png)},
        {"no-script", escaped_markup(phrase_in(contents.language, no_scripts))},
        {"scene", scene_json(contents)},
        {"fonts", base64_of(page_fonts_gzip())},
        {"module", base64_of(page_module_gzip())},
        {"script", script},
    }};
    return filled(page_file("index.html"), values);
}

}  // namespace poinsot
