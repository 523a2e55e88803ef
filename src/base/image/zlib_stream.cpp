#include "image/zlib_stream.h"

#include <libdeflate.h>

#include <memory>

#include "error/error.h"

namespace poinsot {

std::vector<std::uint8_t> zlib_stream(std::span<const std::uint8_t> raw) {
    constexpr int smallest = 12;
    const std::unique_ptr<libdeflate_compressor, void (*)(libdeflate_compressor*)> compressor(
        libdeflate_alloc_compressor(smallest), libdeflate_free_compressor);
    if (!compressor) throw EnvironmentError("no memory to compress a file");
    std::vector<std::uint8_t> to(libdeflate_zlib_compress_bound(compressor.get(), raw.size()));
    to.resize(
        libdeflate_zlib_compress(compressor.get(), raw.data(), raw.size(), to.data(), to.size()));
    return to;
}

}  // namespace poinsot
