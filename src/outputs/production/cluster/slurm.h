// Submits parts to Slurm: an array of parts, followed by the joins.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "production/cluster/submission.h"

namespace poinsot {

// A planned call of sbatch. Placeholders of the ids of earlier calls are filled in when it is made.
struct SlurmCall {
    std::vector<std::string> words;
    bool after_parts = false;  // depends on the ids of the calls before it
};

// The calls for a submission: its unfinished tasks, in arrays of less than largest_array, and their
// joins. `options` are those of sbatch, the site's before the user's.
std::vector<SlurmCall> slurm_calls(const Submission& submission,
                                   const std::vector<std::string>& options, int largest_array);

// The calls as shell commands, with ids in $parts.
std::string in_shell(const std::vector<SlurmCall>& calls);

// Options for all submissions on this site: one or more lines, comments start with #, from
// /etc/poinsot/slurm.options and $XDG_CONFIG_HOME/poinsot/slurm.options (default: ~/.config).
std::vector<std::string> site_options();

// Slurm's MaxArraySize, or its default if Slurm does not report it.
int largest_array();

struct SlurmIds {
    std::vector<std::string> parts, joins;
};

// Makes the calls. Throws EnvironmentError, with sbatch's message, if sbatch is missing or fails;
// then already submitted calls are cancelled.
SlurmIds submit(const std::vector<SlurmCall>& calls);

}  // namespace poinsot
