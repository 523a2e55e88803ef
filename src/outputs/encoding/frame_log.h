// The log of an unfinished film, in formats that are assembled only at the end: one entry per
// encoded frame, in a temporary file, written at once. A killed run loses no entry; a resumed run
// starts with the complete entries.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "encoding/frame_sink.h"
#include "system/files/atomic_file.h"

namespace poinsot {

// Entries in the order of the film, from one file or several.
class FrameEntries {
 public:
    virtual ~FrameEntries() = default;
    virtual std::int64_t n_entries() const = 0;
    // Everything that the entries depend on besides the frames and the plan.
    virtual const std::string& settings() const = 0;
    // Returns entry k, valid until the next call. Throws EnvironmentError if its checksum is wrong.
    virtual std::span<const std::uint8_t> read(std::int64_t k) = 0;
    // Refuses an entry that has a valid checksum but is not of this format: the file was made by
    // another program. Throws InputError.
    [[noreturn]] virtual void refuse_entry() const = 0;
};

// The file consists of blocks: size and CRC-32 (IEEE 802.3) of the contents, four bytes each, the
// lowest first, and the contents. The first block describes the film; the others are the entries.
constexpr std::int64_t block_head = 8;

// A block, without its head.
struct FrameBlock {
    std::int64_t at = 0;  // of its contents
    std::uint32_t size = 0;
};

// Reads the block that begins at an offset of an open file; false if there is no complete one.
// Throws EnvironmentError, with the path.
bool read_block(int descriptor, const std::filesystem::path& path, std::int64_t at,
                FrameBlock& block, std::vector<std::uint8_t>& contents);

// Parses the first block into a plan and settings; false for any other text.
bool read_head(std::string_view head, OutputPlan& plan, std::string& settings);

class FrameLog : public FrameEntries {
 public:
    // settings describes everything that the entries depend on besides the frames and the plan.
    // With plan.resume, the entries of an earlier log of the same plan and settings are kept: all
    // complete chunks of n_chunk_frames. Throws EnvironmentError.
    FrameLog(const OutputPlan& plan, const std::string& settings, std::int64_t n_chunk_frames);
    // The same in a file of open_frame_log, which is locked already.
    FrameLog(AtomicFile&& file, const OutputPlan& plan, const std::string& settings,
             std::int64_t n_chunk_frames);

    // Returns the complete entries that a killed run has left of a film; plan().n_frames is their
    // number. Throws: InputError if there are none; EnvironmentError.
    static FrameLog left_of(const std::filesystem::path& film);

    ~FrameLog() override;  // keeps the entries for a later run if the plan resumes
    FrameLog(FrameLog&&) noexcept = default;
    FrameLog& operator=(FrameLog&&) noexcept = default;

    const OutputPlan& plan() const { return plan_; }
    const std::string& settings() const override { return settings_; }
    std::int64_t n_entries() const override { return static_cast<std::int64_t>(entries_.size()); }
    std::uint64_t n_bytes() const { return static_cast<std::uint64_t>(end_); }  // on disk so far

    // Appends an entry. Throws EnvironmentError.
    void append(std::span<const std::uint8_t> entry);

    std::span<const std::uint8_t> read(std::int64_t k) override;

    // Renames the log itself to the final name: a part of a film with all of its frames. Throws
    // EnvironmentError.
    void become_part() { file_.commit(); }

    void discard() noexcept { file_.discard(); }

    [[noreturn]] void refuse_entry() const override;

 private:
    explicit FrameLog(const std::filesystem::path& film);
    std::string scan();
    void append_block(std::span<const std::uint8_t> contents);
    void keep_first(std::int64_t n_entries);

    OutputPlan plan_;
    std::string settings_;
    AtomicFile file_;
    std::vector<FrameBlock> entries_;
    std::int64_t head_end_ = 0;  // of the block that describes the film
    std::int64_t end_ = 0;       // of the complete blocks
    std::vector<std::uint8_t> buffer_;
};

// Returns the path of a film's log.
std::filesystem::path frame_log_path(const std::filesystem::path& film);

// Opens a film's log and locks it. With keep_contents, its contents are kept as AtomicFile does.
// Throws EnvironmentError, also for a file of this name that is not a log.
AtomicFile open_frame_log(const std::filesystem::path& film, bool keep_contents);

}  // namespace poinsot
