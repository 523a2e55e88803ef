// A submission handed to Slurm: an array of parts, and the joins after it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "production/parts/submission.h"

namespace poinsot {

// A call of sbatch that waits to be made. What stands for the ids of earlier ones is filled in
// then.
struct SlurmCall {
    std::vector<std::string> words;
    bool after_parts = false;  // it needs the ids of the calls before it
};

// The calls that a submission takes: its tasks that are not done, in arrays of at most
// largest_array, and their joins. Options are sbatch's own, the site's before the user's.
std::vector<SlurmCall> slurm_calls(const Submission& submission,
                                   const std::vector<std::string>& options, int largest_array);

// As a shell would run them, ids in $parts.
std::string in_shell(const std::vector<SlurmCall>& calls);

// Options that hold for all submissions here: a line or more of them, # begins a comment, from
// /etc/poinsot/slurm.options and $XDG_CONFIG_HOME/poinsot/slurm.options (~/.config without).
std::vector<std::string> site_options();

// What Slurm says, or its default where it says nothing.
int largest_array();

struct SlurmIds {
    std::vector<std::string> parts, joins;
};

// Makes the calls. Throws EnvironmentError where sbatch is missing or refuses, with its words; what
// had been submitted until then is cancelled.
SlurmIds submit(const std::vector<SlurmCall>& calls);

}  // namespace poinsot
