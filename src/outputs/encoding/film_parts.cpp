#include "encoding/film_parts.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "error/error.h"
#include "system/files/file_contents.h"
#include "system/files/file_kind.h"
#include "system/interrupt.h"

namespace poinsot {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view part_word = "part ";  // of the first block's contents

InputFile open_part(const fs::path& path) {
    if (kind_of_file(path) == FileKind::missing)
        throw InputError(
            fmt::format("{}: no such file; name a part that render --part wrote", path.string()));
    return InputFile(path);
}

}  // namespace

PartFile::PartFile(fs::path path) : path_(std::move(path)) {
    const InputFile file = open_part(path_);
    std::vector<std::uint8_t> contents;
    FrameBlock block;
    std::int64_t end = 0;
    if (!looks_like_part(path_) || !read_block(file.descriptor(), path_, end, block, contents) ||
        !read_head({reinterpret_cast<const char*>(contents.data()), contents.size()}, plan_,
                   settings_) ||
        !plan_.part)
        throw InputError(
            fmt::format("{}: is not a part of a film; render --part writes parts", path_.string()));
    part_ = *plan_.part;
    plan_.path = path_;
    plan_.n_frames = part().n_frames;
    for (end = block.at + block.size; read_block(file.descriptor(), path_, end, block, contents);
         end = block.at + block.size) {
        stop_if_interrupted();
        blocks_.push_back(block);
    }
    struct stat status {};
    is_clean_ = fstat(file.descriptor(), &status) == 0 && status.st_size == end;
}

bool looks_like_part(const fs::path& path) {
    const InputFile file = open_part(path);
    std::array<char, block_head + part_word.size()> start{};
    const ssize_t n = ::pread(file.descriptor(), start.data(), start.size(), 0);
    return n == static_cast<ssize_t>(start.size()) &&
           std::string_view(start.data(), start.size()).substr(block_head) == part_word;
}

JoinedEntries::JoinedEntries(const std::vector<PartFile>& parts) : parts_(&parts) {
    for (const PartFile& part : parts) n_entries_ += part.n_there();
    open(0);
}

void JoinedEntries::open(std::size_t part) {
    file_.emplace((*parts_)[part].path());
    open_part_ = part;
}

std::span<const std::uint8_t> JoinedEntries::read(std::int64_t k) {
    stop_if_interrupted();
    const auto after = std::upper_bound(
        parts_->begin(), parts_->end(), k,
        [](std::int64_t frame, const PartFile& part) { return frame < part.part().n_before; });
    const auto index = static_cast<std::size_t>(after - parts_->begin() - 1);
    if (index != open_part_) open(index);
    const PartFile& part = (*parts_)[index];
    const FrameBlock& wanted = part.blocks().at(static_cast<std::size_t>(k - part.part().n_before));
    FrameBlock found;
    if (!read_block(file_->descriptor(), part.path(), wanted.at - block_head, found, buffer_) ||
        found.size != wanted.size)
        throw EnvironmentError(
            fmt::format("{} changed during reading; draw the part again", part.path().string()));
    return buffer_;
}

void JoinedEntries::refuse_entry() const {
    throw InputError(fmt::format("{}: is not a part that poinsot wrote; draw the part again",
                                 (*parts_)[open_part_].path().string()));
}

}  // namespace poinsot
