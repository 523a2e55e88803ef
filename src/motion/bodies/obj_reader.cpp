// Reader of Wavefront OBJ.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "bodies/mesh_reader.h"
#include "bodies/mesh_text.h"
#include "error/error.h"
#include "text/printable.h"

namespace poinsot {

namespace {

class ObjReader {
 public:
    ObjReader(std::string_view text, std::string_view name) : text_(text, name), name_(name) {}

    TriangleMesh read() {
        do {
            const std::string_view keyword = text_.word_in_line();
            if (keyword == "v") {
                read_vertex(keyword);
            } else if (keyword == "f") {
                read_face(keyword);
            }
        } while (text_.next_line());
        // A face may refer to a vertex further down, so this check needs the final number of
        // vertices.
        if (largest_index_ > mesh_.vertices.size()) {
            text_.refuse(largest_word_,
                         fmt::format("there is no vertex {}: the file has {}; export it again",
                                     largest_index_, mesh_.vertices.size()));
        }
        if (mesh_.triangles.empty()) {
            throw InputError(fmt::format(
                "{}: no faces (lines \"f …\") were found; export the surface of a solid as OBJ",
                printable(name_)));
        }
        return std::move(mesh_);
    }

 private:
    void read_vertex(std::string_view keyword) {
        if (mesh_.vertices.size() == most_mesh_vertices) {
            text_.refuse(keyword, fmt::format("more than {} vertices; simplify the mesh",
                                              most_mesh_vertices));
        }
        Eigen::Vector3d at;
        for (double& x : at) x = text_.coordinate(text_.word_in_line());
        mesh_.vertices.push_back(at);
    }

    void read_face(std::string_view keyword) {
        std::array<std::uint32_t, 3> triangle{};
        std::size_t n_corners = 0;
        for (auto word = text_.word_in_line(); !word.empty(); word = text_.word_in_line()) {
            const std::uint32_t vertex = vertex_of(word);
            if (n_corners >= 2) {
                triangle[2] = vertex;
                add(triangle, word);
                triangle[1] = vertex;
            } else {
                triangle[n_corners] = vertex;
            }
            ++n_corners;
        }
        if (n_corners < 3) {
            text_.refuse(keyword,
                         fmt::format("a face has {} corners; it needs three or more", n_corners));
        }
    }

    void add(const std::array<std::uint32_t, 3>& triangle, std::string_view word) {
        if (mesh_.triangles.size() == most_mesh_triangles) {
            text_.refuse(word, fmt::format("more than {} triangles; simplify the mesh",
                                           most_mesh_triangles));
        }
        mesh_.triangles.push_back(triangle);
    }

    // The vertex, counted from 0, of a corner "v", "v/vt", "v//vn" or "v/vt/vn".
    std::uint32_t vertex_of(std::string_view word) {
        long long index = 0;
        const char* const end = word.data() + word.size();
        const auto [rest, error] = std::from_chars(word.data(), end, index);
        const std::string_view others(rest, static_cast<std::size_t>(end - rest));
        const bool well_formed = error == std::errc{} &&
                                 (others.empty() || others.front() == '/') &&
                                 std::ranges::count(others, '/') <= 2 &&
                                 others.find_first_not_of("/-0123456789") == std::string_view::npos;
        if (!well_formed) {
            text_.refuse(word, fmt::format("{} is not a corner of a face; write v, v/vt, v//vn or "
                                           "v/vt/vn with whole numbers",
                                           quoted(word)));
        }
        const auto n_vertices = static_cast<long long>(mesh_.vertices.size());
        if (index == 0) {
            text_.refuse(word, "vertices are counted from 1 (or from -1 backwards); 0 names none");
        }
        if (index < -n_vertices || index > static_cast<long long>(most_mesh_vertices)) {
            text_.refuse(word,
                         fmt::format("there is no vertex {}: {} stand above this line; export the "
                                     "file again",
                                     index, n_vertices));
        }
        if (index < 0) return static_cast<std::uint32_t>(n_vertices + index);
        if (static_cast<std::size_t>(index) > largest_index_) {
            largest_index_ = static_cast<std::size_t>(index);
            largest_word_ = word;
        }
        return static_cast<std::uint32_t>(index - 1);
    }

    MeshText text_;
    std::string_view name_;
    TriangleMesh mesh_;
    std::size_t largest_index_ = 0;  // of the positive indices, counted from 1
    std::string_view largest_word_;
};

}  // namespace

TriangleMesh read_obj(std::string_view text, std::string_view name) {
    return ObjReader(text, name).read();
}

}  // namespace poinsot
