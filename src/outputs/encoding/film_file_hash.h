// The hash of a film's file around its record. The record has a hash of its own, so that the two
// cover every byte of the file: times, sizes, colours, index and captions beside the pictures.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "encoding/frame_sink.h"
#include "system/files/atomic_file.h"

namespace poinsot {

// Returns the SHA-256 of the bytes before and after the record, at the first place where the file
// contains this text; empty if it does not. Reads in pieces. Throws as read_pieces does.
std::optional<std::string> file_hash_of(const std::filesystem::path& film, std::string_view record);

// The record of a film that is about to be written, with zeros in place of the hash of the file.
std::string record_before_hash(const OutputPlan& plan, EncodedMetadata encoded);

// Replaces that record in a written film by the one with the hash, which has the same length. Call
// before the file is committed. Throws EnvironmentError.
void put_file_hash(AtomicFile& film, const OutputPlan& plan, EncodedMetadata encoded);

}  // namespace poinsot
