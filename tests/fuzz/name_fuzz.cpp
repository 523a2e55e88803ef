// Any bytes as the name of a scene, an output, a picture or a value: each script, list and document
// that holds it has the same lines, tags and commands as with a plain name, or the name is refused.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "compare/github_report.h"
#include "compare/junit.h"
#include "error/error.h"
#include "fuzz/scratch_file.h"
#include "production/cluster/submission.h"
#include "production/films/subtitles.h"
#include "production/slides/pptx_parts.h"
#include "production/vectors/latex_figure.h"
#include "system/files/file_contents.h"
#include "system/run_program.h"
#include "system/seal.h"
#include "text/printable.h"

namespace {

void demand(bool holds) {
    if (!holds) std::abort();
}

std::ptrdiff_t n_of(const std::string& text, char c) {
    return std::count(text.begin(), text.end(), c);
}

// As many tags, and no character that XML 1.0 does not allow.
void check_document(const std::string& text, const std::string& plain) {
    for (const char c : {'<', '>'}) demand(n_of(text, c) == n_of(plain, c));
    demand(std::all_of(text.begin(), text.end(), [](unsigned char c) {
        return c >= 0x20 || c == '\n' || c == '\t' || c == '\r';
    }));
}

std::string presentation_of(const std::string& name) {
    const poinsot::PptxText text{.title = name,
                                 .origin = {name, name, name, "0"},
                                 .language = "en",
                                 .width_px = 64,
                                 .height_px = 36,
                                 .slides = {{.title = name, .note = "", .film = "01.mp4"}}};
    std::string all;
    for (const poinsot::PptxPart& part : poinsot::pptx_parts(text)) all += part.xml + "\n";
    return all;
}

std::vector<poinsot::ComparedPicture> compared(const std::string& name) {
    poinsot::ComparedPicture picture;
    picture.name = name;
    picture.outcome = poinsot::Outcome::pixels;
    picture.reason = name;
    return {picture};
}

// Every line is a name and a command whose words are those that were given.
void check_lists(const std::filesystem::path& folder, const std::string& name) {
    std::istringstream lines(poinsot::read_text(folder / "tasks"));
    int n_lines = 0;
    for (std::string line; std::getline(lines, line); ++n_lines) {
        demand(n_of(line, '\t') == 1);
        const std::vector<std::string> words =
            poinsot::shell_words(line.substr(line.find('\t') + 1));
        demand(words.size() == 10 && words[2] == "/" + name + ".toml" && words[4] == name);
    }
    demand(n_lines == 1);
    demand(poinsot::status_of(folder).size() == 1);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace poinsot;
    const std::string name(reinterpret_cast<const char*>(data), size);
    const std::vector<FilmSubtitle> subtitles{{"It rolls.", 0, 1000, false}};
    const std::string file = std::filesystem::path(name + ".mp4").filename().string();
    const std::string captions = subtitles_text(file, subtitles);
    demand(n_of(captions, '\n') == n_of(subtitles_text("a.mp4", subtitles), '\n'));
    demand(captions.find("-->") == captions.rfind("-->") && is_sealed(captions));
    check_document(presentation_of(name), presentation_of("a"));
    check_document(junit_xml(name, compared(name)), junit_xml("a", compared("a")));
    demand(n_of(github_annotations(compared(name)), '\n') ==
           n_of(github_annotations(compared("a")), '\n'));

    const auto list_of = [](const std::string& listed) {
        return with_files("{\n  \"a\": 1\n}\n", std::vector<FileHash>{{listed, "0"}});
    };
    const std::string list = list_of(name);
    demand(is_sealed(list) && lists_name(list, name));
    demand(n_of(list, '\n') == n_of(list_of("a"), '\n'));

    // No name may hold NUL or a slash.
    if (name.find_first_of(std::string_view("\0/", 2)) != std::string::npos || size > 200) return 0;
    const std::filesystem::path folder = fuzz::scratch_folder() / "a.mp4.job";
    try {
        write_submission(folder,
                         {{.scene = "/" + name + ".toml",
                           .options = {"--set", name},
                           .output = "/tmp/" + name + ".mp4",
                           .n_frames = 10,
                           .scene_hash = ""}},
                         {}, 1);
        check_lists(folder, name);
    } catch (const InputError& error) {
        demand(printable(error.what(), any_length) == error.what());
    }
    std::filesystem::remove_all(folder);
    try {
        check_latex_place(fuzz::scratch_folder() / (name + ".pdf"));
        LatexGaps gaps;
        const std::string figure = latex_figure({}, {}, name + ".pdf", gaps);
        demand(n_of(figure, '\n') == n_of(latex_figure({}, {}, "a.pdf", gaps), '\n'));
        demand(n_of(figure, '{') == n_of(figure, '}'));
    } catch (const InputError&) {
        // Refused.
    } catch (const EnvironmentError&) {
        // Too long for the file system.
    }
    return 0;
}
