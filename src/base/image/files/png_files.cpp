#include "image/files/png_files.h"

#include <fmt/format.h>

#include <span>
#include <system_error>

#include "error/error.h"
#include "image/pixels_xxh64.h"
#include "system/files/atomic_file.h"
#include "system/files/file_contents.h"
#include "system/files/file_kind.h"

namespace poinsot {

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t largest_file_bytes = std::uintmax_t{5} << 28;

}  // namespace

std::vector<std::uint8_t> bytes_of_png(const fs::path& path) {
    const FileKind kind = kind_of_file(path);
    if (kind == FileKind::missing)
        throw InputError(fmt::format("{} does not exist", path.string()));
    if (kind == FileKind::folder)
        throw InputError(fmt::format("{} is a folder, not a PNG picture", path.string()));
    if (kind != FileKind::regular)
        throw InputError(fmt::format("{}: {}", path.string(), in_words(kind)));
    std::error_code error;
    if (const std::uintmax_t size = fs::file_size(path, error); !error && size > largest_file_bytes)
        throw InputError(
            fmt::format("{} is too large for a picture that poinsot reads", path.string()));
    return read_bytes(path);
}

Image read_png(const fs::path& path, PngInfo* info) {
    return decode_png(bytes_of_png(path), path.string(), info);
}

StoredPicture read_stored_png(const fs::path& path) {
    return decode_stored_png(bytes_of_png(path), path.string());
}

PngInfo read_png_info(const fs::path& path) {
    return decode_png_info(bytes_of_png(path), path.string());
}

std::string pixels_xxh64_of(const fs::path& path) {
    return pixels_xxh64_of(bytes_of_png(path), path.string());
}

void write_png(const fs::path& path, const Image& image, const PngOptions& options) {
    PngEncoder encoder(options);
    const std::span<const std::uint8_t> contents = encoder.encode(image);
    write_whole(path, contents);
}

}  // namespace poinsot
