// Draws translucent ellipsoids. Those that overlap in the picture are drawn together, with their
// surfaces sorted in each pixel.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "render/passes/program.h"
#include "render/view_scene.h"

namespace poinsot {

class EllipsoidPass {
 public:
    // Precondition: a vertex array without attributes is bound.
    void draw(const ViewScene& scene);

 private:
    static constexpr int most_members = 4;
    struct Variant {
        Variant(int n_members, bool rim);
        void use(const Projection& projection) const;
        PolygonProgram program;
        GLint sights;
    };
    const Variant& variant_of(int n_members);
    void draw_group(const ViewScene& scene, const int* members, int n_members);

    // One program per number of ellipsoids drawn together, made on first use.
    std::array<std::optional<Variant>, most_members> variants_;
    std::optional<Variant> core_;  // for pixels well inside the outline of a single ellipsoid
    std::vector<int> order_;
};

}  // namespace poinsot
