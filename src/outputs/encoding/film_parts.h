// The finished parts of a film: files that describe their part and hold its frames as encoded.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "encoding/frame_log.h"
#include "encoding/frame_sink.h"
#include "system/files/file_contents.h"

namespace poinsot {

class PartFile {
 public:
    // Reads the whole file once. Throws InputError for a file that cannot be read or is not a part.
    explicit PartFile(std::filesystem::path path);

    const std::filesystem::path& path() const { return path_; }
    const FilmPart& part() const { return part_; }
    const OutputPlan& plan() const { return plan_; }  // of the film, with the path of the part
    const std::string& settings() const { return settings_; }
    std::int64_t n_there() const { return static_cast<std::int64_t>(blocks_.size()); }
    // Whether all frames of the part are in the file, and nothing else.
    bool is_whole() const { return is_clean_ && n_there() == part().n_frames; }
    const std::vector<FrameBlock>& blocks() const { return blocks_; }

 private:
    std::filesystem::path path_;
    OutputPlan plan_;
    FilmPart part_;
    std::string settings_;
    std::vector<FrameBlock> blocks_;
    bool is_clean_ = false;  // no bytes after the last whole block
};

// Whether a file may be a part, judged by its first bytes.
bool looks_like_part(const std::filesystem::path& path);

// The entries of all parts of a film, in its order. One file is open at a time. Reading throws
// EnvironmentError also when the run is interrupted.
class JoinedEntries : public FrameEntries {
 public:
    // Precondition: the parts are whole and in order, and there is at least one.
    explicit JoinedEntries(const std::vector<PartFile>& parts);

    std::int64_t n_entries() const override { return n_entries_; }
    const std::string& settings() const override { return parts_->front().settings(); }
    std::span<const std::uint8_t> read(std::int64_t k) override;
    [[noreturn]] void refuse_entry() const override;

 private:
    void open(std::size_t part);

    const std::vector<PartFile>* parts_;
    std::int64_t n_entries_ = 0;
    std::size_t open_part_ = 0;
    std::optional<InputFile> file_;  // the part that is open
    std::vector<std::uint8_t> buffer_;
};

}  // namespace poinsot
