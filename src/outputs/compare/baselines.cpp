#include "compare/baselines.h"

#include <fmt/format.h>

#include <utility>

#include "compare/frame_stream.h"
#include "compare/rendered_page.h"
#include "error/error.h"
#include "image/files/png_files.h"
#include "image/pixels_sha256.h"
#include "system/files/file_contents.h"
#include "system/sha256.h"

namespace poinsot {

namespace {

namespace fs = std::filesystem;

void copy_picture(const fs::path& from, const fs::path& to) {
    const std::vector<std::uint8_t> bytes = read_bytes(from);
    std::error_code ignored;  // the following write reports the error
    fs::create_directories(to.parent_path(), ignored);
    write_whole(to, bytes);
}

// A PNG may be named film.mp4.png.
fs::path picture_in(const fs::path& folder, const std::string& name) {
    fs::path png = folder / (name + ".png");
    std::error_code not_there;
    return has_suffix_in_name(name) && !fs::exists(png, not_there) ? folder / name : png;
}

}  // namespace

bool has_suffix_in_name(const std::string& name) {
    return is_film_name(name) || is_vector_page_name(name);
}

std::string pixel_hash_of_file(const fs::path& picture) {
    try {
        if (has_suffix_in_name(picture.filename().string())) {
            Sha256 hash;
            read_pieces(picture, [&hash](std::string_view piece) { hash.add(piece); });
            return hash.finish();
        }
        return pixels_sha256(read_stored_png(picture));
    } catch (const Error&) {
        return "";
    }
}

Baselines::Baselines(fs::path folder) : folder_(std::move(folder)) {
    std::error_code ignored;
    manifest_ = read_manifest(folder_);
    next_ = read_next_manifest(folder_);
    has_manifest_ = fs::exists(folder_ / manifest_name, ignored) || next_.has_value();
}

fs::path Baselines::picture(const std::string& name) const { return picture_in(folder_, name); }

std::string Baselines::fault(const std::string& name, const std::string& pixels) const {
    if (!has_manifest_) return "";
    const auto line = manifest_.find(name);
    if (line != manifest_.end() && line->second.pixels == pixels) return "";
    if (next_) {
        const auto next = next_->find(name);
        if (next != next_->end() && next->second.pixels == pixels)
            return "an approval of this baseline was interrupted; run `poinsot approve` for this "
                   "folder again to finish it";
    }
    if (line == manifest_.end())
        return fmt::format(
            "the baseline has no line in {}, so it was never approved; approve it or remove it",
            manifest_name);
    return fmt::format(
        "the baseline does not match its hash in {}; restore the approved picture, or approve the "
        "right one",
        manifest_name);
}

BaselineWriter::BaselineWriter(fs::path folder, const std::function<void()>& when_held)
    : folder_(std::move(folder)) {
    std::error_code ignored;  // the lock reports the error
    made_ = fs::create_directories(folder_, ignored);
    const fs::path list = folder_ / manifest_name;
    lock_.emplace(list, aside_path_of(list, ".lock"), false, when_held);
    manifest_ = read_manifest(folder_);
    remove_half_manifests(folder_);
    for (const auto& [name, line] : manifest_) remove_left_aside(picture_in(folder_, name));
    finish_interrupted();
}

BaselineWriter::~BaselineWriter() {
    lock_.reset();
    std::error_code not_empty;
    if (made_) fs::remove(folder_, not_empty);
}

std::string BaselineWriter::pixels_of(const std::string& name) const {
    return pixel_hash_of_file(picture_in(folder_, name));
}

fs::path BaselineWriter::picture(const std::string& name) const {
    return picture_in(folder_, name);
}

// Writes the line of each picture that was replaced, and removes that of each picture that was
// removed; other pictures keep their lines.
void BaselineWriter::finish_interrupted() {
    const auto next = read_next_manifest(folder_);
    if (!next) return;
    for (const auto& [name, line] : *next) {
        remove_left_aside(picture_in(folder_, name));
        const auto now = manifest_.find(name);
        if (now != manifest_.end() && now->second == line) continue;
        if (pixels_of(name) != line.pixels) continue;
        manifest_[name] = line;
        finished_.push_back(name);
    }
    const std::size_t n_removed = std::erase_if(manifest_, [&](const auto& line) {
        std::error_code error;
        return !next->contains(line.first) && !fs::exists(picture(line.first), error) && !error;
    });
    if (!finished_.empty() || n_removed > 0) write_manifest(folder_, manifest_);
    remove_next_manifest(folder_);
}

void BaselineWriter::take(const std::vector<Change>& changes,
                          const std::vector<std::string>& removed) {
    BaselineManifest next = manifest_;
    for (const Change& change : changes) next[change.name] = change.line;
    for (const std::string& name : removed) next.erase(name);
    // Pictures and lines cannot be renamed at once: the new lines are on disk first, so that the
    // next process can tell an approved picture from one changed by hand.
    if (next != manifest_) write_next_manifest(folder_, next);
    try {
        for (const Change& change : changes)
            copy_picture(change.from, picture_in(folder_, change.name));
        for (const std::string& name : removed) {
            std::error_code error;
            fs::remove(picture(name), error);
            if (error) throw_write_error(picture(name), error.value());
        }
    } catch (const Error&) {
        try {
            finish_interrupted();
        } catch (const Error&) {
            // The temporary files are left for the next run.
            finished_.clear();
        }
        throw;
    }
    if (next == manifest_) return;
    write_manifest(folder_, next);
    manifest_ = std::move(next);
    remove_next_manifest(folder_);
}

}  // namespace poinsot
