// A film under way in formats that are put together only in the end: what each frame came to,
// aside, an entry a frame, each in the file as soon as it is written. A killed run loses none of
// them; one that goes on begins with those that are whole.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "output/frame_sink.h"
#include "system/atomic_file.h"

namespace poinsot {

// Entries in the order of the film, wherever they lie.
class FrameEntries {
 public:
    virtual ~FrameEntries() = default;
    virtual std::int64_t n_entries() const = 0;
    // All that they depend on besides the frames and the plan.
    virtual const std::string& settings() const = 0;
    // Entry k, valid until the next call. Throws EnvironmentError if it is not what was written.
    virtual std::span<const std::uint8_t> read(std::int64_t k) = 0;
    // An entry that is whole by its checksum and yet none of this format's: the file was made by
    // another program. Throws InputError.
    [[noreturn]] virtual void refuse_entry() const = 0;
};

// A file of them is blocks: size and CRC-32 (IEEE 802.3) of the contents, four bytes each, the
// least first, and the contents. The first says what film this is; the others are the entries.
constexpr std::int64_t block_head = 8;

// A block, without its head.
struct FrameBlock {
    std::int64_t at = 0;  // of its contents
    std::uint32_t size = 0;
};

// Reads the block that begins at a place of an open file; false if there is no whole one. Throws
// EnvironmentError, with the path.
bool read_block(int descriptor, const std::filesystem::path& path, std::int64_t at,
                FrameBlock& block, std::vector<std::uint8_t>& contents);

// Reads what the first block says back into a plan and settings; false for what is no such text.
bool read_head(std::string_view head, OutputPlan& plan, std::string& settings);

class FrameLog : public FrameEntries {
 public:
    // settings says everything that the entries depend on besides the frames and the plan. With
    // plan.resume, the entries of an earlier log of the same plan and settings are kept: as many
    // whole chunks of n_chunk_frames as there are. Throws EnvironmentError.
    FrameLog(const OutputPlan& plan, const std::string& settings, std::int64_t n_chunk_frames);

    // What a killed run has left of a film, all that is whole of it; plan().n_frames says how many.
    // Throws: InputError if there is nothing; EnvironmentError.
    static FrameLog left_of(const std::filesystem::path& film);

    ~FrameLog() override;  // leaves the entries aside for a later run where the plan says so
    FrameLog(FrameLog&&) noexcept = default;
    FrameLog& operator=(FrameLog&&) noexcept = default;

    const OutputPlan& plan() const { return plan_; }
    const std::string& settings() const override { return settings_; }
    std::int64_t n_entries() const override { return static_cast<std::int64_t>(entries_.size()); }
    std::uint64_t n_bytes() const { return static_cast<std::uint64_t>(end_); }  // on disk so far

    // Throws EnvironmentError.
    void append(std::span<const std::uint8_t> entry);

    std::span<const std::uint8_t> read(std::int64_t k) override;

    // Under the final name stands this very file: a part of a film, whose frames all are here.
    // Throws EnvironmentError.
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
    std::int64_t head_end_ = 0;  // of the block that says what film this is
    std::int64_t end_ = 0;       // of what is whole
    std::vector<std::uint8_t> buffer_;
};

// Where the log of a film lies.
std::filesystem::path frame_log_path(const std::filesystem::path& film);

}  // namespace poinsot
