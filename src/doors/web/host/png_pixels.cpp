// Reads PNG pictures for the faces of bodies, in a page: the module has no libpng. As
// src/base/image/png_read.cpp, for sRGB pictures.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STBI_NO_THREAD_LOCALS
#define STBI_MAX_DIMENSIONS 65536
#include <stb_image.h>

#include "error/error.h"
#include "image/png.h"

namespace poinsot {

namespace {

[[noreturn]] void refuse_png(const std::string& name, std::string_view what) {
    throw InputError(fmt::format("{}: {}", name, what));
}

// Whether a chunk before the pixels begins an animation, of which stb_image reads the first frame.
bool is_animated(std::string_view file) {
    for (std::size_t at = 8; at + 12 <= file.size();) {
        const std::string_view type = file.substr(at + 4, 4);
        if (type == "acTL" || type == "IDAT") return type == "acTL";
        std::size_t length = 0;
        for (const char byte : file.substr(at, 4))
            length = length << 8 | static_cast<std::uint8_t>(byte);
        at += std::min(length, file.size()) + 12;
    }
    return false;
}

}  // namespace

PngInfo decode_png_info(std::span<const std::uint8_t> file, const std::string& name) {
    const auto size = static_cast<int>(file.size());
    PngInfo info;
    if (stbi_info_from_memory(file.data(), size, &info.width_px, &info.height_px, nullptr) == 0)
        refuse_png(
            name, fmt::format("not a PNG picture that a page can read: {}", stbi_failure_reason()));
    if (std::int64_t{info.width_px} * info.height_px > most_png_pixels)
        refuse_png(name, "a PNG picture of a size that cannot be read");
    if (is_animated({reinterpret_cast<const char*>(file.data()), file.size()}))
        refuse_png(name, "an animation; name a picture");
    info.bit_depth = stbi_is_16_bit_from_memory(file.data(), size) != 0 ? 16 : 8;
    return info;
}

Image decode_png(std::span<const std::uint8_t> file, const std::string& name, PngInfo* info) {
    const PngInfo own = decode_png_info(file, name);
    if (info != nullptr) *info = own;
    int width = 0, height = 0;
    const std::unique_ptr<std::uint16_t, decltype(&stbi_image_free)> samples(
        stbi_load_16_from_memory(file.data(), static_cast<int>(file.size()), &width, &height,
                                 nullptr, 4),
        stbi_image_free);
    if (!samples)
        refuse_png(name, fmt::format("the PNG picture is damaged: {}", stbi_failure_reason()));
    Image image(width, height);
    // Rounds to the nearest level, as libpng does.
    std::transform(
        samples.get(), samples.get() + image.bytes().size(), image.bytes().begin(),
        [](std::uint16_t v) { return static_cast<std::uint8_t>((v * 255u + 32895u) >> 16); });
    return image;
}

}  // namespace poinsot
