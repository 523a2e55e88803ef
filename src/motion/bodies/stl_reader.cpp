// Reader of STL, binary and ASCII.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>

#include "bodies/mesh_reader.h"
#include "bodies/mesh_text.h"
#include "error/error.h"
#include "text/printable.h"

namespace poinsot {

namespace {

constexpr std::size_t header_bytes = 80;
constexpr std::size_t first_facet = header_bytes + 4;
constexpr std::size_t facet_bytes = 50;

std::uint32_t little_endian(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        value |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
    }
    return value;
}

std::uint64_t bytes_of_binary(std::uint64_t n_facets) {
    return first_facet + facet_bytes * n_facets;
}

bool is_binary(std::string_view bytes) {
    return bytes.size() >= first_facet &&
           bytes.size() == bytes_of_binary(little_endian(bytes, header_bytes));
}

bool same_word(std::string_view word, std::string_view lower_case) {
    return std::ranges::equal(word, lower_case, [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) == b;
    });
}

// Adds three new vertices and one triangle: corners are not shared.
void add_facet(TriangleMesh& mesh) {
    const auto n = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.triangles.push_back({n - 3, n - 2, n - 1});
}

TriangleMesh read_binary(std::string_view bytes, std::string_view name) {
    const std::size_t n_facets = little_endian(bytes, header_bytes);
    if (n_facets > most_mesh_triangles) {
        throw InputError(fmt::format("{}: byte {}: {} triangles, more than {}; simplify the mesh",
                                     printable(name), header_bytes, n_facets, most_mesh_triangles));
    }
    TriangleMesh mesh;
    mesh.vertices.reserve(3 * n_facets);
    mesh.triangles.reserve(n_facets);
    for (std::size_t facet = 0; facet < n_facets; ++facet) {
        // A facet is a normal, three corners and two bytes of attributes.
        const std::size_t corners = first_facet + facet_bytes * facet + 12;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            Eigen::Vector3d at;
            for (std::size_t i = 0; i < 3; ++i) {
                const std::size_t offset = corners + 12 * corner + 4 * i;
                const auto x = std::bit_cast<float>(little_endian(bytes, offset));
                if (!(std::abs(x) <= largest_mesh_coordinate_m)) {
                    throw InputError(fmt::format(
                        "{}: byte {}: coordinate {} of triangle {} is not within ±{:.0e} m; scale "
                        "or export the mesh again",
                        printable(name), offset, x, facet + 1, largest_mesh_coordinate_m));
                }
                at[static_cast<Eigen::Index>(i)] = static_cast<double>(x);
            }
            mesh.vertices.push_back(at);
        }
        add_facet(mesh);
    }
    return mesh;
}

class AsciiReader {
 public:
    AsciiReader(std::string_view text, std::string_view name) : text_(text, name) {}

    TriangleMesh read() {
        // Several solids in one file are parts of one surface.
        for (auto word = text_.word(); !word.empty(); word = text_.word()) {
            if (!same_word(word, "solid")) {
                text_.refuse(word, fmt::format("{} where \"solid\" was expected; export the file "
                                               "again",
                                               quoted(word)));
            }
            text_.skip_line();  // the solid's name
            read_solid();
        }
        return std::move(mesh_);
    }

 private:
    void read_solid() {
        for (auto word = text_.word(); !same_word(word, "endsolid"); word = text_.word()) {
            if (!same_word(word, "facet")) {
                text_.refuse(word,
                             fmt::format("{} where \"facet\" or \"endsolid\" was expected; export "
                                         "the file again",
                                         shown(word)));
            }
            if (mesh_.triangles.size() == most_mesh_triangles) {
                text_.refuse(word, fmt::format("more than {} triangles; simplify the mesh",
                                               most_mesh_triangles));
            }
            read_facet();
        }
        text_.skip_line();
    }

    void read_facet() {
        expect("normal");
        for (int i = 0; i < 3; ++i) {
            // Normals are ignored, and files often contain invalid ones; but the word must not be
            // the next keyword.
            if (const auto word = text_.word(); word.empty() || same_word(word, "outer")) {
                text_.refuse(word, "a facet's normal has three components; export the file again");
            }
        }
        expect("outer");
        expect("loop");
        for (int corner = 0; corner < 3; ++corner) {
            expect("vertex");
            Eigen::Vector3d at;
            for (double& x : at) x = text_.coordinate(text_.word());
            mesh_.vertices.push_back(at);
        }
        expect("endloop");
        expect("endfacet");
        add_facet(mesh_);
    }

    void expect(std::string_view keyword) {
        const auto word = text_.word();
        if (same_word(word, keyword)) return;
        text_.refuse(word, fmt::format("{} where \"{}\" was expected; export the file again",
                                       shown(word), keyword));
    }

    static std::string shown(std::string_view word) {
        return word.empty() ? "the end of the file" : quoted(word);
    }

    MeshText text_;
    TriangleMesh mesh_;
};

[[noreturn]] void refuse_unknown(std::string_view bytes, std::string_view name) {
    if (bytes.size() < first_facet) {
        throw InputError(
            fmt::format("{}: {} bytes are neither an ASCII STL (\"solid …\") nor a binary one (84 "
                        "bytes or more); export the file again",
                        printable(name), bytes.size()));
    }
    const std::uint32_t n_facets = little_endian(bytes, header_bytes);
    throw InputError(fmt::format(
        "{}: byte {}: says {} triangles, which take {} bytes, but the file has {}; it is cut short "
        "or not an STL: export it again",
        printable(name), header_bytes, n_facets, bytes_of_binary(n_facets), bytes.size()));
}

bool is_ascii(std::string_view bytes) {
    const std::size_t begin = bytes.find_first_not_of(" \t\r\n");
    return begin != std::string_view::npos && same_word(bytes.substr(begin, 5), "solid");
}

}  // namespace

TriangleMesh read_stl(std::string_view bytes, std::string_view name) {
    if (!is_binary(bytes) && !is_ascii(bytes)) refuse_unknown(bytes, name);
    TriangleMesh mesh =
        is_binary(bytes) ? read_binary(bytes, name) : AsciiReader(bytes, name).read();
    if (mesh.triangles.empty()) {
        throw InputError(
            fmt::format("{}: no triangles; export the surface of a solid as STL", printable(name)));
    }
    return welded(mesh);
}

}  // namespace poinsot
