#include "compare/report_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <system_error>
#include <vector>

#include "error/error.h"
#include "image/thumbnail.h"
#include "system/files/file_contents.h"
#include "system/files/file_kind.h"
#include "system/sha256.h"
#include "text/markup.h"
#include "text/printable.h"

namespace poinsot {

namespace {

namespace fs = std::filesystem;

constexpr int thumbnail_px = 480;
constexpr std::array<const char*, 4> kinds{"expected", "actual", "difference", "strip"};

std::string data_uri(std::span<const std::uint8_t> png) {
    return "data:image/png;base64," + base64(png);
}

bool is_plain(char c) {
    return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') || c == '_' ||
           c == '-' || c == '.';
}

// A picture's name as the name of a file that needs no escaping in an address. Where characters are
// replaced, a part of the name's hash keeps it apart from others.
std::string file_name_of(const std::string& name) {
    constexpr std::size_t longest = 120;
    if (!name.empty() && name.size() <= longest && name[0] != '.' &&
        std::all_of(name.begin(), name.end(), is_plain))
        return name;
    std::string plain = name.substr(0, longest);
    for (char& c : plain)
        if (!is_plain(c)) c = '_';
    if (plain.starts_with('.')) plain[0] = '_';
    return fmt::format("{}-{}", plain, sha256_of(name).substr(0, 8));
}

// The relative address of a file in a folder beside the page, in percent-encoding (RFC 3986 §2.1).
std::string address_of(const fs::path& folder, const fs::path& file) {
    std::string address;
    for (const fs::path& part : {folder.filename(), file.filename()}) {
        if (!address.empty()) address += '/';
        for (const char c : part.string()) {
            if (is_plain(c))
                address += c;
            else
                address += fmt::format("%{:02X}", static_cast<unsigned char>(c));
        }
    }
    return address;
}

void place(const Image& image, int left, int top, Image& sheet) {
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) sheet.set(left + x, top + y, image.at(x, y));
}

}  // namespace

Image film_strip(std::span<const KeptFrames> frames, int most_px) {
    std::vector<Image> rows;
    int width = 0, height = 0;
    for (const KeptFrames& frame : frames) {
        rows.push_back(
            thumbnail(difference_picture(frame.expected, frame.actual, frame.ignored), most_px));
        width = std::max(width, rows.back().width());
        height += rows.back().height();
    }
    Image strip(width, height);
    int top = 0;
    for (const Image& row : rows) {
        place(row, 0, top, strip);
        top += row.height();
    }
    return strip;
}

fs::path ReportPictures::folder_of(const fs::path& report) {
    return report.parent_path() / (report.stem().string() + "_pictures");
}

ReportPictures::ReportPictures(const fs::path& report, bool single_file)
    : folder_(folder_of(report)), single_file_(single_file) {
    if (single_file_) return;
    log_.emplace(folder_, "poinsot-files", "poinsot: pictures of a report");
    std::error_code error;
    std::vector<fs::path> old;
    for (fs::directory_iterator at(folder_, error); !error && at != fs::directory_iterator();
         at.increment(error)) {
        const std::string name = at->path().filename().string();
        for (const char* kind : kinds) {
            if (!name.ends_with(fmt::format("-{}.png", kind))) continue;
            log_->check(name, "the report's pictures");
            old.push_back(at->path());
        }
    }
    for (const fs::path& path : old) fs::remove(path, error);
}

std::string ReportPictures::write(const std::string& name, const char* which,
                                  const std::vector<std::uint8_t>& png) {
    const std::string file = fmt::format("{}-{}.png", file_name_of(name), which);
    {
        const std::lock_guard lock(made_folder_);
        std::error_code error;
        const bool is_new = fs::create_directories(folder_, error);
        if (error)
            throw EnvironmentError(
                fmt::format("cannot make the folder {} for the report's pictures: {}",
                            printable(folder_.string()), error.message()));
        if (is_new || !has_begun_) log_->begin();
        has_begun_ = true;
        log_->add(file, {reinterpret_cast<const char*>(png.data()), png.size()});
    }
    write_whole(folder_ / file, png);
    return address_of(folder_, file);
}

std::string ReportPictures::put(const std::string& name, const char* which, const Image& image) {
    if (single_file_) return data_uri(encode_png(image));
    return write(name, which, encode_png(image));
}

std::string ReportPictures::put_file(const std::string& name, const char* which,
                                     const fs::path& file) {
    return write(name, which, read_bytes(file));
}

void ReportPictures::add(ComparedPicture& picture, const PicturePair& pair) {
    const auto one = [&](const char* which, const fs::path& file, const StoredPicture& stored) {
        if (single_file_) return put(picture.name, which, thumbnail(stored.image, thumbnail_px));
        const bool is_picture = suffix_of(file) == ".png" && !is_sequence_name(file);
        return is_picture ? put_file(picture.name, which, file)
                          : put(picture.name, which, stored.image);
    };
    const int strip_px = single_file_ ? thumbnail_px : 1440;
    ShownPictures& shown = picture.shown;
    shown.expected = one("expected", picture.expected, pair.expected);
    shown.actual = one("actual", picture.actual, pair.actual);
    const DifferenceLayer layer =
        difference_layer(pair.expected, pair.actual, pair.limits, pair.ignored);
    shown.difference = put(picture.name, "difference",
                           single_file_ ? layer_thumbnail(layer.image, thumbnail_px) : layer.image);
    shown.n_faint_left_out = layer.n_faint_left_out;
    if (!pair.strip.empty())
        shown.strip = put(picture.name, "strip", film_strip(pair.strip, strip_px));
}

void ReportPictures::add_alone(ComparedPicture& picture) {
    const auto one = [&](const char* which, const fs::path& file) -> std::string {
        if (suffix_of(file) != ".png" || kind_of_file(file) != FileKind::regular) return "";
        if (!single_file_) return put_file(picture.name, which, file);
        try {
            return put(picture.name, which, thumbnail(read_png(file), thumbnail_px));
        } catch (const InputError&) {
            return "";  // the report says that it cannot be read
        }
    };
    if (picture.shown.expected.empty()) picture.shown.expected = one("expected", picture.expected);
    if (picture.shown.actual.empty()) picture.shown.actual = one("actual", picture.actual);
}

}  // namespace poinsot
