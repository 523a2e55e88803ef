#include "web/pack/html_page.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "places.h"
#include "system/faults.h"
#include "system/sha256.h"
#include "web/pack/compact_script.h"
#include "web/pack/page_job.h"
#include "web/pack/page_parts.h"
#include "web/pack/page_scripts.h"

namespace poinsot {

namespace {

const std::string hostile =
    "a </script><script>alert(1)</script> <!-- ]]> \xE2\x80\xA8 & \"quoted\"";

PageContents a_page() {
    PageContents contents;
    contents.scene_name = "a";
    contents.title = hostile;
    contents.language = "de";
    contents.scene_text = "title = '" + hostile + "'\n";
    contents.overrides = {"title=" + hostile};
    contents.files["</script>.obj"] = "v 0 0 0\n";
    contents.width_px = 640;
    contents.height_px = 360;
    contents.ground = "#ffffff";
    return contents;
}

// The text from after `begin` to before `end`.
std::string between(const std::string& text, const std::string& begin, const std::string& end) {
    const std::size_t from = text.find(begin) + begin.size();
    return text.substr(from, text.find(end, from) - from);
}

int n_of(const std::string& text, const std::string& part) {
    int n = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++n;
    return n;
}

std::string script_of(const std::string& page) {
    const std::size_t from = page.rfind("<script>") + 8;
    return page.substr(from, page.rfind("</script>") - from);
}

// The bytes of a hash in hexadecimal digits, as base64 (RFC 4648 §4), independent of base64().
std::string base64_of_digits(const std::string& digits) {
    constexpr char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bits;
    for (const char digit : digits) {
        const int value = digit <= '9' ? digit - '0' : digit - 'a' + 10;
        for (int bit = 3; bit >= 0; --bit) bits += (value >> bit) % 2 != 0 ? '1' : '0';
    }
    while (bits.size() % 6 != 0) bits += '0';
    std::string text;
    for (std::size_t i = 0; i < bits.size(); i += 6)
        text += letters[std::stoul(bits.substr(i, 6), nullptr, 2)];
    while (text.size() % 4 != 0) text += '=';
    return text;
}

TEST(HtmlPage, FillsEveryPlaceOfItsTemplate) {
    const std::string page = html_page(a_page());
    int n_places = 0;
    for (const PageFile& file : page_files()) {
        if (file.name != "index.html") continue;
        for (std::size_t at = file.text.find("{{"); at != std::string::npos;
             at = file.text.find("{{", at + 1)) {
            ++n_places;
            const std::string place = file.text.substr(at, file.text.find("}}", at) + 2 - at);
            EXPECT_EQ(page.find(place), std::string::npos) << place;
        }
    }
    EXPECT_GT(n_places, 10);
}

TEST(HtmlPage, TextOfASceneStaysText) {
    const std::string page = html_page(a_page());
    // The scripts of the page itself, and no other.
    EXPECT_EQ(n_of(page, "<script"), 6);
    EXPECT_EQ(n_of(page, "</script>"), 6);
    EXPECT_EQ(page.find("<script>alert"), std::string::npos);
    const std::string scene =
        between(page, "id=\"scene-data\" type=\"application/json\">", "</script>");
    EXPECT_EQ(scene.find('<'), std::string::npos);
    EXPECT_EQ(scene.find("\xE2\x80\xA8"), std::string::npos);
    EXPECT_NE(scene.find("alert(1)"), std::string::npos);
    EXPECT_EQ(between(page, "<title>", "</title>").find('<'), std::string::npos);
}

TEST(HtmlPage, HoldsTheScenesThatFollow) {
    PageContents contents = a_page();
    PageContents second = a_page();
    second.scene_name = "second";
    second.title = "Second </script>";
    second.scene_text = "# second";
    second.n_stops = 3;
    second.planned_s = 90.0;
    contents.following = {second};
    const std::string page = html_page(contents);
    EXPECT_EQ(n_of(page, "</script>"), n_of(html_page(a_page()), "</script>") + 1);
    const std::string scene =
        between(page, "id=\"scene-data\" type=\"application/json\">", "</script>");
    const std::string following = scene.substr(scene.find("\"following\": ["));
    // The texts are packed, in a block of their own.
    EXPECT_EQ(following.find("# second"), std::string::npos);
    EXPECT_NE(following.find("\"text\": \"\""), std::string::npos);
    EXPECT_NE(page.find("<script id=\"scene-texts\""), std::string::npos);
    EXPECT_NE(following.find("\"n_stops\": 3"), std::string::npos);
    EXPECT_NE(following.find("\"planned_s\": 90"), std::string::npos);
    EXPECT_LT(page.size(), html_page(a_page()).size() + 2000) << "one program for all scenes";
}

TEST(HtmlPage, AllowsItsOwnScriptsAndNoConnections) {
    const std::string page = html_page(a_page());
    const std::string policy = between(page, "Content-Security-Policy\" content=\"", "\"");
    EXPECT_NE(policy.find("default-src 'none'"), std::string::npos);
    EXPECT_EQ(policy.find("connect-src"), std::string::npos);
    EXPECT_EQ(policy.find("'unsafe-eval'"), std::string::npos);
    EXPECT_EQ(policy.find("'unsafe-inline'"), std::string::npos);
    const std::string style = between(page, "<style id=\"page-style\">", "</style>");
    for (const std::string& text : {script_of(page), style})
        EXPECT_NE(policy.find("'sha256-" + base64_of_digits(sha256_of(text)) + "'"),
                  std::string::npos);
    EXPECT_EQ(page.find("src=\"http"), std::string::npos);
    EXPECT_EQ(page.find("href=\"http"), std::string::npos);
}

// A picture inside the page, which its policy allows: the blue polhode on the ellipsoid and the
// orange herpolhode below it.
TEST(HtmlPage, HasAnIconOfItsOwn) {
    const std::string page = html_page(a_page());
    const std::string icon = between(page, "<link rel=\"icon\" href=\"", "\"");
    EXPECT_EQ(icon.rfind("data:image/svg+xml,%3Csvg ", 0), 0u);
    EXPECT_EQ(n_of(icon, "%3Cellipse "), 3);
    const std::string policy = between(page, "Content-Security-Policy\" content=\"", "\"");
    EXPECT_NE(policy.find("img-src data:"), std::string::npos);
}

std::string text_of(const std::string& name) {
    for (const PageFile& file : page_files())
        if (file.name == name) return file.text;
    ADD_FAILURE() << "there is no " << name;
    return "";
}

TEST(HtmlPage, CarriesEveryScriptOfThePage) {
    const std::string page = html_page(a_page());
    const std::string workbench = html_workbench(a_page(), {}, "{}");
    const PageScripts scripts = page_scripts(text_of);
    const auto is_in = [](const auto& list, const std::string& name) {
        return std::find(list.begin(), list.end(), name) != list.end();
    };
    for (const PageFile& file : page_files()) {
        if (!file.name.ends_with(".js") && !file.name.ends_with(".css")) continue;
        const bool is_script = file.name.ends_with(".js");
        const std::string code =
            is_script ? joined_scripts({file.name}, text_of) : compact_script(file.text);
        if (is_in(scripts.packed, file.name)) {
            EXPECT_EQ(workbench.find(code), std::string::npos) << file.name;
            continue;
        }
        const bool is_of_workbench =
            file.name == "workbench.css" || is_in(scripts.workbench, file.name);
        EXPECT_EQ(page.find(code) != std::string::npos, !is_of_workbench) << file.name;
        EXPECT_NE(workbench.find(code), std::string::npos) << file.name;
    }
}

// The policy allows a packed script by the hash of what web/page/unpack.js makes of it; the tests
// of the page in browsers run it.
TEST(HtmlPage, AllowsItsPackedScripts) {
    const std::string joined = joined_scripts(page_scripts(text_of).packed, text_of);
    const std::string page = html_page(a_page());
    const std::string policy = between(page, "Content-Security-Policy\" content=\"", "\"");
    EXPECT_NE(policy.find("'sha256-" + base64_of_digits(sha256_of(joined)) + "'"),
              std::string::npos);
}

// Without npm's packages, the program has none.
bool has_text_editor() {
    return !page_text_editor_sha256().empty() && page_text_editor_sha256() != sha256_of("");
}

// Pages that only show carry no editor, and their policy does not allow its script.
TEST(HtmlPage, TheWorkbenchAloneCarriesTheTextEditor) {
    const std::string page = html_page(a_page());
    const std::string workbench = html_workbench(a_page(), {}, "{}");
    const std::string block = "<script id=\"text-editor\"";
    const std::string hash =
        "'sha256-" + base64_of_digits(std::string(page_text_editor_sha256())) + "'";
    const bool has_editor = has_text_editor();
    EXPECT_EQ(page.find(block), std::string::npos);
    EXPECT_EQ(n_of(workbench, block), has_editor ? 1 : 0);
    EXPECT_EQ(workbench.find("unsafe-inline"), std::string::npos);
    EXPECT_EQ(n_of(workbench, "MIT License: https://codemirror.net"), has_editor ? 1 : 0);
    // The hash of an empty script is also that of a film writer which is not there either.
    if (!has_editor) return;
    const auto allows = [&hash](const std::string& html) {
        return between(html, "Content-Security-Policy\" content=\"", "\"").find(hash) !=
               std::string::npos;
    };
    EXPECT_FALSE(allows(page));
    EXPECT_TRUE(allows(workbench));
    // Nor does the template of the pages that the workbench writes.
    EXPECT_EQ(n_of(workbench, hash), 1);
}

TEST(HtmlPage, ScriptsLoseCommentsAndIndentsOnly) {
    EXPECT_EQ(compact_script("// a\n/**\n * b\n */\nf();\n\n  g();  // c\n"), "f();\ng();  // c\n");
    EXPECT_EQ(compact_script("/** @type {T} */ (x).y = /** @type {U} */ (z);"), "(x).y =  (z);\n");
    EXPECT_EQ(compact_script("/* a\n   b */\n.c {\n  d: e; /* f */\n}"), ".c {\nd: e; \n}\n");
    EXPECT_EQ(compact_script("accept = 'image/*,.obj'; /** a */ f('*/');"),
              "accept = 'image/*,.obj';  f('*/');\n");
    EXPECT_EQ(compact_script("f(); /** without an end"), "f(); \n");
    EXPECT_EQ(compact_script(""), "");
}

// What compact_script asks of the scripts: it would change a text that goes over lines.
TEST(HtmlPage, NoTextOfAScriptGoesOverLines) {
    for (const PageFile& file : page_files()) {
        if (!file.name.ends_with(".js")) continue;
        const std::string code = compact_script(file.text);
        for (std::size_t at = 0; at < code.size();) {
            const std::string line = code.substr(at, code.find('\n', at) - at);
            EXPECT_EQ(std::ranges::count(line, '`') % 2, 0) << file.name << ": " << line;
            at += line.size() + 1;
        }
    }
}

TEST(HtmlPage, ThePageOfEverySceneTakesAtMost1200000Bytes) {
    const TemporaryFolder folder;
    LazyRenderer renderer;
    int n_pages = 0;
    const bool has_module = !page_module_lzma().empty();
    for (const std::filesystem::path& file : supplied_scenes()) {
        SceneRequest request;
        request.file = file.string();
        const std::string page = folder / (file.stem().string() + ".html");
        if (has_module) {
            write_page(request, page, renderer, {});
            EXPECT_LE(std::filesystem::file_size(page), 1'200'000u) << file;
        } else {
            EXPECT_THROW(write_page(request, page, renderer, {}), EnvironmentError);
        }
        ++n_pages;
    }
    EXPECT_GT(n_pages, 30);
}

TEST(HtmlPage, TheWorkbenchCarriesTheTemplateOfAPage) {
    GalleryScene scene;
    scene.name = "b";
    scene.title = hostile;
    scene.text = hostile;
    const std::string workbench =
        html_workbench(a_page(), {{scene}, {scene}}, "{\"a\": \"</script>\"}");
    EXPECT_EQ(n_of(workbench, "</script>"), has_text_editor() ? 9 : 8);
    const std::string data =
        between(workbench, "id=\"workbench-data\" type=\"application/json\">", "</script>");
    EXPECT_EQ(data.find('<'), std::string::npos);
    // The template waits for a scene, and for nothing else of the program.
    for (const char* name : {"scene", "title", "module", "fonts", "poster", "language", "ground"})
        EXPECT_NE(data.find(std::string("{{") + name + "}}"), std::string::npos) << name;
    EXPECT_EQ(data.find("{{script"), std::string::npos);
}

}  // namespace

}  // namespace poinsot
