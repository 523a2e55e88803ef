// [measured]: reads the table of a measured motion.
#include <fmt/format.h>

#include "measured/table_faults.h"
#include "scene/draft_checks.h"
#include "text/printable.h"

namespace poinsot {

void complete_measured(SceneDraft& draft) {
    Scene& scene = draft.scene;
    MeasuredSpec& measured = scene.measured;
    const std::string key = "measured.file";
    if (measured.file.empty()) {
        if (draft.has("measured"))
            refuse(scene, draft.has(key) ? key : "measured",
                   "measured.file is missing; name a table in the scene's folder");
        return;
    }
    const FileBytes file = file_named(draft, NamedFile::Kind::table, key, measured.file);
    measured.motion = at_file_key(scene, key, [&] {
        if (file.bytes.size() > most_table_bytes)
            throw InputError(
                fmt::format("{} is larger than {} MiB; cut it to the time that the film shows",
                            printable(measured.file), most_table_bytes >> 20));
        return read_measured(file.bytes, file.name);
    });
    if (!measured.motion.has_omega) {
        if (measured.motion.rows.size() < 2)
            refuse(
                scene, key,
                fmt::format("{} has one attitude, from which no ω follows; give two or more rows",
                            printable(measured.file)));
        add_omega_by_differences(measured.motion);
        for (const MeasuredRow& row : measured.motion.rows)
            if (!row.omega_body.allFinite())
                refuse(scene, key,
                       fmt::format("the attitudes of {} at {} s are too close in time to "
                                   "differentiate; check the unit of time",
                                   printable(measured.file), row.time_s));
        measured.has_derived_omega = true;
        scene.notes.push_back(fmt::format(
            "{} has no ω; it is computed from the differences of its attitudes", measured.file));
    }
    for (const Saturation& saturation : saturations_of(measured.motion.rows))
        scene.notes.push_back(fmt::format("{}: {}", measured.file, in_words(saturation)));
}

}  // namespace poinsot
