#include "system/files/own_files.h"

#include <fmt/format.h>

#include <cerrno>
#include <exception>
#include <fstream>
#include <system_error>
#include <utility>

#include "error/error.h"
#include "system/files/atomic_file.h"
#include "system/files/file_contents.h"
#include "system/seal.h"
#include "system/sha256.h"
#include "text/printable.h"

namespace poinsot {

namespace fs = std::filesystem;

namespace {

std::string sealed_text_of(const fs::path& file) noexcept {
    try {
        if (!fs::is_regular_file(fs::symlink_status(file))) return "";
        std::string text = read_text(file);
        return is_sealed(text) ? text : "";
    } catch (const std::exception&) {
        return "";
    }
}

}  // namespace

bool is_own_file(const fs::path& file, const IsOwn& is_own) noexcept {
    try {
        return fs::is_regular_file(fs::symlink_status(file)) && is_own(file);
    } catch (const std::exception&) {
        return false;
    }
}

void check_replaceable(const WritePlace& place) {
    const std::string name = printable(place.path.string());
    if (place.path.empty() || place.path == "-") return;
    std::error_code error;
    for (const fs::path& input : place.inputs)
        if (fs::equivalent(place.path, input, error))
            throw InputError(
                fmt::format("{}: is read for this output, so it cannot be replaced by it; name "
                            "another output",
                            name));
    const bool is_there = fs::symlink_status(place.path, error).type() != fs::file_type::not_found;
    if (place.is_own && is_there && error.value() != ENAMETOOLONG &&
        !is_own_file(place.path, place.is_own))
        throw InputError(fmt::format(
            "{}: exists and is not as poinsot wrote it, and {} would replace it; remove "
            "it, or name another output",
            name, place.what));
    check_aside(place.path);
}

IsOwn sealed_with(std::string_view beginning) {
    return [beginning = std::string(beginning)](const fs::path& file) {
        return sealed_text_of(file).starts_with(beginning);
    };
}

std::string sha256_of_file(const fs::path& file) {
    Sha256 hash;
    read_pieces(file, [&hash](std::string_view piece) { hash.add(piece); });
    return hash.finish();
}

FileList::FileList(const fs::path& list) : text_(sealed_text_of(list)) {}

bool FileList::proves(const fs::path& file) const {
    return is_own_file(file, [this](const fs::path& each) {
        return !text_.empty() &&
               lists_file(text_, {each.filename().string(), sha256_of_file(each)});
    });
}

bool FileList::lists(const std::string& name) const { return lists_name(text_, name); }

FileLog::FileLog(fs::path folder, const std::string& name, std::string beginning)
    : folder_(std::move(folder)), list_(folder_ / name), beginning_(std::move(beginning)) {
    std::error_code error;
    const fs::file_type type = fs::symlink_status(folder_, error).type();
    const bool is_there = type != fs::file_type::not_found;
    if (is_there && type != fs::file_type::directory)
        throw InputError(
            fmt::format("{}: exists and is not a folder; remove it, or name another "
                        "output",
                        printable(folder_.string())));
    check_replaceable(
        {.path = list_,
         .is_own = [this](const fs::path& file) { return begins_with(file, beginning_ + "\n"); },
         .what = "the list of poinsot's files"});
    if (fs::exists(list_, error)) lines_ = read_text(list_).substr(beginning_.size());
}

namespace {

std::string line_of_log(const std::string& name, const std::string& sha256) {
    return fmt::format("\n{} {}\n", sha256, name);
}

}  // namespace

bool FileLog::proves(const fs::path& file) const {
    return is_own_file(file, [this](const fs::path& each) {
        const std::string line = line_of_log(each.filename().string(), sha256_of_file(each));
        return lines_.find(line) != std::string::npos;
    });
}

void FileLog::check(const std::string& name, std::string_view what) const {
    check_replaceable({.path = folder_ / name,
                       .is_own = [this](const fs::path& file) { return proves(file); },
                       .what = what});
}

void FileLog::begin() {
    std::string kept = "\n";
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_))
        if (proves(entry.path()))
            kept += line_of_log(entry.path().filename().string(), sha256_of_file(entry.path()))
                        .substr(1);
    lines_ = kept;
    write_whole(list_, beginning_ + lines_);
}

void FileLog::add(const std::string& name, std::string_view contents) {
    const std::string line = line_of_log(name, sha256_of(contents)).substr(1);
    lines_ += line;
    std::ofstream file(list_, std::ios::app | std::ios::binary);
    file << line;
    file.close();
    if (!file) throw_write_error(list_, errno);
}

}  // namespace poinsot
