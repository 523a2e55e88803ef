#include <fmt/format.h>
#include <poinsot/scene.h>

#include <algorithm>
#include <atomic>
#include <utility>

#include "error/error.h"
#include "library/production/drawing_thread.h"
#include "library/production/scene_access.h"
#include "measured/departure.h"
#include "orders/film.h"
#include "orders/still.h"
#include "production/sampling/sample_table.h"
#include "production/session/files/open_session.h"
#include "production/session/scene_summary.h"
#include "production/stills/prepared_still.h"
#include "system/interrupt.h"
#include "text/json_text.h"
#include "text/printable.h"

namespace poinsot::library {

namespace {

// What pictures and figures have in common.
template <typename Options>
GivenOptions given_of(const Options& options) {
    return {.time_s = options.time_s,
            .clearest = options.clearest,
            .paper = options.paper,
            .context = options.context};
}

// A session that says nothing; the caller can stop its stepping.
Session quiet_session(const SceneRequest& request, const Watch& watch) {
    leave_signals_to_host();
    return open_session(request, {.stop = watch.stop});
}

// Notes and the journal's report, on the caller's thread.
void tell(const PreparedStill& still, const Watch& watch) {
    if (watch.say) tell_notes(still, {.say = watch.say});
    if (const std::string lines = watch.report ? journal_report(still) : ""; !lines.empty())
        watch.report(lines);
}

}  // namespace

struct Still::Impl {
    PixelStill still;
};

int Still::width_px() const { return impl_->still.image.width(); }
int Still::height_px() const { return impl_->still.image.height(); }
std::span<const std::uint8_t> Still::rgba() const { return impl_->still.image.bytes(); }
std::vector<std::uint8_t> Still::png() const {
    return encode_png(impl_->still.image, impl_->still.png);
}
const std::string& Still::bound() const { return impl_->still.bound; }

// The request and, once it was needed, the scene's session.
struct Scene::Impl {
    SceneRequest request;
    poinsot::Scene scene;
    // Opened at the first use, by several threads if they need it at the same time, of which the
    // first to finish keeps its own. A lock might be held by another thread when a process forks.
    mutable std::atomic<const Session*> opened = nullptr;

    Impl() = default;
    ~Impl() { delete opened.load(); }
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    const Session& session(const Watch& watch) const {
        const Session* there = opened.load();
        if (there != nullptr) return *there;
        auto made = std::make_unique<const Session>(quiet_session(request, watch));
        return opened.compare_exchange_strong(there, made.get()) ? *made.release() : *there;
    }

    // For these instants, too: outside of the film, a stepped motion is computed again.
    Session session_at(std::vector<double> times_s, const Watch& watch) const {
        const Session& of_film = session(watch);
        if (!is_stepped(of_film.motion.problem().method) || times_s.empty()) return of_film;
        SceneRequest longer = request;
        longer.times_s = std::move(times_s);
        return quiet_session(longer, watch);
    }
};

Scene Scene::from_file(const std::string& file, const std::vector<std::string>& values,
                       bool allow_outside) {
    return from_text(text_of_file(file), file, values, allow_outside);
}

Scene Scene::from_text(const std::string& text, const std::string& name,
                       const std::vector<std::string>& values, bool allow_outside) {
    return SceneAccess::of(
        {.file = name,
         .text = text,
         .overrides = overrides_of(values),
         .outside = allow_outside ? OutsideFiles::allowed : OutsideFiles::refused});
}

Scene SceneAccess::of(SceneRequest request) {
    auto contents = std::make_shared<Scene::Impl>();
    contents->request = std::move(request);
    contents->scene = scene_of(contents->request);
    return Scene(std::move(contents));
}

Scene SceneAccess::with(const Scene& scene, const std::vector<Override>& more) {
    SceneRequest request = scene.impl_->request;
    request.overrides.insert(request.overrides.end(), more.begin(), more.end());
    return of(std::move(request));
}

Scene Scene::with(const std::vector<std::string>& values) const {
    return SceneAccess::with(*this, overrides_of(values));
}

std::string Scene::name() const { return impl_->scene.name; }
std::string Scene::title() const { return title_of(impl_->scene); }
const std::string& Scene::text() const { return *impl_->request.text; }
std::vector<std::string> Scene::values() const {
    std::vector<std::string> values;
    for (const Override& given : impl_->request.overrides) values.push_back(given.assignment());
    return values;
}
const std::string& Scene::file() const { return impl_->request.file; }
bool Scene::allows_outside() const { return impl_->request.outside == OutsideFiles::allowed; }
int Scene::width_px() const { return impl_->scene.film.width_px; }
int Scene::height_px() const { return impl_->scene.film.height_px; }
std::string Scene::language() const { return impl_->scene.language; }

std::string Scene::check_json(const Watch& watch) const {
    const SceneSummary summary = summarise(impl_->session(watch), false);
    JsonObject answer;
    for (const SummaryLine& line : summary.lines) answer.json(line.key, line.json);
    return answer.lines();
}

Table Scene::sample(std::span<const double> times_s, const std::vector<std::string>& columns,
                    const Watch& watch) const {
    const Session session = impl_->session_at({times_s.begin(), times_s.end()}, watch);
    const std::vector<ChosenColumn> chosen =
        columns.empty() ? default_columns(session.motion) : columns_named(session.motion, columns);
    const StopsWhen stops(watch.stop);
    SampleTable sampled = sample_columns(session.motion, chosen, times_s, "times");
    Table table;
    table.names = std::move(sampled.headings);
    table.n_rows = times_s.size();
    table.values = std::move(sampled.values);
    return table;
}

Table Scene::departure(std::span<const double> times_s, std::span<const double> omega,
                       std::span<const double> attitude, const Watch& watch) const {
    const std::size_t n = times_s.size();
    if (omega.empty() && attitude.empty())
        throw InputError("the rows have neither ω nor attitudes; give one of both");
    if ((!omega.empty() && omega.size() != 3 * n) ||
        (!attitude.empty() && attitude.size() != 4 * n))
        throw InputError("give three numbers of ω and four of the attitude for each instant");
    const Session session = impl_->session_at({times_s.begin(), times_s.end()}, watch);
    const StopsWhen stops(watch.stop);
    Departure departure(session.motion);
    std::vector<DepartureAt> rows;
    rows.reserve(n);
    for (std::size_t i = 0; i < n; ++i) {
        constexpr std::size_t rows_between_looks = 1000;
        if (i % rows_between_looks == 0) stop_if_interrupted();
        MeasuredRow row;
        row.time_s = times_s[i];
        if (!omega.empty()) row.omega_body = Eigen::Map<const Eigen::Vector3d>(&omega[3 * i]);
        if (!attitude.empty())
            row.space_from_body = Eigen::Quaterniond(attitude[4 * i], attitude[4 * i + 1],
                                                     attitude[4 * i + 2], attitude[4 * i + 3])
                                      .normalized();
        departure.add(row, !omega.empty(), !attitude.empty());
        rows.push_back(departure.last());
    }
    Table table;
    table.n_rows = n;
    using Member = std::optional<double> DepartureAt::*;
    constexpr std::pair<const char*, Member> columns[] = {
        {"attitude_rad", &DepartureAt::attitude_rad},
        {"omega_rad_s", &DepartureAt::omega_rad_s},
        {"omega_share", &DepartureAt::omega_share},
        {"energy_share", &DepartureAt::energy_share},
        {"momentum_share", &DepartureAt::momentum_share},
        {"momentum_tilt_rad", &DepartureAt::momentum_tilt_rad}};
    for (const auto& [name, member] : columns) {
        if (std::none_of(rows.begin(), rows.end(), [member = member](const DepartureAt& row) {
                return (row.*member).has_value();
            }))
            continue;
        table.names.emplace_back(name);
        for (const DepartureAt& row : rows) table.values.push_back((row.*member).value_or(0.0));
    }
    return table;
}

Still SceneAccess::still(const Scene& scene, const GivenOptions& given, const Watch& watch) {
    if (!given.overrides.empty()) {
        GivenOptions rest = given;
        rest.overrides.clear();
        return still(with(scene, given.overrides), rest, watch);
    }
    const Scene::Impl& of = *scene.impl_;
    StillOrder order = still_order(of.request, given, "", {});
    // Without a size on paper, the session of the scene serves.
    const bool is_for_paper =
        print_size_of(order.still.print, scene.width_px(), scene.height_px()).has_value();
    Session session = is_for_paper ? quiet_session(order.scene, watch)
                                   : of.session_at(order.scene.times_s, watch);
    const PreparedStill still = prepare_still(std::move(session), std::move(order.still));
    tell(still, watch);
    auto made = std::make_shared<Still::Impl>();
    draw(context_choice_of(given), watch, [&still, &made](LazyRenderer& renderer, const Task&) {
        made->still = still_in_memory(still, renderer);
    });
    return Still(std::move(made));
}

std::string SceneAccess::figure(const Scene& scene, const GivenOptions& given,
                                const std::string& format, const Watch& watch) {
    if (format != "svg" && format != "pdf")
        throw InputError(fmt::format("format \"{}\": a figure is svg or pdf; choose one of these",
                                     printable(format)));
    if (given.vectors.text == "latex")
        throw InputError(
            "text \"latex\": needs a .tex file beside the figure; write it with poinsot still");
    SceneRequest request = scene.impl_->request;
    request.overrides.insert(request.overrides.end(), given.overrides.begin(),
                             given.overrides.end());
    StillOrder order = still_order(std::move(request), given, "figure." + format, {});
    check_vector_choices(order.still.vectors);
    const PreparedStill still =
        prepare_still(quiet_session(order.scene, watch), std::move(order.still));
    tell(still, watch);
    VectorStill drawn;
    if (opens_context(still)) {
        draw(context_choice_of(given), watch,
             [&still, &drawn](LazyRenderer& renderer, const Task&) {
                 drawn = vectors_of(still, renderer);
             });
    } else {
        LazyRenderer unused;
        drawn = vectors_of(still, unused);
    }
    if (watch.say) watch.say(fmt::format("paths within {:.2g} um of what they show", drawn.off_um));
    return std::move(drawn.bytes);
}

void SceneAccess::film(const Scene& scene, FilmOrder order, const GivenOptions& given,
                       const Watch& watch) {
    order.frames = given.frames;
    check_order(order);
    order.n_jobs = 1;
    const Scene changed = given.overrides.empty() ? scene : with(scene, given.overrides);
    const Scene::Impl& of = *changed.impl_;
    // A page is made from the request; what else there is, from a session that the caller's thread
    // opens, so that it can be stopped.
    const Session* opened = is_page_name(order.output) ? nullptr : &of.session(watch);
    draw(context_choice_of(given), watch, [&](LazyRenderer& renderer, const Task& task) {
        make_output(of.request, order, {.session = [&]() -> const Session& { return *opened; }},
                    renderer, task);
    });
}

Still Scene::still(const StillOptions& options, const Watch& watch) const {
    return SceneAccess::still(*this, given_of(options), watch);
}

std::string Scene::figure(const FigureOptions& options, const Watch& watch) const {
    GivenOptions given = given_of(options);
    given.vectors = {options.shading, options.text};
    return SceneAccess::figure(*this, given, options.format, watch);
}

void Scene::render(const std::string& path, const RenderOptions& options,
                   const Watch& watch) const {
    if (path.empty()) throw InputError("the output has no name; give one, as film.mp4");
    SceneAccess::film(*this, {.output = path},
                      {.frames = options.frames, .context = options.context}, watch);
}

void Scene::slides(const std::string& folder, const ContextOptions& context,
                   const Watch& watch) const {
    if (folder.empty()) throw InputError("the folder of the slides has no name; give one");
    SceneAccess::film(*this, {.slides = folder}, {.context = context}, watch);
}

}  // namespace poinsot::library
