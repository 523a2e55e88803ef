#include "web/pack/html_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <iterator>
#include <utility>

#include "image/zlib_stream.h"
#include "system/sha256.h"
#include "text/json_text.h"
#include "text/languages.h"
#include "text/markup.h"
#include "web/pack/compact_script.h"
#include "web/pack/page_parts.h"
#include "web/pack/page_scripts.h"

namespace poinsot {

namespace {

constexpr Phrase no_scripts{"Scripts are off, so you see a still picture.",
                            "Skripte sind ausgeschaltet; darum sehen Sie ein Standbild.",
                            "Les scripts sont désactivés ; vous voyez donc une image fixe.",
                            "Los scripts están desactivados; por eso ve una imagen fija.",
                            "Gli script sono disattivati: per questo si vede un’immagine fissa.",
                            "スクリプトが無効なため、静止画を表示しています。"};

const std::string& page_file(std::string_view name) {
    for (const PageFile& file : page_files())
        if (file.name == name) return file.text;
    assert(false && "every script is a file of web/page/");
    static const std::string none;
    return none;
}

std::string base64_of(std::string_view bytes) {
    return base64({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
}

// Nine bytes as eleven characters of ' ' to '~' without '<', zeros after the last byte: a twelfth
// shorter than base64, and safe in a script of HTML. web/page/unpack.js reads it.
std::string base94(std::string_view bytes) {
    constexpr std::size_t n_bytes = 9, n_digits = 11, n_high_bytes = 4;
    constexpr int low_bits = 40;
    std::string text;
    text.reserve(bytes.size() / n_bytes * n_digits + n_digits);
    for (std::size_t i = 0; i < bytes.size(); i += n_bytes) {
        std::uint64_t high = 0, low = 0;
        for (std::size_t j = 0; j < n_bytes; ++j) {
            std::uint64_t& part = j < n_high_bytes ? high : low;
            const bool is_there = i + j < bytes.size();
            part = part << 8 | (is_there ? static_cast<std::uint8_t>(bytes[i + j]) : 0u);
        }
        std::array<char, n_digits> digits{};
        for (std::size_t j = n_digits; j-- > 0;) {
            low |= high % 94 << low_bits;
            high /= 94;
            const auto digit = static_cast<char>(' ' + low % 94);
            digits[j] = static_cast<char>(digit < '<' ? digit : digit + 1);
            low /= 94;
        }
        text.append(digits.data(), n_digits);
    }
    return text;
}

// The source of a content policy that allows a text of this SHA-256: 'sha256-…' (W3C, CSP Level 3
// §2.3.1).
std::string hash_source_of(std::string_view digits) {
    std::vector<std::uint8_t> bytes;
    for (std::size_t i = 0; i + 1 < digits.size(); i += 2) {
        std::uint8_t byte = 0;
        std::from_chars(digits.data() + i, digits.data() + i + 2, byte, 16);
        bytes.push_back(byte);
    }
    return fmt::format("'sha256-{}'", base64(bytes));
}

std::string hash_source(std::string_view text) { return hash_source_of(sha256_of(text)); }

// A build without npm's packages makes pages without films.
bool makes_films() { return page_film_writer_sha256() != sha256_of(""); }

// Such a workbench edits in a plain text area.
bool has_text_editor() {
    return !page_text_editor_sha256().empty() && page_text_editor_sha256() != sha256_of("");
}

std::string list_of(const std::vector<std::string>& texts) {
    std::vector<std::string> strings;
    strings.reserve(texts.size());
    for (const std::string& text : texts) strings.push_back(script_string(text));
    return json_list(strings);
}

// The files as a JSON object, their bytes as base64.
std::string files_json(const std::map<std::string, std::string>& files) {
    std::string text;
    for (const auto& [name, bytes] : files)
        text += fmt::format("{}{}: \"{}\"", text.empty() ? "" : ", ", script_string(name),
                            base64_of(bytes));
    return "{" + text + "}";
}

// The texts of several scenes are in a block of their own, see scene_texts.
std::string scene_json(const PageContents& contents, bool has_text) {
    std::vector<std::string> following;
    following.reserve(contents.following.size());
    for (const PageContents& scene : contents.following)
        following.push_back(scene_json(scene, false));
    return JsonObject()
        .json("title", script_string(contents.title))
        .json("name", script_string(contents.scene_name))
        .json("text", script_string(has_text ? contents.scene_text : ""))
        .json("overrides", list_of(contents.overrides))
        .json("files", files_json(contents.files))
        .json("controls", list_of(contents.controls))
        .add("language", contents.language)
        .add("width", contents.width_px)
        .add("height", contents.height_px)
        .add("poster_at_s", contents.poster_at_s)
        .add("n_stops", contents.n_stops)
        .add("planned_s", contents.planned_s)
        .json("following", json_list(following))
        .line();
}

std::string picture_url(const std::vector<std::uint8_t>& png) {
    return png.empty() ? "" : "data:image/png;base64," + base64(png);
}

// The texts of a page of several scenes as a block, packed: a lecture has 70 kB of them. Nothing
// for a page of one scene.
std::string scene_texts(const PageContents& contents) {
    if (contents.following.empty()) return "";
    std::vector<std::string> texts{contents.scene_text};
    for (const PageContents& scene : contents.following) texts.push_back(scene.scene_text);
    const std::string list = list_of(texts);
    const std::vector<std::uint8_t> packed =
        zlib_stream({reinterpret_cast<const std::uint8_t*>(list.data()), list.size()});
    return fmt::format(
        "<script id=\"scene-texts\" type=\"application/zlib\" data-bytes=\"{}\">{}</script>\n",
        packed.size(), base94({reinterpret_cast<const char*>(packed.data()), packed.size()}));
}

using Values = std::vector<std::pair<std::string_view, std::string>>;

// The template with every {{name}} replaced, where there is a value; what replaces it is not looked
// at again.
std::string filled(std::string_view page, const Values& values) {
    std::string text;
    while (true) {
        const std::size_t open = page.find("{{");
        const std::size_t close = page.find("}}", open);
        text += page.substr(0, open);
        if (open == std::string_view::npos || close == std::string_view::npos) return text;
        const std::string_view name = page.substr(open + 2, close - open - 2);
        const auto value = std::find_if(values.begin(), values.end(),
                                        [name](const auto& known) { return known.first == name; });
        text += value != values.end() ? value->second : page.substr(open, close + 2 - open);
        page.remove_prefix(close + 2);
    }
}

std::string joined(const std::vector<std::string>& names) {
    return joined_scripts(names, page_file);
}

const PageScripts& scripts() {
    static const PageScripts it = page_scripts(page_file);
    return it;
}

// What the scripts and styles fill in; `allowed`: the hash sources of further scripts.
Values program_values(std::string script, std::string style, const std::string& allowed = "") {
    return {{"version", POINSOT_VERSION},
            {"script-hash",
             hash_source(script) + " " + hash_source(joined(scripts().packed)) +
                 (makes_films() ? " " + hash_source_of(page_film_writer_sha256()) : "") + allowed},
            {"style-hash", hash_source(style)},
            {"script", std::move(script)},
            {"style", std::move(style)}};
}

// What the scene fills in.
Values scene_values(const PageContents& contents) {
    return {{"language", escaped_markup(contents.language)},
            {"ground", escaped_markup(contents.ground)},
            {"title", escaped_markup(contents.title)},
            {"poster", picture_url(contents.poster_png)},
            {"no-script", escaped_markup(phrase_in(contents.language, no_scripts))},
            {"scene", scene_json(contents, contents.following.empty())},
            {"fonts", base94(page_fonts_lzma())},
            {"module", base94(page_module_lzma())},
            {"page-scripts", base94(page_scripts_lzma())},
            {"film-writer", makes_films() ? base94(page_film_writer_lzma()) : ""}};
}

Values operator+(Values values, Values more) {
    values.insert(values.end(), std::make_move_iterator(more.begin()),
                  std::make_move_iterator(more.end()));
    return values;
}

// All values except the scene's.
Values page_values(std::string data = "") {
    return program_values(joined(scripts().plain), compact_script(page_file("page.css"))) +
           Values{{"body", "page"}, {"before", ""}, {"data", std::move(data)}};
}

}  // namespace

std::string html_page(const PageContents& contents) {
    return filled(page_file("index.html"),
                  page_values(scene_texts(contents)) + scene_values(contents));
}

namespace {

std::string scenes_json(const std::vector<GalleryScene>& scenes) {
    std::vector<std::string> rows;
    rows.reserve(scenes.size());
    for (const GalleryScene& scene : scenes)
        rows.push_back(JsonObject()
                           .json("name", script_string(scene.name))
                           .json("title", script_string(scene.title))
                           .json("text", script_string(scene.text))
                           .json("files", files_json(scene.files))
                           .add("thumbnail", picture_url(scene.thumbnail_png))
                           .line());
    return json_list(rows);
}

// The text editor, and whose work it is.
std::string text_editor_block() {
    if (!has_text_editor()) return "";
    return "<!-- text-editor is CodeMirror 6, Copyright (c) Marijn Haverbeke and others. MIT "
           "License: "
           "https://codemirror.net. The script begins with the notices of its packages. -->\n"
           "<script id=\"text-editor\" type=\"application/x-lzma\">" +
           base94(page_text_editor_lzma()) + "</script>\n";
}

}  // namespace

std::string html_workbench(const PageContents& first, const WorkbenchScenes& scenes,
                           std::string_view schema) {
    JsonObject no_script;
    for (const std::string_view language : languages())
        no_script.json(language, script_string(phrase_in(language, no_scripts)));
    // The workbench writes pages, too: their template, without a scene. The schema is a text in it,
    // for a description may hold any character.
    const std::string data =
        JsonObject()
            .json("schema", script_string(schema))
            .json("scenes", scenes_json(scenes.gallery))
            .json("starts", scenes_json(scenes.starts))
            .json("template", script_string(filled(page_file("index.html"), page_values())))
            .json("no_script", no_script.line())
            .line();
    const Values values =
        program_values(joined(scripts().plain) + joined(scripts().workbench),
                       compact_script(page_file("page.css") + page_file("workbench.css")),
                       has_text_editor() ? " " + hash_source_of(page_text_editor_sha256()) : "") +
        Values{{"body", "workbench"},
               {"before", page_file("workbench.html")},
               {"data", "<script id=\"workbench-data\" type=\"application/json\">" + data +
                            "</script>\n<script id=\"fit-module\" type=\"application/x-lzma\">" +
                            base94(page_fit_module_lzma()) + "</script>\n" + text_editor_block()}};
    return filled(page_file("index.html"), values + scene_values(first));
}

}  // namespace poinsot
