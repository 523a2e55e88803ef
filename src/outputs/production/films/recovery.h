// Builds a film from the finished frames of an interrupted run.
#pragma once

#include <cstdint>
#include <filesystem>

#include "production/records/record.h"
#include "production/session/task.h"

namespace poinsot {

// Makes the film of the finished frames, and its chapters and subtitles beside it if the files that
// these need still exist. Returns the number of frames. Throws InputError, EnvironmentError.
std::int64_t recover(const std::filesystem::path& film, const Task& task);

// Writes the chapters and subtitles beside a film or sequence with a record, as a single run does.
// Throws InputError if files of the scene are missing.
void write_what_lies_beside(const std::filesystem::path& film, const Record& record,
                            const Task& task);

}  // namespace poinsot
