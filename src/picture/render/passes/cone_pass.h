// Draws translucent cones; all cones of a view are drawn together, with their surfaces sorted in
// each pixel.
#pragma once

#include <memory>
#include <vector>

#include "render/passes/program.h"
#include "render/tile_mask.h"
#include "render/view_scene.h"

namespace poinsot {

class ConePass {
 public:
    // Precondition: a vertex array without attributes is bound.
    void draw(const ViewScene& scene);
    void mark(const ViewScene& scene, TileMask& marks) const;

 private:
    static constexpr int most_members = 4;
    void draw_group(const ViewScene& scene, std::size_t first, int n_members);

    struct Row {
        int n_members;
        Solids solids;
        std::unique_ptr<PolygonProgram> program;
    };
    const PolygonProgram& program_for(int n_members, const Solids& solids);
    std::vector<Row> programs_;
};

}  // namespace poinsot
