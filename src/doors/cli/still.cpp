// poinsot still SCENE -o OUT.png: renders one picture.
#include "orders/still.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <future>
#include <memory>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "cli/command.h"
#include "cli/option_values.h"
#include "cli/options.h"
#include "cli/progress_bar.h"
#include "cli/scenes.h"
#include "cli/sweep.h"
#include "encoding/frame_name.h"
#include "error/error.h"
#include "production/slides/slide_plan.h"
#include "production/stills/contact_sheet.h"
#include "production/stills/output_place.h"
#include "production/stills/prepared_still.h"
#include "text/label_text.h"
#include "text/printable.h"

namespace poinsot {

namespace {

struct StillChoices {
    std::vector<std::string> scenes;
    std::string output;
    std::vector<std::string> sweeps;
    GivenOptions given;
    bool chapters = false;                     // --chapters
    std::optional<std::pair<int, int>> sheet;  // columns, rows
    bool quiet = false;
};

// Throws InputError for an option that a sheet cannot have.
void check_sheet(const StillChoices& choices) {
    const bool is_page = is_vector_name(choices.output);
    const auto refuse = [&](const std::string& flag) {
        throw InputError(
            fmt::format("--sheet: a {0} of several pictures cannot have {1}; leave "
                        "{1} out, or draw stills without --sheet",
                        is_page ? "page" : "PNG", flag));
    };
    for (const OptionRow& row : option_rows())
        if ((row.verbs & (Verb::still | Verb::figure)) != 0 &&
            (row.verbs & (is_page ? Verb::figure_sheet : Verb::sheet)) == 0 &&
            is_given(row, choices.given))
            refuse(row.flag());
    if (choices.given.depth != 8) refuse("--depth");
}

// Renders all scenes at all points of the sweep in one picture.
int draw_sheet_of(const StillChoices& choices) {
    check_sheet(choices);
    SheetRequest sheet;
    sheet.print = print_choices(choices.given.paper);
    sheet.vectors = choices.given.vectors;
    std::tie(sheet.n_columns, sheet.n_rows) = *choices.sheet;
    sheet.output = choices.output;
    sheet.time_s = choices.given.time_s;
    if (choices.given.clearest) sheet.when = StillTime::clearest;
    for (const std::string& scene : choices.scenes) {
        for (const SweepPoint& point : points_of(choices.sweeps)) {
            SheetCell& cell = sheet.cells.emplace_back();
            cell.scene = scene_request(scene, choices.given, overrides_of(point));
            // Its values stand below each picture; the scene's title and caption are those of one.
            if (!is_given(cell.scene.overrides, "overlays"))
                cell.scene.overrides.push_back({"overlays", "false", "--sheet"});
            if (choices.given.time_s) cell.scene.times_s = {*choices.given.time_s};
            cell.caption = formula_of(point);
            cell.values = caption_of(point);
            if (choices.scenes.size() > 1 || point.empty()) {
                const std::string name = std::filesystem::path(scene).stem().string();
                const std::string colon = point.empty() ? "" : ": ";
                cell.caption.insert(0, as_caption(name) + colon);
                cell.values.insert(0, name + colon);
            }
        }
    }
    ProgressBar bar(choices.quiet);
    LazyRenderer renderer(context_choice_of(choices.given));
    draw_sheet(sheet, renderer, bar.task());
    return 0;
}

StillOrder order_of(const SceneJob& job, const StillChoices& choices, const Task& task) {
    return still_order(scene_request(job.scene, choices.given, job.overrides), choices.given,
                       job.output, task);
}

PreparedStill still_of(const SceneJob& job, const StillChoices& choices, const Task& task) {
    StillOrder order = order_of(job, choices, task);
    return prepare_still(open_session(order.scene, task), std::move(order.still));
}

// Draws a picture at each stop of a scene, numbered from 1.
int draw_chapters(const SceneJob& job, const StillChoices& choices, LazyRenderer& renderer,
                  StillWriter& writer, const Task& task) {
    if (!job.output.empty() && !has_frame_number(job.output))
        throw InputError(fmt::format(
            "{}: --chapters writes several pictures; put #### into the name for their number{}",
            printable(choices.output),
            choices.scenes.size() > 1 || !choices.sweeps.empty()
                ? ", and {scene} or {KEY} for the scene or the swept value"
                : ""));
    const StillOrder order = order_of(job, choices, task);
    const Session session = open_session(order.scene, task);
    const std::vector<Slide> stops = stops_of(session.scene, film_plan(session), "--chapters");
    const OutputPlace place(job.output, session.scene, "_####.png");
    for (std::size_t i = 0; i < stops.size(); ++i)
        place.check(frame_name(place.path(), static_cast<std::int64_t>(i) + 1));
    // The notes are the same for all pictures, and so, as a rule, is the accuracy: the lines after
    // the name of a picture.
    const auto said = std::make_shared<std::set<std::string>>();
    Task once = task;
    once.say = [say = task.say, said](const std::string& words) {
        const std::size_t end = words.find('\n');
        const std::string after = end == std::string::npos ? "" : words.substr(end);
        say(said->insert(after).second ? words : words.substr(0, end));
    };
    Task without_notes = once;
    without_notes.say = [say = once.say](const std::string& words) {
        if (!words.starts_with("note: ")) say(words);
    };
    for (std::size_t i = 0; i < stops.size(); ++i) {
        StillRequest still = order.still;
        still.output = frame_name(place.path(), static_cast<std::int64_t>(i) + 1).string();
        still.frame = stops[i].last_frame;
        // A picture of the film's size is the film's frame; one for paper is a figure.
        still.names_fade =
            !is_vector_name(still.output) && !still.print.width_mm && !still.print.height_mm;
        draw_still(prepare_still(Session(session), std::move(still)), renderer, writer,
                   i == 0 ? once : without_notes);
    }
    writer.finish();
    return 0;
}

void check_chapters(const StillChoices& choices) {
    const std::pair<bool, std::string_view> options[] = {
        {choices.given.time_s || choices.given.clearest, "--time"},
        {choices.sheet.has_value(), "--sheet"}};
    for (const auto& [is_given, option] : options)
        if (is_given)
            throw InputError(fmt::format(
                "--chapters and {} cannot be used together; leave one of them out", option));
}

// Each scene is read and prepared while the previous one is drawn.
int draw_all(const std::vector<SceneJob>& jobs, const StillChoices& choices, LazyRenderer& renderer,
             StillWriter& writer, const Task& task) {
    // If no thread can be started, the scene is prepared when it is needed.
    const auto begin = [&](std::size_t k) {
        return std::async(
            [&job = jobs[k], &choices, &task] { return still_of(job, choices, task); });
    };
    // Opened before another thread starts, because it changes environment variables that libraries
    // read.
    const auto opens_context = [&choices](const SceneJob& job) {
        return !is_vector_name(job.output) || choices.given.vectors.shading == "picture";
    };
    if (std::any_of(jobs.begin(), jobs.end(), opens_context)) renderer.context();
    int worst = 0;
    Refusals refusals;
    std::future<PreparedStill> next = begin(0);
    for (std::size_t k = 0; k < jobs.size(); ++k) {
        std::future<PreparedStill> still = std::exchange(next, {});
        still.wait();
        if (k + 1 < jobs.size()) next = begin(k + 1);
        worst = std::max(worst, refusals.code_of(jobs[k], [&] {
            draw_still(still.get(), renderer, writer, task);
            return 0;
        }));
    }
    refusals.say_others();
    return worst;
}

void draw_alone(const SceneJob& job, const StillChoices& choices, LazyRenderer& renderer,
                StillWriter& writer, const Task& task) {
    constexpr std::int64_t small_px = 1 << 24;
    const PreparedStill still = still_of(job, choices, task);
    if (opens_context(still) && n_pixels(still) <= small_px) renderer.compile_quickly();
    draw_still(still, renderer, writer, task);
}

int run(const StillChoices& choices) {
    if (choices.chapters) check_chapters(choices);
    if (choices.sheet) return draw_sheet_of(choices);
    const std::vector<SceneJob> jobs =
        jobs_of(choices.scenes, choices.output,
                choices.chapters ? OutputKind::pictures : OutputKind::picture, choices.sweeps);
    ProgressBar bar(choices.quiet);
    const Task task = bar.task();
    StillWriter writer;
    std::optional<LazyRenderer> renderer(context_choice_of(choices.given));
    int code = 0;
    if (choices.chapters)
        code = for_each_scene(jobs, [&](const SceneJob& job) {
            return draw_chapters(job, choices, *renderer, writer, task);
        });
    else if (jobs.size() == 1)
        draw_alone(jobs.front(), choices, *renderer, writer, task);
    else
        code = draw_all(jobs, choices, *renderer, writer, task);
    renderer.reset();  // takes as long as compressing half a picture
    writer.finish();
    return code;
}

CommandLine still_line() {
    const auto choices = std::make_shared<StillChoices>();
    StillChoices& c = *choices;
    return {
        &c.scenes,
        joined(
            {{output_option(c.output,
                            "output file; .pdf and .svg give vectors; default output/SCENE.png"),
              set_option(c.given), sweep_option(c.sweeps)},
             options_of(Verb::still | Verb::figure, c.given),
             {{.flags = "--depth",
               .help = "bits per colour component: 8 or 16",
               .value = &c.given.depth,
               .wanted = "8 or 16"},
              {.flags = "--sheet",
               .takes = "CxR",
               .help =
                   "draw all pictures on one sheet of C columns and R rows, each with its values",
               .value = ReadText{[&c](const std::string& text) { c.sheet = parse_sheet(text); }}},
              {.flags = "--chapters",
               .help =
                   "draw a picture at each stop of the scene, or without stops at the end of each "
                   "chapter; #### in the output becomes the picture's number, from 1",
               .value = &c.chapters},
              quiet_option(c.quiet),
              allow_outside_option(c.given.allow_outside)}}),
        [choices] { return run(*choices); }};
}

}  // namespace

extern const Command still_command{
    "still",
    "SCENE",
    1,
    any_number,
    "write one picture of each scene; .pdf and .svg give vectors",
    still_line,
    {{{"poinsot still generic -o generic.png --time 2.5", "the picture at one instant"},
      {"poinsot still generic -o figure.pdf --width-mm 86 --theme print",
       "a vector figure for a column of 86 mm"}}}};

}  // namespace poinsot
