// Translucent ellipsoids; those whose pictures overlap are drawn together, ordered at each pixel.
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

    // One program for each number of ellipsoids drawn together, made when first needed.
    std::array<std::optional<Variant>, most_members> variants_;
    std::optional<Variant> core_;  // well within the outline of a single one
    std::vector<int> order_;
};

}  // namespace poinsot
