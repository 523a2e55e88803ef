// Translucent ellipsoids; those whose pictures overlap are drawn together, ordered at each pixel.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "render/program.h"
#include "render/view_scene.h"

namespace poinsot {

class EllipsoidPass {
 public:
    // Precondition: a vertex array without attributes is bound.
    void draw(const ViewScene& scene);

 private:
    static constexpr int most_members = 4;
    struct Variant {
        explicit Variant(int n_members);
        PolygonProgram program;
        GLint sights;
    };
    void draw_group(const ViewScene& scene, const int* members, int n_members);

    // One program for each number of ellipsoids drawn together, made when first needed.
    std::array<std::optional<Variant>, most_members> variants_;
    std::vector<int> order_;
};

}  // namespace poinsot
