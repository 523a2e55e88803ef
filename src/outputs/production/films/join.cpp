#include "production/films/join.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <system_error>
#include <utility>

#include "encoding/film_parts.h"
#include "encoding/frame_name.h"
#include "error/error.h"
#include "production/films/chapters.h"
#include "production/films/part_mismatch.h"
#include "production/films/recovery.h"
#include "production/films/subtitles.h"
#include "production/records/record.h"
#include "production/records/verify.h"
#include "production/stills/output_place.h"
#include "system/files/atomic_file.h"
#include "system/files/file_contents.h"
#include "system/files/file_kind.h"
#include "system/interrupt.h"
#include "text/printable.h"

namespace poinsot {

namespace {

namespace fs = std::filesystem;

std::string name_of(const fs::path& path) { return printable(path.string()); }

[[noreturn]] void refuse_strangers(const fs::path& one, const fs::path& other,
                                   const std::string& why) {
    throw InputError(
        fmt::format("{} and {} are not parts of one film: {}", name_of(one), name_of(other), why));
}

// Sorts the parts of a film. Throws InputError for an incomplete part, for two with the same
// number, and for a missing one.
void check_all_there(std::vector<PartFile>& parts) {
    std::sort(parts.begin(), parts.end(), [](const PartFile& a, const PartFile& b) {
        return a.part().number < b.part().number;
    });
    for (std::size_t i = 1; i < parts.size(); ++i)
        if (parts[i].part().number == parts[i - 1].part().number)
            throw InputError(fmt::format("{} and {} are both part {} of {}; give one of them",
                                         name_of(parts[i - 1].path()), name_of(parts[i].path()),
                                         parts[i].part().number, parts[i].part().n_parts));
    const FilmPart& first = parts.front().part();
    const std::int64_t chunk = format_for("a." + first.format).n_chunk_frames;
    for (std::int64_t number = 1; number <= first.n_parts; ++number) {
        const auto at = static_cast<std::size_t>(number - 1);
        if (at < parts.size() && parts[at].part().number == number) continue;
        const FilmPart missing = part_of_film(number, first.n_parts, first.n_film_frames, chunk);
        const std::int64_t begin = parts.front().plan().first_frame + missing.n_before;
        throw InputError(fmt::format(
            "part {} of {} is missing (frames {}-{}); draw it with render --part {}/{}, and give "
            "all parts",
            number, first.n_parts, begin, begin + missing.n_frames - 1, number, first.n_parts));
    }
}

void check_whole(const PartFile& part) {
    if (part.is_whole()) return;
    throw InputError(
        fmt::format("{}: part {} of {} is unfinished, cut off or changed: {} of its {} frames are "
                    "whole; run its render command again",
                    name_of(part.path()), part.part().number, part.part().n_parts, part.n_there(),
                    part.part().n_frames));
}

void check_one_film(const PartFile& one, const PartFile& other) {
    const auto record_of_part = [](const PartFile& part) {
        return parse_record(part.plan().metadata, part.path().string());
    };
    if (one.plan().metadata != other.plan().metadata) {
        const std::string why = difference_of(record_of_part(one), record_of_part(other));
        refuse_strangers(one.path(), other.path(), why.empty() ? "their records differ" : why);
    }
    const FilmPart &a = one.part(), &b = other.part();
    if (a.format != b.format)
        refuse_strangers(one.path(), other.path(),
                         fmt::format("one is for a .{}, the other for a .{}", a.format, b.format));
    if (one.settings() != other.settings())
        refuse_strangers(one.path(), other.path(),
                         "they come from different encoders or encoder versions; draw all parts "
                         "with one FFmpeg");
    if (a.n_parts != b.n_parts || a.n_film_frames != b.n_film_frames)
        refuse_strangers(one.path(), other.path(),
                         fmt::format("one is of {} parts, the other of {}", a.n_parts, b.n_parts));
}

std::string join_film(const std::vector<std::string>& names, const std::string& output,
                      const Task& task) {
    std::vector<PartFile> parts;
    for (const std::string& name : names) {
        parts.emplace_back(name);
        check_one_film(parts.front(), parts.back());
        check_whole(parts.back());
    }
    check_all_there(parts);
    const Record record = parse_record(parts.front().plan().metadata, names.front());
    OutputPlan plan = parts.front().plan();
    plan.path = with_scene_name(output, record.scene_name);
    const OutputFormat& format = format_for(plan.path);
    if (format.name != parts.front().part().format)
        throw InputError(
            fmt::format("{}: the parts are for a .{}; end the output's name with this suffix",
                        name_of(plan.path), parts.front().part().format));
    std::error_code not_there;
    for (const PartFile& part : parts)
        if (fs::equivalent(part.path(), plan.path, not_there))
            throw InputError(
                fmt::format("{}: is one of the parts; name another output", name_of(plan.path)));
    plan.seal = sealed_metadata;
    plan.part.reset();
    JoinedEntries entries(parts);
    plan.n_frames = entries.n_entries();
    const bool has_chapters = !parts.front().part().chapters.empty();
    if (has_chapters) check_chapters_place(plan.path);
    if (!plan.subtitles.empty()) check_subtitles_place(plan.path);
    task.begin(record.scene_name, plan.n_frames);
    format.join(entries, plan);
    if (has_chapters)
        write_chapters(plan.path, parts.front().part().chapters);
    else
        remove_stale_chapters(plan.path);
    write_subtitles(plan.path, plan.subtitles);
    task.finish(with_film_length(name_of(plan.path), plan.n_frames, plan.rate));
    return record.bounds;
}

// A picture of a sequence.
struct PartPicture {
    std::int64_t frame;
    fs::path path;
};

// The pictures that match names and patterns.
std::vector<fs::path> pictures_named(const std::vector<std::string>& names) {
    std::vector<fs::path> pictures;
    for (const std::string& name : names) {
        if (!has_frame_number(name)) {
            pictures.emplace_back(name);
            continue;
        }
        for (const std::int64_t frame : frames_there(name))
            pictures.push_back(frame_name(name, frame));
    }
    if (pictures.empty())
        throw InputError(fmt::format("{}: no pictures have this name", printable(names.front())));
    return pictures;
}

Record whole_record_of(const fs::path& path) {
    Record record = read_record(path);
    if (!record.frame || !record.frames)
        throw InputError(fmt::format("{}: is not a picture of a sequence", name_of(path)));
    const Verification checked = verify(path, record);
    if (checked.verified != Verified::yes)
        throw InputError(fmt::format("{}: {}", name_of(path), checked.sentence));
    return record;
}

// Missing frames of sorted pictures, "240-359 and 400"; the first two gaps.
std::string gaps_in(const std::vector<PartPicture>& pictures, std::int64_t first,
                    std::int64_t last) {
    std::string gaps;
    int n_gaps = 0;
    const auto add = [&](std::int64_t begin, std::int64_t end) {
        if (begin > end || ++n_gaps > 3) return;
        gaps += fmt::format("{}{}", n_gaps == 1 ? "" : ", ",
                            n_gaps == 3    ? std::string("…")
                            : begin == end ? fmt::format("{}", begin)
                                           : fmt::format("{}-{}", begin, end));
    };
    std::int64_t next = first;
    for (const PartPicture& picture : pictures) {
        add(next, picture.frame - 1);
        next = picture.frame + 1;
    }
    add(next, last);
    return gaps;
}

void copy_picture(const fs::path& from, const fs::path& to) {
    std::error_code not_there;
    if (fs::equivalent(from, to, not_there)) return;
    write_whole(to, read_bytes(from));
}

std::string join_pictures(const std::vector<std::string>& names, const std::string& output,
                          const Task& task) {
    std::vector<PartPicture> pictures;
    std::vector<Record> first;  // at most one
    for (const fs::path& path : pictures_named(names)) {
        stop_if_interrupted();
        Record record = whole_record_of(path);
        pictures.push_back({*record.frame, path});
        if (first.empty()) first.push_back(record);
        if (const std::string why = difference_of(first.front(), record); !why.empty())
            refuse_strangers(pictures.front().path, path, why);
    }
    const Record& record = first.front();
    std::stable_sort(pictures.begin(), pictures.end(),
                     [](const auto& a, const auto& b) { return a.frame < b.frame; });
    for (std::size_t i = 1; i < pictures.size(); ++i)
        if (pictures[i].frame == pictures[i - 1].frame)
            throw InputError(fmt::format("{} and {} are both frame {}; give one of them",
                                         name_of(pictures[i - 1].path), name_of(pictures[i].path),
                                         pictures[i].frame));
    const auto [begin, last] = *record.frames;
    if (const std::string gaps = gaps_in(pictures, begin, last); !gaps.empty())
        throw InputError(
            fmt::format("of the frames {}-{} these are missing: {}; draw them with render --part, "
                        "and give all pictures",
                        begin, last, gaps));
    const fs::path pattern = with_scene_name(output, record.scene_name);
    if (!has_frame_number(pattern) || suffix_of(pattern) != ".png")
        throw InputError(
            fmt::format("{}: the parts are pictures; name a sequence, as "
                        "frame_####.png",
                        name_of(pattern)));
    check_chapters_place(pattern);
    task.begin(record.scene_name, static_cast<std::int64_t>(pictures.size()));
    for (const PartPicture& picture : pictures) {
        stop_if_interrupted();
        copy_picture(picture.path, frame_name(pattern, picture.frame));
        task.done(picture.frame - begin + 1);
    }
    write_what_lies_beside(pattern, record, task);
    task.finish(name_of(pattern));
    return record.bounds;
}

}  // namespace

std::string join(const std::vector<std::string>& parts, const std::string& output,
                 const Task& task) {
    watch_for_interrupts();
    const bool pictures = suffix_of(parts.front()) == ".png";
    return pictures ? join_pictures(parts, output, task) : join_film(parts, output, task);
}

}  // namespace poinsot
