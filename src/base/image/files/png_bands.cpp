#include "image/files/png_bands.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cassert>
#include <limits>
#include <optional>

#include "error/error.h"
#include "image/pixels_xxh64.h"
#include "image/png_chunks.h"
#include "system/files/atomic_file.h"

namespace poinsot {

namespace {

using png::Bytes;

// zlib's levels end at 9, libdeflate's at 12; from level 4 on, zlib's time grows faster than its
// gain.
constexpr int largest_zlib_level = 9;
constexpr std::size_t chunk_bytes = 1 << 18;

}  // namespace

struct PngBandWriter::Impl {
    Impl(const std::filesystem::path& path, const png::Format& format_, const PngOptions& options)
        : format(format_),
          check(format.width_px, format.height_px, format.bit_depth),
          chunk(chunk_bytes) {
        const Bytes front =
            png::front(format, largest_banded_png_side_px, png::description(options));
        file.emplace(path);
        file->write(front);
        const int level = std::clamp(options.deflate_level, 1, largest_zlib_level);
        if (deflateInit(&stream, level) != Z_OK)
            throw EnvironmentError("no memory to compress a picture");
    }
    ~Impl() { deflateEnd(&stream); }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    // Makes room for the rows of a band. Throws InputError if the band does not fit.
    std::uint8_t* take_rows(int width_px, int n_rows) {
        if (width_px != format.width_px || n_rows > format.height_px - n_rows_written)
            throw InputError(
                fmt::format("a band of {}×{} pixels was given to a picture of {}×{} at row {}",
                            width_px, n_rows, format.width_px, format.height_px, n_rows_written));
        n_rows_written += n_rows;
        rows.resize(format.row_size() * static_cast<std::size_t>(n_rows));
        return rows.data();
    }

    // Compresses the contents of `rows`; writes the output to the file in chunks.
    void compress(int flush) {
        stream.next_in = rows.data();
        stream.avail_in = static_cast<uInt>(rows.size());
        do {
            stream.next_out = chunk.data();
            stream.avail_out = static_cast<uInt>(chunk.size());
            deflate(&stream, flush);
            const std::size_t n_out = chunk.size() - stream.avail_out;
            if (n_out == 0) break;
            Bytes idat;
            png::append_chunk(idat, "IDAT", std::span(chunk).first(n_out));
            file->write(idat);
        } while (stream.avail_out == 0);
        rows.clear();
    }

    // Adds samples to the hash. In a picture without alpha channel, full alpha takes the place of
    // alpha.
    template <typename Sample>
    void add_to_check(std::span<const Sample> samples) {
        if (!format.opaque) return check.add(samples);
        std::vector<Sample> shown(samples.begin(), samples.end());
        for (std::size_t i = 3; i < shown.size(); i += 4)
            shown[i] = std::numeric_limits<Sample>::max();
        check.add(std::span<const Sample>(shown));
    }

    png::Format format;
    PixelsXxh64 check;
    int n_rows_written = 0;
    std::optional<AtomicFile> file;
    z_stream stream{};
    Bytes rows, chunk;
};

PngBandWriter::PngBandWriter(const std::filesystem::path& path, int width_px, int height_px,
                             bool opaque, const PngOptions& options, int bit_depth)
    : impl_(std::make_unique<Impl>(path, png::Format{width_px, height_px, opaque, bit_depth},
                                   options)) {}
PngBandWriter::~PngBandWriter() = default;
PngBandWriter::PngBandWriter(PngBandWriter&&) noexcept = default;
PngBandWriter& PngBandWriter::operator=(PngBandWriter&&) noexcept = default;

void PngBandWriter::write(const Image& band) {
    assert(impl_->format.bit_depth == 8);
    std::uint8_t* const rows = impl_->take_rows(band.width(), band.height());
    png::filter_rows(band, impl_->format.opaque, png::Filter::sub, 0, band.height(), rows);
    impl_->add_to_check(band.bytes());
    impl_->compress(Z_NO_FLUSH);
}

void PngBandWriter::write(const DeepImage& band) {
    assert(impl_->format.bit_depth == 16);
    png::filter_rows(band, impl_->format.opaque, impl_->take_rows(band.width(), band.height()));
    impl_->add_to_check(band.samples());
    impl_->compress(Z_NO_FLUSH);
}

std::string PngBandWriter::pixels_xxh64() const { return impl_->check.digits(); }

void PngBandWriter::finish(const std::map<std::string, std::string>& texts) {
    if (impl_->n_rows_written != impl_->format.height_px)
        throw InputError(fmt::format("{} of {} rows were given to {}", impl_->n_rows_written,
                                     impl_->format.height_px, impl_->file->path().string()));
    impl_->compress(Z_FINISH);
    impl_->file->write(png::back(texts));
    impl_->file->commit();
}

}  // namespace poinsot
