#include "vector/paper_flow.h"

#include <algorithm>
#include <cmath>

namespace poinsot::vector {

PaperFlow on_paper(const Projection& projection, const CurveFlow& flow) {
    const double at_depth = projection.depth(flow.position);
    const double scale = projection.scale(at_depth);
    const Eigen::Vector3d from_eye = flow.position - projection.eye;
    const Eigen::Vector2d across(projection.right.dot(from_eye), projection.down.dot(from_eye));
    Eigen::Vector2d change(projection.right.dot(flow.velocity), projection.down.dot(flow.velocity));
    if (projection.perspective)
        change -= across * (projection.forward.dot(flow.velocity) / at_depth);
    return {projection.centre + scale * across, scale * change};
}

double spacing_px(const Projection& projection, const Eigen::Vector3d& at,
                  const Eigen::Vector3d& along, const Eigen::Vector3d& beside) {
    const Eigen::Vector2d run = on_paper(projection, CurveFlow{at, along}).velocity;
    const Eigen::Vector2d step = on_paper(projection, CurveFlow{at, beside}).velocity;
    const double area = run.x() * step.y() - run.y() * step.x();
    return std::abs(area) / std::max(run.norm(), 1e-12) / projection.units_per_px;
}

}  // namespace poinsot::vector
