#include "encoding/frame_log.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <limits>
#include <string_view>
#include <utility>

#include "encoding/film_texts.h"
#include "encoding/libav_calls.h"
#include "error/error.h"
#include "text/numbers.h"

namespace poinsot {

namespace {

namespace fs = std::filesystem;

std::uint32_t checksum(std::span<const std::uint8_t> bytes) {
    if (bytes.empty()) return ~0u;  // FFmpeg dereferences the pointer
    return av_crc(av_crc_get_table(AV_CRC_32_IEEE_LE), ~0u, bytes.data(), bytes.size());
}

void put_u32(std::uint8_t* at, std::uint32_t value) {
    for (int i = 0; i < 4; ++i) at[i] = static_cast<std::uint8_t>(value >> 8 * i);
}

std::uint32_t get_u32(const std::uint8_t* at) {
    std::uint32_t value = 0;
    for (int i = 0; i < 4; ++i) value |= static_cast<std::uint32_t>(at[i]) << 8 * i;
    return value;
}

// The plan and the settings as text: numbers, among them the lengths of the texts, then the texts.
std::string film_head(const OutputPlan& plan, const std::string& settings) {
    const std::string part = plan.part ? part_text(*plan.part) : "";
    return fmt::format("{}{} {} {} {} {} {} {}\n{}{}{}",
                       plan.part ? fmt::format("part {}\n{}", part.size(), part) : "",
                       plan.width_px, plan.height_px, plan.rate.numerator, plan.rate.denominator,
                       plan.first_frame, settings.size(), plan.metadata.size(), settings,
                       plan.metadata, texts_of(plan));
}

// The head of a part begins with the part's own text and its size.
constexpr std::string_view part_key = "part ";

bool take_part(std::string_view& head, OutputPlan& plan) {
    head.remove_prefix(part_key.size());
    std::int64_t length = 0;
    if (!take_count(head, length, '\n')) return false;
    const auto size = static_cast<std::size_t>(length);
    if (size > head.size() || !parse_part(head.substr(0, size), plan.part.emplace())) return false;
    head.remove_prefix(size);
    return true;
}

std::span<const std::uint8_t> bytes_of(std::string_view text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

}  // namespace

bool read_head(std::string_view head, OutputPlan& plan, std::string& settings) {
    if (head.starts_with(part_key) && !take_part(head, plan)) return false;
    std::array<std::int64_t, 7> numbers{};
    for (std::int64_t& number : numbers)
        if (!take_count(head, number, &number == &numbers.back() ? '\n' : ' ')) return false;
    const auto n_settings = static_cast<std::size_t>(numbers[5]);
    const auto n_metadata = static_cast<std::size_t>(numbers[6]);
    constexpr std::int64_t largest = std::numeric_limits<int>::max();
    if (n_settings > head.size() || n_metadata > head.size() - n_settings ||
        *std::max_element(numbers.begin(), numbers.begin() + 4) > largest)
        return false;
    plan.width_px = static_cast<int>(numbers[0]);
    plan.height_px = static_cast<int>(numbers[1]);
    plan.rate = {numbers[2], numbers[3]};
    plan.first_frame = numbers[4];
    settings = head.substr(0, n_settings);
    plan.metadata = head.substr(n_settings, n_metadata);
    parse_texts(head.substr(n_settings + n_metadata), plan);
    return true;
}

bool read_block(int descriptor, const fs::path& path, std::int64_t at, FrameBlock& block,
                std::vector<std::uint8_t>& contents) {
    const auto read_fully = [&](std::int64_t from, std::span<std::uint8_t> bytes) {
        for (std::size_t done = 0; done < bytes.size();) {
            const ssize_t n = ::pread(descriptor, bytes.data() + done, bytes.size() - done,
                                      from + static_cast<std::int64_t>(done));
            if (n < 0 && errno == EINTR) continue;
            if (n < 0) throw_write_error(path, errno);
            if (n == 0) return false;
            done += static_cast<std::size_t>(n);
        }
        return true;
    };
    std::array<std::uint8_t, block_head> head{};
    struct stat status {};
    if (fstat(descriptor, &status) != 0) throw_write_error(path, errno);
    if (!read_fully(at, head)) return false;
    block = {at + block_head, get_u32(head.data())};
    if (block.size > status.st_size - block.at) return false;
    contents.resize(block.size);
    return read_fully(block.at, contents) && checksum(contents) == get_u32(head.data() + 4);
}

fs::path frame_log_path(const fs::path& film) { return aside_path_of(film, ".part.frames"); }

AtomicFile open_frame_log(const fs::path& film, bool keep_contents) {
    // A log that was copied here has no mark, and its first block describes a film.
    const auto is_log = [&film](int descriptor) {
        FrameBlock block;
        std::vector<std::uint8_t> contents;
        OutputPlan plan;
        std::string settings;
        return read_block(descriptor, film, 0, block, contents) &&
               read_head({reinterpret_cast<const char*>(contents.data()), contents.size()}, plan,
                         settings);
    };
    return {film, frame_log_path(film), keep_contents, {}, is_log};
}

FrameLog::FrameLog(const OutputPlan& plan, const std::string& settings, std::int64_t n_chunk_frames)
    : FrameLog(open_frame_log(plan.path, plan.resume), plan, settings, n_chunk_frames) {}

FrameLog::FrameLog(AtomicFile&& file, const OutputPlan& plan, const std::string& settings,
                   std::int64_t n_chunk_frames)
    : plan_(plan), settings_(settings), file_(std::move(file)) {
    // The film itself is opened when all of its frames are there.
    check_aside(plan.path);
    const std::string head = film_head(plan, settings);
    if (plan.resume && scan() == head) {
        const bool all_there = n_entries() == plan.n_frames;
        keep_first(all_there ? n_entries() : n_entries() - n_entries() % n_chunk_frames);
        return;
    }
    head_end_ = 0;
    keep_first(0);
    append_block(bytes_of(head));
    head_end_ = end_;
}

FrameLog FrameLog::left_of(const fs::path& film) {
    std::error_code ignored;
    if (!fs::exists(frame_log_path(film), ignored))
        throw InputError(fmt::format("there is no unfinished film {}", film.string()));
    return FrameLog(film);
}

FrameLog::FrameLog(const fs::path& film) : file_(open_frame_log(film, true)) {
    const std::string head = scan();
    if (n_entries() == 0 || !read_head(head, plan_, settings_))
        throw InputError(fmt::format("no frame of {} had been finished", film.string()));
    if (plan_.part)
        throw InputError(
            fmt::format("{}: is part {} of {} of a film; run its render command again to finish "
                        "it, then join the parts",
                        film.string(), plan_.part->number, plan_.part->n_parts));
    plan_.path = film;
    plan_.n_frames = n_entries();
    plan_.resume = true;
}

FrameLog::~FrameLog() {
    if (plan_.resume && file_.descriptor() >= 0 && !entries_.empty())
        file_.release();
    else
        file_.discard();
}

// Finds the complete blocks and returns the first one's text.
std::string FrameLog::scan() {
    std::string head;
    FrameBlock block;
    while (read_block(file_.descriptor(), file_.path(), end_, block, buffer_)) {
        const bool is_head = end_ == 0;
        end_ = block.at + block.size;
        if (is_head) {
            head.assign(buffer_.begin(), buffer_.end());
            head_end_ = end_;
        } else {
            entries_.push_back(block);
        }
    }
    return head;
}

void FrameLog::keep_first(std::int64_t n_entries) {
    entries_.resize(static_cast<std::size_t>(n_entries));
    end_ = entries_.empty() ? head_end_ : entries_.back().at + entries_.back().size;
    if (ftruncate(file_.descriptor(), end_) != 0 || ::lseek(file_.descriptor(), end_, SEEK_SET) < 0)
        throw_write_error(file_.path(), errno);
}

void FrameLog::append_block(std::span<const std::uint8_t> contents) {
    if (contents.size() > std::numeric_limits<std::uint32_t>::max())
        throw EnvironmentError(
            fmt::format("cannot write {}: a frame takes more than 4 GB", file_.path().string()));
    buffer_.resize(block_head + contents.size());
    put_u32(buffer_.data(), static_cast<std::uint32_t>(contents.size()));
    put_u32(buffer_.data() + 4, checksum(contents));
    std::copy(contents.begin(), contents.end(), buffer_.begin() + block_head);
    file_.write(buffer_);
    end_ += static_cast<std::int64_t>(buffer_.size());
}

void FrameLog::append(std::span<const std::uint8_t> entry) {
    const std::int64_t at = end_ + block_head;
    append_block(entry);
    entries_.push_back({at, static_cast<std::uint32_t>(entry.size())});
}

std::span<const std::uint8_t> FrameLog::read(std::int64_t k) {
    const FrameBlock& wanted = entries_.at(static_cast<std::size_t>(k));
    FrameBlock found;
    if (!read_block(file_.descriptor(), file_.path(), wanted.at - block_head, found, buffer_) ||
        found.size != wanted.size)
        throw EnvironmentError(fmt::format(
            "cannot write {}: its unfinished frames cannot be read back", file_.path().string()));
    return buffer_;
}

void FrameLog::refuse_entry() const {
    throw InputError(fmt::format("{}: was not written by poinsot; remove it",
                                 frame_log_path(file_.path()).string()));
}

}  // namespace poinsot
