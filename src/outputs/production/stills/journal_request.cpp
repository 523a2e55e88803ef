#include "production/stills/journal_request.h"

#include <fmt/format.h>

#include <string_view>

#include "production/vectors/journal.h"

namespace poinsot {

void apply_journal_style(bool keeps_text, SceneRequest& request, const Task& task) {
    set_journal(journal_named(request.print.journal), request.print);
    constexpr std::string_view theme = "print";
    const Scene scene = scene_of(request);
    if (!is_given(request.overrides, "theme")) {
        if (scene.locations.contains("theme") && scene.theme != theme)
            task.say(
                fmt::format("note: {} is drawn in theme {}, not in its own theme {}; "
                            "--theme {} keeps that",
                            request.file, theme, scene.theme, scene.theme));
        request.overrides.push_back({"theme", std::string(theme), "--journal"});
    } else if (scene.theme != theme) {
        task.say(
            fmt::format("note: {} is drawn in theme {}, as the command line says; the default "
                        "for journals is {}",
                        request.file, scene.theme, theme));
    }
    if (!keeps_text && !scene.locations.contains("overlays"))
        request.overrides.push_back({"overlays", "false", "--journal"});
    if (!scene.locations.contains("panel_letters"))
        request.overrides.push_back({"panel_letters", "true", "--journal"});
}

}  // namespace poinsot
