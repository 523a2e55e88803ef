#include "orders/film.h"

#include <fmt/format.h>

#include "encoding/frame_sink.h"
#include "error/error.h"
#include "production/films/film_job.h"
#include "production/films/jobs.h"
#include "production/slides/pptx_deck.h"
#include "production/slides/slide_deck.h"
#include "system/interrupt.h"
#include "text/printable.h"
#include "web/pack/page_job.h"

namespace poinsot {

namespace {

// Kinds of outputs, as bits.
enum Kind : unsigned { film = 1, page = 2, presentation = 4, slides = 8 };

Kind kind_of(const FilmOrder& order) {
    if (!order.slides.empty()) return slides;
    if (is_page_name(order.output)) return page;
    return is_slides_name(order.output) ? presentation : film;
}

// Why an output has none of some options.
std::string reason(const FilmOrder& order, Kind kind) {
    if (kind == slides) return "--slides writes a film for each stop into its folder";
    return printable(order.output) + (kind == page
                                          ? ": a page has no frames, it shows every instant"
                                          : ": a presentation has a film for each stop");
}

}  // namespace

void check_order(const FilmOrder& order) {
    struct Row {
        std::string_view option;
        bool is_given;
        unsigned outputs;  // that can have it
    };
    const Row rows[] = {{"output", !order.output.empty(), film | page | presentation},
                        {"frames", order.frames.has_value(), film},
                        {"part", order.part.has_value(), film},
                        {"jobs", order.n_jobs.has_value(), film | presentation | slides},
                        {"certify", order.certify, film | presentation | slides}};
    const Kind kind = kind_of(order);
    for (const Row& row : rows)
        if (row.is_given && (row.outputs & kind) == 0)
            throw InputError(fmt::format("{}; leave --{} out", reason(order, kind), row.option));
    constexpr int most = 4096;
    if (order.n_jobs && (*order.n_jobs < 1 || *order.n_jobs > most))
        throw InputError(
            fmt::format("--jobs {}: not a number of processes; give 1 to {}", *order.n_jobs, most));
    if (order.n_jobs && *order.n_jobs > 1 && order.part)
        throw InputError(
            "one process draws a --part; leave --jobs out, or draw all parts here with --jobs "
            "alone");
    if (order.frames && (order.frames->first < 0 || order.frames->second < order.frames->first))
        throw InputError(fmt::format(
            "--frames {} to {}: not a range of frames; give the first and the last one, from 0",
            order.frames->first, order.frames->second));
}

bool make_output(const SceneRequest& scene, const FilmOrder& order, const FilmCaller& caller,
                 LazyRenderer& renderer, const Task& task) {
    const StopsWhen stops(task.stop);
    const Kind kind = kind_of(order);
    if (kind == page) {
        write_page(scene, order.output, renderer, task);
        return true;
    }
    const Session& session = caller.session();
    FilmRequest request{order.output, order.frames};
    request.part = order.part;
    // A film that is less accurate than its method claims is refused before it is drawn, and frames
    // outside of it before it is measured.
    const FilmPlan plan = kind == film ? FilmJob(session, request).film() : film_plan(session);
    if (order.certify && !caller.accepts(session, plan)) return false;
    if (kind == slides)
        write_deck(session, {scene, order.slides, order.n_jobs}, renderer, task);
    else if (kind == presentation)
        write_pptx(session, {order.output, order.n_jobs}, renderer, task);
    else if (order.part)
        FilmJob(session, request).make(renderer, task);
    else
        make_in_jobs(session, request, order.n_jobs, renderer, task);
    return true;
}

}  // namespace poinsot
