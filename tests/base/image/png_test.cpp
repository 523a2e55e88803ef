// PNG files: libpng reads the pixels that were written, and damaged files are rejected.
#include <gtest/gtest.h>
#include <libdeflate.h>
#include <png.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <functional>

#include "error/error.h"
#include "image/files/png_bands.h"
#include "image/files/png_files.h"
#include "image/pixels_sha256.h"
#include "image/synthetic.h"
#include "refusal.h"
#include "system/faults.h"
#include "system/files/atomic_file.h"

namespace poinsot {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

Image random_image(bool opaque) {
    const int width = *rc::gen::inRange(1, 40), height = *rc::gen::inRange(1, 40);
    Image image(width, height);
    const auto bytes =
        *rc::gen::container<Bytes>(image.bytes().size(), rc::gen::arbitrary<std::uint8_t>());
    std::copy(bytes.begin(), bytes.end(), image.bytes().begin());
    if (opaque)
        for (std::size_t i = 3; i < image.bytes().size(); i += 4) image.bytes()[i] = 255;
    return image;
}

RC_GTEST_PROP(Png, RoundTripPreservesEveryPixel, ()) {
    const Image image = random_image(*rc::gen::arbitrary<bool>());
    PngOptions options;
    options.deflate_level = *rc::gen::inRange(1, 13);
    RC_ASSERT(decode_png(encode_png(image, options), "x") == image);
}

RC_GTEST_PROP(Png, APalettePngHoldsTheNearestColourOfEveryPixel, ()) {
    const Image image = random_image(true);
    std::vector<Rgba8> palette(*rc::gen::inRange<std::size_t>(1, 257));
    for (Rgba8& colour : palette)
        colour = {*rc::gen::arbitrary<std::uint8_t>(), *rc::gen::arbitrary<std::uint8_t>(),
                  *rc::gen::arbitrary<std::uint8_t>()};
    const Image read = decode_png(encode_palette_png(image, palette), "x");
    RC_ASSERT(read.width() == image.width());
    RC_ASSERT(read.height() == image.height());
    const auto squared_distance = [](const Rgba8& a, const Rgba8& b) {
        const int r = a.r - b.r, g = a.g - b.g, blue = a.b - b.b;
        return r * r + g * g + blue * blue;
    };
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            RC_ASSERT(std::ranges::find(palette, read.at(x, y)) != palette.end());
            for (const Rgba8& colour : palette)
                RC_ASSERT(squared_distance(image.at(x, y), read.at(x, y)) <=
                          squared_distance(image.at(x, y), colour));
        }
    }
}

// A ramp compresses to almost nothing as differences and hardly at all as samples: the size shows
// that the filter was used, the pixels that it was reversed.
TEST(Png, SmoothPicturesAreFilteredAndRoundTrip) {
    for (const std::uint8_t alpha : {255, 254}) {
        Image ramp(300, 200);
        for (int y = 0; y < 200; ++y)
            for (int x = 0; x < 300; ++x)
                ramp.set(x, y,
                         {static_cast<std::uint8_t>(x + y * y), static_cast<std::uint8_t>(3 * x),
                          static_cast<std::uint8_t>(5 * x + y * y * y), alpha});
        const Bytes file = encode_png(ramp);
        EXPECT_LT(file.size(), 6000u);
        EXPECT_TRUE(decode_png(file, "x") == ramp);
    }
}

RC_GTEST_PROP(Png, AReusedEncoderWritesTheSameBytes, ()) {
    const Image first = random_image(false), second = random_image(true);
    PngEncoder encoder;
    encoder.encode(first);
    const auto again = encoder.encode(second);
    RC_ASSERT(Bytes(again.begin(), again.end()) == encode_png(second));
}

RC_GTEST_PROP(Png, RoundTripPreservesTextsAndDensity, (const std::string& raw)) {
    std::string text;
    for (const char c : raw)
        if (c != '\0') text += c;
    PngOptions options;
    options.texts = {{"poinsot", text}, {"Title", "ω = √(2T)/L"}};
    options.pixels_per_metre = *rc::gen::inRange(1, 100000);
    PngInfo info;
    decode_png(encode_png(Image(2, 2), options), "x", &info);
    RC_ASSERT(info.texts == options.texts);
    RC_ASSERT(info.pixels_per_metre == options.pixels_per_metre);
}

// The 25th byte of a PNG is its colour type (PNG specification §11.2.2).
TEST(Png, OpaquePicturesHaveNoAlphaChannel) {
    Image image(3, 2);
    for (std::size_t i = 3; i < image.bytes().size(); i += 4) image.bytes()[i] = 255;
    EXPECT_EQ(encode_png(image)[25], PNG_COLOR_TYPE_RGB);
    image.bytes()[7] = 254;
    EXPECT_EQ(encode_png(image)[25], PNG_COLOR_TYPE_RGBA);
}

// Compared with libpng's own reader of whole pictures.
TEST(Png, LibpngReadsTheSamePixels) {
    const Image image = synthetic_frame(160, 90, 7);
    const Bytes file = encode_png(image);
    png_image reader{};
    reader.version = PNG_IMAGE_VERSION;
    ASSERT_TRUE(png_image_begin_read_from_memory(&reader, file.data(), file.size()));
    reader.format = PNG_FORMAT_RGBA;
    Image read(160, 90);
    ASSERT_TRUE(png_image_finish_read(&reader, nullptr, read.bytes().data(), 0, nullptr));
    EXPECT_TRUE(read == image);
}

Bytes written_by_libpng(png_uint_32 format, int width, int height, const Bytes& samples,
                        const Bytes& palette = {}) {
    png_image writer{};
    writer.version = PNG_IMAGE_VERSION;
    writer.width = static_cast<png_uint_32>(width);
    writer.height = static_cast<png_uint_32>(height);
    writer.format = format;
    writer.colormap_entries = static_cast<png_uint_32>(palette.size() / 3);
    png_alloc_size_t size = 1 << 16;
    Bytes file(size);
    if (!png_image_write_to_memory(&writer, file.data(), &size, 0, samples.data(), 0,
                                   palette.empty() ? nullptr : palette.data()))
        throw std::runtime_error(writer.message);
    file.resize(size);
    return file;
}

TEST(PngReading, GreyAndPaletteBecomeRgba) {
    const Image grey = decode_png(written_by_libpng(PNG_FORMAT_GRAY, 2, 1, {10, 200}), "x");
    EXPECT_EQ(grey.at(0, 0), (Rgba8{10, 10, 10, 255}));
    EXPECT_EQ(grey.at(1, 0), (Rgba8{200, 200, 200, 255}));
    const Image palette = decode_png(
        written_by_libpng(PNG_FORMAT_RGB_COLORMAP, 3, 1, {0, 1, 0}, {1, 2, 3, 250, 251, 252}), "x");
    EXPECT_EQ(palette.at(0, 0), (Rgba8{1, 2, 3, 255}));
    EXPECT_EQ(palette.at(1, 0), (Rgba8{250, 251, 252, 255}));
}

// The palette with its last colour cut off; some versions of libpng do not write such files.
Bytes with_short_palette(Bytes file) {
    const std::string type = "PLTE";
    const auto at = std::search(file.begin(), file.end(), type.begin(), type.end()) - file.begin();
    const std::size_t n = file.at(static_cast<std::size_t>(at - 1));
    Bytes chunk(file.begin() + at - 4, file.begin() + at + 4 + static_cast<std::ptrdiff_t>(n) - 3);
    chunk[3] = static_cast<std::uint8_t>(n - 3);
    const std::uint32_t crc = libdeflate_crc32(0, chunk.data() + 4, chunk.size() - 4);
    for (int shift = 24; shift >= 0; shift -= 8)
        chunk.push_back(static_cast<std::uint8_t>(crc >> shift));
    const auto from =
        file.erase(file.begin() + at - 4, file.begin() + at + 8 + static_cast<std::ptrdiff_t>(n));
    file.insert(from, chunk.begin(), chunk.end());
    return file;
}

// libpng shows black where an index is beyond the palette.
TEST(PngReading, RefusesColoursThatThePaletteDoesNotHave) {
    const Bytes four{1, 2, 3, 250, 251, 252, 9, 9, 9, 7, 7, 7};
    for (const int width : {3, 40}) {
        Bytes indices(static_cast<std::size_t>(width), 0);
        indices.back() = 2;
        const auto written = [&] {
            return with_short_palette(
                written_by_libpng(PNG_FORMAT_RGB_COLORMAP, width, 1, indices, four));
        };
        EXPECT_EQ(decode_png(written(), "x").at(width - 1, 0), (Rgba8{9, 9, 9, 255}));
        indices.back() = 3;
        EXPECT_THROW(decode_png(written(), "x"), InputError) << width;
        EXPECT_THROW(decode_stored_png(written(), "x"), InputError) << width;
    }
}

// Inserts a chunk after the header.
Bytes with_chunk(const Bytes& file, const std::string& type, const Bytes& contents) {
    constexpr std::size_t header_end = 33;
    Bytes chunk = {0, 0, 0, static_cast<std::uint8_t>(contents.size())};
    chunk.insert(chunk.end(), type.begin(), type.end());
    chunk.insert(chunk.end(), contents.begin(), contents.end());
    const std::uint32_t crc = libdeflate_crc32(0, chunk.data() + 4, chunk.size() - 4);
    for (int shift = 24; shift >= 0; shift -= 8)
        chunk.push_back(static_cast<std::uint8_t>(crc >> shift));
    Bytes result = file;
    result.insert(result.begin() + header_end, chunk.begin(), chunk.end());
    return result;
}

// Every 16-bit value in R, and its complement in A.
DeepImage all_levels() {
    DeepImage deep(256, 256);
    for (std::size_t i = 0; i < 65536; ++i) {
        deep.samples()[4 * i] = static_cast<std::uint16_t>(i);
        deep.samples()[4 * i + 3] = static_cast<std::uint16_t>(65535 - i);
    }
    return deep;
}

TEST(PngReading, PreservesEveryStoredBit) {
    const TemporaryFolder folder;
    const DeepImage deep = all_levels();
    PngBandWriter writer(folder / "a.png", 256, 256, false, {}, 16);
    writer.write(deep);
    writer.finish();
    const StoredPicture stored = read_stored_png(folder / "a.png");
    EXPECT_EQ(stored.info.bit_depth, 16);
    EXPECT_TRUE(stored.deep == deep);
    EXPECT_TRUE(stored.image == read_png(folder / "a.png"));

    const Image image = synthetic_frame(40, 30, 2);
    const StoredPicture shallow = decode_stored_png(encode_png(image), "x");
    EXPECT_EQ(shallow.info.bit_depth, 8);
    EXPECT_TRUE(shallow.deep.empty());
    EXPECT_TRUE(shallow.image == image);
}

// Hashes of 16-bit pictures differ if one sample differs by one, and from the hash of the rounded
// picture.
TEST(PngReading, HashesTheStoredBits) {
    StoredPicture stored;
    stored.deep = all_levels();
    const std::string before = pixels_sha256(stored);
    stored.deep.samples()[77] ^= 1;
    EXPECT_NE(pixels_sha256(stored), before);
    // python3: hashlib.sha256(b"1x1 16\n" + bytes([0x12, 0x34, 0, 1, 0xff, 0, 0xff, 0xff]))
    DeepImage one(1, 1);
    const std::array<std::uint16_t, 4> samples{0x1234, 1, 0xff00, 0xffff};
    std::copy(samples.begin(), samples.end(), one.samples().begin());
    EXPECT_EQ(pixels_sha256(one),
              "a04404e21e7de086dd862999db66a1cebff01559d912dc2b247d57ac70842715");
}

TEST(PngReading, NamesTheColourSpace) {
    // Removes the sRGB chunk of one byte after the header.
    Bytes plain = encode_png(Image(2, 2));
    plain.erase(plain.begin() + 33, plain.begin() + 33 + 13);
    const auto colours = [&](const std::string& type, const Bytes& contents) {
        return decode_stored_png(with_chunk(plain, type, contents), "x").info.colours;
    };
    EXPECT_EQ(decode_stored_png(encode_png(Image(2, 2)), "x").info.colours, "sRGB");
    EXPECT_EQ(colours("gAMA", {0, 0, 0xb1, 0x8f}), "sRGB");  // 1/2.2
    EXPECT_EQ(colours("gAMA", {0, 1, 0x86, 0xa0}), "gamma 1");
    EXPECT_EQ(colours("cHRM", Bytes(32, 0)), "primaries " + std::string(64, '0'));
    EXPECT_EQ(colours("cICP", {9, 16, 0, 1}), "code points 09100001");
}

TEST(PngReading, RejectsAnimations) {
    const Bytes file =
        with_chunk(encode_png(synthetic_frame(8, 8, 0)), "acTL", {0, 0, 0, 2, 0, 0, 0, 0});
    EXPECT_NE(refusal_message([&] { decode_png(file, "x"); }).find("x is an animated PNG"),
              std::string::npos);
    EXPECT_NE(refusal_message([&] { decode_stored_png(file, "x"); }), "");
}

// A row of 16-bit grey and alpha samples: 257·v is exactly v in 8 bits.
TEST(PngReading, SixteenBitsAreRoundedToEight) {
    Bytes file;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(
        png, &file,
        [](png_structp p, png_bytep data, std::size_t size) {
            auto& out = *static_cast<Bytes*>(png_get_io_ptr(p));
            out.insert(out.end(), data, data + size);
        },
        nullptr);
    png_set_IHDR(png, info, 3, 1, 16, PNG_COLOR_TYPE_GRAY_ALPHA, PNG_INTERLACE_ADAM7, 0, 0);
    std::array<png_text, 2> texts{};
    std::string key = "Comment", latin1 = "caf\xe9", key2 = "Long", deflated(3000, 'z');
    texts[0] = {
        PNG_TEXT_COMPRESSION_NONE, key.data(), latin1.data(), latin1.size(), 0, nullptr, nullptr};
    texts[1] = {PNG_TEXT_COMPRESSION_zTXt,
                key2.data(),
                deflated.data(),
                deflated.size(),
                0,
                nullptr,
                nullptr};
    png_set_text(png, info, texts.data(), 2);
    png_write_info(png, info);
    // 0x1234 is 4660 = 18.13 · 257; 0x80ff is 33023 = 128.49 · 257.
    Bytes row = {7, 7, 0xff, 0xff, 0x12, 0x34, 0x80, 0x80, 0x80, 0xff, 0, 0};
    std::array<png_bytep, 1> rows = {row.data()};
    png_write_image(png, rows.data());
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);

    PngInfo read;
    const Image image = decode_png(file, "x", &read);
    EXPECT_EQ(image.at(0, 0), (Rgba8{7, 7, 7, 255}));
    EXPECT_EQ(image.at(1, 0), (Rgba8{18, 18, 18, 128}));
    EXPECT_EQ(image.at(2, 0), (Rgba8{128, 128, 128, 0}));
    EXPECT_EQ(read.texts["Comment"], "caf\xc3\xa9");
    EXPECT_EQ(read.texts["Long"], deflated);
}

TEST(PngReading, RejectsEveryTruncation) {
    const Bytes file = encode_png(synthetic_frame(16, 9, 0));
    for (std::size_t size = 0; size < file.size(); ++size)
        EXPECT_THROW(decode_png(std::span(file).first(size), "x"), InputError) << size;
}

TEST(PngReading, DetectsEveryFlippedBit) {
    PngOptions options;
    options.texts["poinsot"] = "text";
    const Bytes file = encode_png(synthetic_frame(8, 4, 0), options);
    for (std::size_t bit = 0; bit < 8 * file.size(); ++bit) {
        Bytes broken = file;
        broken[bit / 8] ^= static_cast<std::uint8_t>(1u << (bit % 8));
        EXPECT_THROW(decode_png(broken, "x"), InputError) << "bit " << bit;
    }
}

RC_GTEST_PROP(PngReading, ThrowsOnRandomBytes, (const Bytes& tail)) {
    Bytes file = encode_png(Image(2, 2));
    file.resize(*rc::gen::inRange<std::size_t>(8, file.size()));
    file.insert(file.end(), tail.begin(), tail.end());
    RC_ASSERT_THROWS_AS(decode_png(file, "x"), InputError);
}

TEST(PngReading, RejectsHugeSizesBeforeAllocating) {
    Bytes file = encode_png(Image(2, 2));
    const auto with_size = [&](std::uint8_t high, std::uint8_t low) {
        Bytes changed = file;
        changed[18] = changed[22] = high;
        changed[19] = changed[23] = low;
        // Corrects the checksum of IHDR, so that only the size is wrong.
        const std::uint32_t sum = libdeflate_crc32(0, changed.data() + 12, 17);
        for (int i = 0; i < 4; ++i)
            changed[29 + static_cast<std::size_t>(i)] =
                static_cast<std::uint8_t>(sum >> (24 - 8 * i));
        return changed;
    };
    EXPECT_EQ(refusal_message([&] { decode_png(with_size(0x40, 1), "a.png"); }),
              "a.png is 16385×16385 pixels; poinsot reads at most 268 million pixels");
    EXPECT_EQ(refusal_message([&] { decode_png(with_size(0x40, 0), "a.png"); }),
              "a.png is cut short");
}

TEST(PngReading, ReadsLongPicturesAndMetadataOfLargeOnes) {
    const TemporaryFolder folder;
    const auto path = folder / "long.png";
    Image image(20'000, 2);
    image.set(19'999, 1, {1, 2, 3, 4});
    PngBandWriter writer(path, image.width(), image.height(), false, {.texts = {{"made", "so"}}},
                         8);
    writer.write(image);
    writer.finish();
    EXPECT_EQ(read_png(path).at(19'999, 1), (Rgba8{1, 2, 3, 4}));
    EXPECT_EQ(read_png_info(path).texts.at("made"), "so");
}

// libpng would allocate the memory that a chunk claims before reading the chunk.
TEST(PngReading, RejectsFalseChunkLengthsBeforeAllocating) {
    const Bytes file = encode_png(Image(2, 2));
    Bytes claims(file.begin(), file.end() - 12);  // without IEND
    // A length of 0x5c0f0010, the type and the first byte of a text.
    for (const char byte :
         {'\x5c', '\x0f', '\0', '\x10', 'i', 'T', 'X', 't', 'k', '\0', '\0', '\0', '\0'})
        claims.push_back(static_cast<std::uint8_t>(byte));
    EXPECT_EQ(refusal_message([&] { decode_png(claims, "a.png"); }), "a.png is cut short");

    constexpr std::size_t too_long = (std::size_t{4} << 20) + 1;
    Bytes large(file.begin(), file.end() - 12);
    for (int i = 3; i >= 0; --i) large.push_back(static_cast<std::uint8_t>(too_long >> 8 * i));
    for (const char c : {'i', 'T', 'X', 't'}) large.push_back(static_cast<std::uint8_t>(c));
    large.resize(large.size() + too_long + 4);
    EXPECT_EQ(refusal_message([&] { decode_png(large, "a.png"); }),
              "a.png is a broken PNG picture: a chunk without pixels has 4194305 bytes; poinsot "
              "reads at most 4194304");
}

TEST(PngReading, ErrorsNameTheFault) {
    const TemporaryFolder folder;
    const fs::path path = folder / "a.png";
    EXPECT_EQ(refusal_message([&] { read_png(path); }), path.string() + " does not exist");
    EXPECT_EQ(refusal_message([&] { read_png(folder.path()); }),
              folder.path().string() + " is a folder, not a PNG picture");
    AtomicFile(path).commit();
    EXPECT_EQ(refusal_message([&] { read_png(path); }), path.string() + " is not a PNG picture");
}

TEST(PngWriting, RejectsValuesThatPngCannotHold) {
    PngOptions options;
    EXPECT_THROW(encode_png(Image(), options), InputError);
    EXPECT_THROW(encode_png(Image(largest_png_side_px + 1, 1), options), InputError);
    for (const std::string& keyword : {std::string(), std::string(80, 'k'), std::string("a\0b", 3),
                                       std::string(" a"), std::string("a\nb")}) {
        options.texts = {{keyword, "text"}};
        EXPECT_THROW(encode_png(Image(1, 1), options), InputError) << keyword;
    }
    options.texts = {};
    options.pixels_per_metre = -1;
    EXPECT_THROW(encode_png(Image(1, 1), options), InputError);
    options.pixels_per_metre = 0;
    options.deflate_level = 13;
    EXPECT_THROW(encode_png(Image(1, 1), options), InputError);
}

TEST(PngWriting, FileRoundTrip) {
    const TemporaryFolder folder;
    const Image image = synthetic_frame(64, 48, 3);
    write_png(folder / "a.png", image);
    EXPECT_TRUE(read_png(folder / "a.png") == image);
    EXPECT_EQ(folder.contents(), std::vector<std::string>{"a.png"});
}

// A small picture reaches a full device only when it is flushed; the error must be reported.
TEST(PngWriting, FullDeviceIsReported) {
    try {
        write_png("/dev/full", Image(2, 2));
        FAIL() << "nothing was thrown";
    } catch (const EnvironmentError& error) {
        EXPECT_STREQ(error.what(), "cannot write /dev/full: No space left on device");
    }
}

}  // namespace
}  // namespace poinsot
