// A film under way in formats that are put together only in the end: what each frame came to,
// aside, an entry a frame, each in the file as soon as it is written. A killed run loses none of
// them; one that goes on begins with those that are whole.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "output/frame_sink.h"
#include "system/atomic_file.h"

namespace poinsot {

class FrameLog {
 public:
    // settings says everything that the entries depend on besides the frames and the plan. With
    // plan.resume, the entries of an earlier log of the same plan and settings are kept: as many
    // whole chunks of n_chunk_frames as there are. Throws EnvironmentError.
    FrameLog(const OutputPlan& plan, const std::string& settings, std::int64_t n_chunk_frames);

    // What a killed run has left of a film, all that is whole of it; plan().n_frames says how many.
    // Throws: InputError if there is nothing; EnvironmentError.
    static FrameLog left_of(const std::filesystem::path& film);

    ~FrameLog();  // leaves the entries aside for a later run where the plan says so
    FrameLog(FrameLog&&) noexcept = default;
    FrameLog& operator=(FrameLog&&) noexcept = default;

    const OutputPlan& plan() const { return plan_; }
    const std::string& settings() const { return settings_; }
    std::int64_t n_entries() const { return static_cast<std::int64_t>(entries_.size()); }
    std::uint64_t n_bytes() const { return static_cast<std::uint64_t>(end_); }  // on disk so far

    // Throws EnvironmentError.
    void append(std::span<const std::uint8_t> entry);

    // Entry k, valid until the next call. Throws EnvironmentError if it is not what was written.
    std::span<const std::uint8_t> read(std::int64_t k);

    void discard() noexcept { file_.discard(); }

    // An entry that is whole by its checksum and yet none of this format's: the file was made by
    // another program.
    [[noreturn]] void refuse_entry() const;

 private:
    struct Entry {
        std::int64_t at;  // of its contents
        std::uint32_t size;
    };

    explicit FrameLog(const std::filesystem::path& film);
    std::string scan();
    void append_block(std::span<const std::uint8_t> contents);
    bool read_block(std::int64_t at, Entry& block);
    void keep_first(std::int64_t n_entries);

    OutputPlan plan_;
    std::string settings_;
    AtomicFile file_;
    std::vector<Entry> entries_;
    std::int64_t head_end_ = 0;  // of the block that says what film this is
    std::int64_t end_ = 0;       // of what is whole
    std::vector<std::uint8_t> buffer_;
};

// Where the log of a film lies.
std::filesystem::path frame_log_path(const std::filesystem::path& film);

}  // namespace poinsot
