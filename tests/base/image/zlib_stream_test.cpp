#include "image/zlib_stream.h"

#include <gtest/gtest.h>
#include <libdeflate.h>

#include <string>

namespace poinsot {
namespace {

TEST(ZlibStream, UnpacksToWhatWasPacked) {
    std::string text;
    for (const int n : {0, 1, 40, 5000}) {
        while (text.size() < static_cast<std::size_t>(n))
            text += "[[stops]]\nat_s = " + std::to_string(text.size()) + "\n";
        const std::vector<std::uint8_t> packed =
            zlib_stream({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
        std::string unpacked(text.size() + 1, '?');
        std::size_t n_unpacked = 0;
        libdeflate_decompressor* const decompressor = libdeflate_alloc_decompressor();
        EXPECT_EQ(libdeflate_zlib_decompress(decompressor, packed.data(), packed.size(),
                                             unpacked.data(), unpacked.size(), &n_unpacked),
                  LIBDEFLATE_SUCCESS);
        libdeflate_free_decompressor(decompressor);
        unpacked.resize(n_unpacked);
        EXPECT_EQ(unpacked, text);
        EXPECT_TRUE(n < 1000 || packed.size() < text.size() / 3) << packed.size();
    }
}

}  // namespace
}  // namespace poinsot
