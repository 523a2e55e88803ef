#include "encoding/film_file_hash.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

#include "encoding/formats.h"
#include "error/error.h"
#include "system/files/file_contents.h"
#include "system/sha256.h"

namespace poinsot {

namespace {

struct Surroundings {
    std::int64_t at = 0;  // where the text begins
    std::string hash;     // of the bytes before and after it
};

std::optional<Surroundings> surroundings_of(const std::filesystem::path& file,
                                            std::string_view text) {
    if (text.empty()) return std::nullopt;
    Sha256 hash;
    std::optional<std::int64_t> at;
    std::int64_t n_before = 0;
    std::string window;  // bytes that may hold the beginning of the text
    read_pieces(file, [&](std::string_view piece) {
        if (at) return hash.add(piece);
        window += piece;
        const std::size_t found = window.find(text);
        const std::size_t n =
            std::min(found, window.size() - std::min(window.size(), text.size() - 1));
        hash.add(std::string_view(window).substr(0, n));
        n_before += static_cast<std::int64_t>(n);
        window.erase(0, n);
        if (found == std::string::npos) return;
        at = n_before;
        hash.add(std::string_view(window).substr(text.size()));
        window.clear();
    });
    if (!at) return std::nullopt;
    return Surroundings{*at, hash.finish()};
}

}  // namespace

std::optional<std::string> file_hash_of(const std::filesystem::path& film,
                                        std::string_view record) {
    const auto surroundings = surroundings_of(film, record);
    if (!surroundings) return std::nullopt;
    return surroundings->hash;
}

std::string record_before_hash(const OutputPlan& plan, EncodedMetadata encoded) {
    constexpr std::size_t n_digits = 64;
    encoded.file = std::string(n_digits, '0');
    return text_of(plan, encoded);
}

void put_file_hash(AtomicFile& film, const OutputPlan& plan, EncodedMetadata encoded) {
    const std::string before = record_before_hash(plan, encoded);
    const auto surroundings = surroundings_of(film.aside(), before);
    if (!surroundings) return;  // a film without a record
    encoded.file = surroundings->hash;
    const std::string after = text_of(plan, encoded);
    if (after.size() != before.size())
        throw EnvironmentError(
            fmt::format("cannot write {}: its record changes its length", film.path().string()));
    if (::lseek(film.descriptor(), surroundings->at, SEEK_SET) < 0)
        throw_write_error(film.path(), errno);
    film.write({reinterpret_cast<const std::uint8_t*>(after.data()), after.size()});
}

}  // namespace poinsot
