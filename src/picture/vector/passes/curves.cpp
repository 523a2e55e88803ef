// Draws curves: visible parts, and hidden parts paler, dashed or omitted.
#include "vector/passes/curves.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

#include "vector/dashes.h"

namespace poinsot::vector {

namespace {

CurveFlow flow_of(const CubicPiece& piece, double s) {
    const double length = piece.to - piece.from;
    const double t = length > 0.0 ? (s - piece.from) / length : 0.0, u = 1.0 - t;
    const auto& p = piece.points;
    return {piece.at(s),
            3.0 / (length > 0.0 ? length : 1.0) *
                (u * u * (p[1] - p[0]) + 2.0 * u * t * (p[2] - p[1]) + t * t * (p[3] - p[2]))};
}

std::function<CurveFlow(double)> flow_of(const std::vector<CubicPiece>& pieces) {
    return [&pieces](double s) {
        const auto after =
            std::upper_bound(pieces.begin(), pieces.end(), s,
                             [](double x, const CubicPiece& p) { return x < p.from; });
        return flow_of(after == pieces.begin() ? *after : *std::prev(after), s);
    };
}

// Cubic curves through points. The tangents are those of the parabolas through three neighbouring
// points, except at corners, where straight pieces meet.
std::vector<CubicPiece> through_points(const CurveGeometry& geometry) {
    const auto& points = geometry.points;
    const std::size_t n = points.size();
    const std::size_t n_segments = geometry.closed ? n : n - 1;
    const auto point = [&](std::size_t k) -> const Eigen::Vector3d& { return points[k % n]; };
    // The tangent between two consecutive segments; zero at a corner.
    const auto tangent = [&](const Eigen::Vector3d& before, const Eigen::Vector3d& after) {
        constexpr double least_cosine = 0.97;
        const double a = before.norm(), b = after.norm();
        if (!(a > 0.0 && b > 0.0) || before.dot(after) < least_cosine * a * b)
            return Eigen::Vector3d::Zero().eval();
        return ((b / a) * before / (a + b) + (a / b) * after / (a + b)).eval();
    };
    std::vector<CubicPiece> pieces;
    for (std::size_t k = 0; k < n_segments; ++k) {
        const Eigen::Vector3d run = point(k + 1) - point(k);
        const double length = run.norm();
        Eigen::Vector3d leaving = Eigen::Vector3d::Zero(), arriving = leaving;
        if (k > 0 || geometry.closed) leaving = tangent(point(k) - point(k + n - 1), run);
        if (k + 1 < n_segments || geometry.closed)
            arriving = tangent(run, point(k + 2) - point(k + 1));
        const Eigen::Vector3d straight = run / 3.0;
        const Eigen::Vector3d from = leaving.isZero(0.0) ? straight : length / 3.0 * leaving;
        const Eigen::Vector3d to = arriving.isZero(0.0) ? straight : length / 3.0 * arriving;
        pieces.push_back({static_cast<double>(k),
                          static_cast<double>(k + 1),
                          {point(k), point(k) + from, point(k + 1) - to, point(k + 1)}});
    }
    return pieces;
}

// The track of a smooth form, placed in the view.
Track placed_track(const SmoothForm& smooth, const Eigen::Affine3d& placement, double first,
                   double last) {
    Track track;
    const auto place = [placement](const CurveFlow& flow) {
        return CurveFlow{placement * flow.position, placement.linear() * flow.velocity};
    };
    if (const Conic* conic = std::get_if<Conic>(&smooth.form)) {
        Track own = track_of(*conic, first, last);
        track.knots = std::move(own.knots);
        track.flow = [place, flow = std::move(own.flow)](double s) { return place(flow(s)); };
        return track;
    }
    const auto& pieces = std::get<std::vector<CubicPiece>>(smooth.form);
    track.knots.push_back(first);
    for (const CubicPiece& piece : pieces)
        if (first < piece.from && piece.from < last) track.knots.push_back(piece.from);
    track.knots.push_back(last);
    track.flow = [place, flow = flow_of(pieces)](double s) { return place(flow(s)); };
    return track;
}

// The smooth form of a curve, accurate to a fraction of a micrometre on paper.
SmoothForm form_of(const Canvas& canvas, const Curve& curve) {
    const CurveGeometry& geometry = *curve.geometry;
    if (geometry.smooth) {
        const double stretch = curve.placement.linear().jacobiSvd().singularValues()[0] *
                               canvas.projection.scale(std::max(
                                   canvas.projection.depth(canvas.view.camera.target), 1e-9));
        // Parts nearer than the camera's target appear larger, by less than this factor.
        constexpr double nearer = 2.0;
        if (stretch > 0.0) return geometry.smooth(form_tolerance_pt / (nearer * stretch));
    }
    SmoothForm smooth;
    smooth.form = through_points(geometry);
    for (std::size_t k = 0; k < geometry.points.size() + (geometry.closed ? 1 : 0); ++k)
        smooth.parameters.push_back(static_cast<double>(k));
    return smooth;
}

// Parameters at which the opacity changes by a step: a trail fades behind its head.
std::vector<double> fading_steps(const Curve& curve, double fade_end, const SmoothForm& smooth) {
    std::vector<double> steps;
    constexpr int n_fades = 16;
    for (int k = 0; k < n_fades && curve.fade_points > 0.0; ++k)
        steps.push_back(
            smooth.parameter_at(fade_end - curve.fade_points * (1.0 - 1.0 * k / n_fades)));
    return steps;
}

// Whether a span is dashed because a body hides it. Planes are glass.
bool is_dashed(const Curve& curve, const Span& span) {
    return curve.hidden == HiddenStyle::dashed && span.cover.before_bodies < 0.5;
}

double stroke_width_pt(const Canvas& canvas, const Curve& curve, bool hidden) {
    const bool thins = hidden && !curve.stands_for_hidden;
    return canvas.line_pt((thins ? curve.hidden_share : 1.0) * curve.width_px);
}

// The dashes of hidden parts: in proportion to the line's width, and on a short curve shorter.
Dash hidden_dash(const Canvas& canvas, const Curve& curve, double drawn_pt) {
    constexpr double least_widths = 3.0, most_widths = 6.0, gap_share = 0.5;
    const double width = stroke_width_pt(canvas, curve, true);
    const double on = std::clamp(drawn_pt / 16.0, least_widths * width, most_widths * width);
    return {on, gap_share * on};
}

// A dashed stretch of a curve.
struct DashedStretch {
    double from = 0.0, to = 0.0;
    DashPattern pattern;
};

// Lays out the dashes of a curve.
class Dashes {
 public:
    Dashes(const Canvas& canvas, const Curve& curve, const Track& track,
           const std::vector<Span>& spans, bool closed)
        : canvas_(canvas), track_(track), closed_(closed) {
        const double first = track.knots.front(), last = track.knots.back();
        if (curve.dash_px > 0.0) {
            // Dashed throughout, whether hidden or not.
            const double gap_px = curve.gap_px > 0.0 ? curve.gap_px : curve.dash_px;
            add({canvas.pt(curve.dash_px), canvas.pt(gap_px)}, first, last, DashEnd::dash,
                DashEnd::dash);
            return;
        }
        if (std::none_of(spans.begin(), spans.end(),
                         [&](const Span& span) { return is_dashed(curve, span); }))
            return;
        const Dash wanted = hidden_dash(canvas, curve, length(first, last));
        const auto is_solid = [&](std::size_t k) {
            return !is_dashed(curve, spans[k]) && !curve.stands_for_hidden;
        };
        for (std::size_t k = 0; k < spans.size();) {
            std::size_t end = k + 1;
            if (is_dashed(curve, spans[k])) {
                while (end < spans.size() && is_dashed(curve, spans[end]) &&
                       spans[end].from == spans[end - 1].to)
                    ++end;
                const bool after = k > 0 && spans[k - 1].to == spans[k].from && is_solid(k - 1);
                const bool before =
                    end < spans.size() && spans[end].from == spans[end - 1].to && is_solid(end);
                add(wanted, spans[k].from, spans[end - 1].to, after ? DashEnd::gap : DashEnd::dash,
                    before ? DashEnd::gap : DashEnd::dash);
            }
            k = end;
        }
        if (closed && stretches_.size() > 1 && stretches_.front().from == first &&
            stretches_.back().to == last)
            join_ends(wanted);
    }

    // Gives a stroke that begins at a parameter its dashes; none outside dashed stretches.
    void dash(Stroke& stroke, double from) const {
        for (const DashedStretch& stretch : stretches_) {
            if (!(stretch.from <= from && from < stretch.to)) continue;
            stroke.dashes_pt = stretch.pattern.lengths_pt;
            stroke.dash_offset_pt = stretch.pattern.offset_pt + length(stretch.from, from);
        }
    }

 private:
    double length(double from, double to) const {
        return length_on_paper(canvas_.projection, track_, from, to);
    }

    void add(const Dash& wanted, double from, double to, DashEnd begin, DashEnd end) {
        const double whole = length(from, to);
        if (!(whole > 0.0)) return;
        if (closed_ && from == track_.knots.front() && to == track_.knots.back()) {
            // A closed curve begins in the middle of a gap.
            const Dash dash = fitted_dash(wanted, whole);
            stretches_.push_back(
                {from, to, {{dash.on_pt, dash.off_pt}, dash.on_pt + 0.5 * dash.off_pt}});
            return;
        }
        std::vector<double> cuts = corners_between(canvas_.projection, track_, from, to);
        cuts.push_back(to);
        std::vector<double> pieces;
        double at = from;
        for (const double cut : cuts) {
            pieces.push_back(length(at, cut));
            at = cut;
        }
        stretches_.push_back({from, to, dashes_along(wanted, pieces, begin, end)});
    }

    // The last stretch of a closed curve continues in the first.
    void join_ends(const Dash& wanted) {
        DashedStretch &front = stretches_.front(), &back = stretches_.back();
        const double before = length(back.from, back.to);
        const double whole = before + length(front.from, front.to);
        front.pattern = back.pattern = dashes_along(wanted, {{whole}}, DashEnd::gap, DashEnd::gap);
        front.pattern.offset_pt += before;
    }

    const Canvas& canvas_;
    const Track& track_;
    bool closed_;
    std::vector<DashedStretch> stretches_;
};

// The visible share of a span.
double share_shown(const Curve& curve, const Cover& cover) {
    const double glass = seen_through_planes(cover);
    const double through = std::max(curve.hidden_opacity, cover.through_bodies);
    if (curve.stands_for_hidden) return glass * (1.0 - cover.before_bodies) * through;
    if (curve.hidden == HiddenStyle::dimmed) {
        const double hidden = std::max(curve.hidden_opacity, cover.transmitted);
        return cover.clear + (1.0 - cover.clear) * hidden;
    }
    const double hidden = curve.hidden == HiddenStyle::absent ? 0.0 : through;
    return glass * (cover.before_bodies + (1.0 - cover.before_bodies) * hidden);
}

bool shows(const Curve& curve) {
    return curve.geometry != nullptr && curve.opacity > 0.0 && curve.width_px > 0.0 &&
           curve.geometry->points.size() > 1 && curve.first <= curve.last;
}

}  // namespace

void draw_curve(const Canvas& canvas, const Curve& curve) {
    if (!shows(curve)) return;
    const CurveGeometry& geometry = *curve.geometry;
    const double n_segments =
        static_cast<double>(geometry.points.size()) - (geometry.closed ? 0.0 : 1.0);
    const double first_point = std::clamp(curve.first, 0.0, n_segments);
    const double last_point = std::clamp(curve.last, 0.0, n_segments);
    const SmoothForm smooth = form_of(canvas, curve);
    const double first = smooth.parameter_at(first_point), last = smooth.parameter_at(last_point);
    if (!(first < last)) return;
    const Track track = placed_track(smooth, curve.placement, first, last);
    const Membership of{curve.on_surface, curve.on_plane};
    std::vector<Span> spans;
    if (curve.occlusion == Occlusion::by_solids)
        spans = canvas.occluders.spans(track, of);
    else
        spans = {{first, last, {}}};

    const bool is_closed = geometry.closed && first_point == 0.0 && last_point == n_segments;
    const Dashes dashes(canvas, curve, track, spans, is_closed);
    const std::vector<double> steps =
        fading_steps(curve, std::max(last_point, curve.fade_end), smooth);
    for (const Span& span : spans) {
        const double opacity = curve.opacity * share_shown(curve, span.cover);
        std::vector<double> cuts{span.from};
        for (const double step : steps)
            if (span.from < step && step < span.to) cuts.push_back(step);
        cuts.push_back(span.to);
        for (std::size_t k = 1; k < cuts.size(); ++k) {
            const double middle = 0.5 * (cuts[k - 1] + cuts[k]);
            double faded = opacity;
            if (!steps.empty()) {
                const auto after = std::upper_bound(steps.begin(), steps.end(), middle);
                faded *= (static_cast<double>(after - steps.begin()) - 0.5) /
                         static_cast<double>(steps.size());
            }
            if (faded < 1e-3) continue;
            const auto look_at = [&](double s) {
                const Colour behind =
                    canvas.behind(canvas.projection.place(track.flow(s).position));
                return Canvas::LineLook{curve.colour, faded, behind};
            };
            std::vector<Canvas::ConstantColourSpan> parts{
                {cuts[k - 1], cuts[k], {curve.colour, faded}}};
            if (faded < 1.0 && steps.empty())
                parts = canvas.constant_colour_spans(track, cuts[k - 1], cuts[k], look_at);
            else if (faded < 1.0)
                parts.front().ink = as_in_light(curve.colour, faded, look_at(middle).behind);
            for (const Canvas::ConstantColourSpan& part : parts) {
                Stroke stroke;
                stroke.path = canvas.path_of(track, part.from, part.to, curve_tolerance_pt,
                                             form_tolerance_pt);
                const bool whole = part.from == first && part.to == last;
                if (whole && is_closed) stroke.path.close();
                stroke.ink = part.ink;
                stroke.width_pt = stroke_width_pt(canvas, curve, is_dashed(curve, span));
                dashes.dash(stroke, part.from);
                stroke.round = whole && stroke.dashes_pt.empty();
                canvas.add(std::move(stroke));
            }
        }
    }
}

}  // namespace poinsot::vector
