// What an interrupted run has drawn, as a film that can be shown now.
#pragma once

#include <cstdint>
#include <filesystem>

#include "production/record.h"
#include "production/telling.h"

namespace poinsot {

// Makes the film of the frames that are there, and its chapters and subtitles beside it, if what
// they need is still to be had. Returns the number of frames. Throws InputError, EnvironmentError.
std::int64_t recover(const std::filesystem::path& film, const Telling& telling);

// The chapters, and a film's subtitles, beside a film or sequence that carries a record, as they
// lie beside one that was made in one run. Throws InputError where the scene needs files that are
// not there.
void write_what_lies_beside(const std::filesystem::path& film, const Record& record,
                            const Telling& telling);

}  // namespace poinsot
