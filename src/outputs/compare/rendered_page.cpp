#include "compare/rendered_page.h"

#include <fmt/format.h>
#include <unistd.h>

#include <string>
#include <system_error>
#include <vector>

#include "system/files/file_kind.h"
#include "system/run_program.h"
#include "text/printable.h"

namespace poinsot {

namespace {

constexpr std::string_view dots_per_inch = "300";

// A program that renders a page to PNG, and the package that contains it.
struct Rasteriser {
    std::vector<std::string> command;
    std::string_view package;
};

Rasteriser rasteriser_of(const std::filesystem::path& page, const std::filesystem::path& picture) {
    const std::string file = std::filesystem::absolute(page).string(), dpi(dots_per_inch);
    if (suffix_of(page) == ".pdf")
        return {{"pdftoppm", "-png", "-singlefile", "-r", dpi, file,
                 std::filesystem::path(picture).replace_extension().string()},
                "poppler-utils"};
    return {{"rsvg-convert", "--dpi-x", dpi, "--dpi-y", dpi, "-o", picture.string(), file},
            "librsvg2-bin"};
}

}  // namespace

bool is_vector_page_name(const std::filesystem::path& file) {
    return suffix_of(file) == ".pdf" || suffix_of(file) == ".svg";
}

RenderedPages::RenderedPages() {
    std::string name = (std::filesystem::temp_directory_path() / "poinsot-compare-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
        throw EnvironmentError(
            fmt::format("{}: cannot make a folder there",
                        printable(std::filesystem::temp_directory_path().string())));
    folder_ = name;
}

RenderedPages::~RenderedPages() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

std::filesystem::path RenderedPages::picture_of(const std::filesystem::path& page) {
    if (const FileKind kind = kind_of_file(page); kind != FileKind::regular)
        throw InputError(fmt::format("{}: {}", printable(page.string()), in_words(kind)));
    std::filesystem::path picture = folder_ / fmt::format("page{}.png", ++n_pages_);
    const Rasteriser rasteriser = rasteriser_of(page, picture);
    const ProgramOutcome outcome = run_program(rasteriser.command);
    const std::string& program = rasteriser.command.front();
    if (!outcome.found)
        throw NoRasteriser(
            fmt::format("cannot find {}, which draws {} for the comparison; install {}", program,
                        printable(page.string()), rasteriser.package));
    if (outcome.code != 0 || kind_of_file(picture) != FileKind::regular)
        throw InputError(fmt::format("{}: {} cannot read it: {}", printable(page.string()), program,
                                     printable(outcome.err.substr(0, outcome.err.find('\n')))));
    return picture;
}

}  // namespace poinsot
