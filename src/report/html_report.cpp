#include "report/html_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <vector>

#include "image/files/png_files.h"
#include "report/report_page.h"
#include "system/files/file_contents.h"
#include "system/files/processor.h"
#include "system/in_parallel.h"
#include "text/markup.h"

namespace poinsot {

namespace {

std::string data_uri(std::span<const std::uint8_t> png) {
    return "data:image/png;base64," + base64(png);
}

// The middle part of the picture "expected | difference × 16 | actual".
Image difference_alone(const StoredPicture& expected, const StoredPicture& actual) {
    const Image sheet = difference_picture(expected, actual);
    Image middle(sheet.width() / 3, sheet.height());
    for (int y = 0; y < middle.height(); ++y)
        for (int x = 0; x < middle.width(); ++x) middle.set(x, y, sheet.at(middle.width() + x, y));
    return middle;
}

std::string numbers_in_words(const ComparedPicture& picture) {
    const Comparison& m = picture.measured;
    if (m.n_pixels == 0 || picture.outcome == Outcome::same) return "";
    std::string words = fmt::format("{} of {} pixels, at most {:.3g} levels", m.n_differing,
                                    m.n_pixels, m.largest_difference);
    if (m.likeness)
        words += fmt::format("; FLIP {:.3g}, SSIM {:.5f}", m.likeness->flip, m.likeness->ssim);
    return words;
}

// One picture as an object in the page's data.
std::string object_of(const ComparedPicture& picture) {
    std::string object =
        fmt::format(R"({{"name":{},"outcome":{},"reason":{},"numbers":{})",
                    script_string(picture.name), script_string(name_of(picture.outcome)),
                    script_string(picture.reason), script_string(numbers_in_words(picture)));
    const auto add_file = [&object](const char* key, const std::filesystem::path& path) {
        if (!path.empty()) object += fmt::format(R"(,"{}":"{}")", key, data_uri(read_bytes(path)));
    };
    if (picture.outcome != Outcome::same) {
        add_file("expected", picture.expected);
        add_file("actual", picture.actual);
    }
    constexpr std::array measured{Outcome::size, Outcome::depth, Outcome::colours, Outcome::pixels,
                                  Outcome::within_limits};
    if (std::find(measured.begin(), measured.end(), picture.outcome) != measured.end()) {
        const Image difference =
            difference_alone(read_stored_png(picture.expected), read_stored_png(picture.actual));
        object += fmt::format(R"(,"difference":"{}")", data_uri(encode_png(difference)));
    }
    return object + "}";
}

// Replaces each @WORD@ of the template in one pass, so that inserted text is not searched.
std::string filled(std::string_view page, std::string_view title, std::string_view data) {
    std::string text;
    for (;;) {
        const std::size_t at = std::min(page.find("@TITLE@"), page.find("@DATA@"));
        text += page.substr(0, at);
        if (at == std::string_view::npos) return text;
        const bool is_title = page.substr(at).starts_with("@TITLE@");
        text += is_title ? title : data;
        page.remove_prefix(at + (is_title ? 7 : 6));
    }
}

}  // namespace

std::string html_report(const std::string& title, std::span<const ComparedPicture> pictures) {
    std::vector<std::string> objects(pictures.size());
    in_parallel(pictures.size(), n_processors(),
                [&](std::size_t i) { objects[i] = object_of(pictures[i]); });
    std::string data = "[";
    for (const std::string& object : objects) {
        data += data.size() == 1 ? "\n" : ",\n";
        data += object;
    }
    data += "\n]";
    return filled(report_pages().front().text, escaped_markup(title), data);
}

}  // namespace poinsot
