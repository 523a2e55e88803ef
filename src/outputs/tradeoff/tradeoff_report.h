// The results of a tradeoff: as a table for users, as data, and as charts.
#pragma once

#include <string>

#include "drawing/figures/charts/chart.h"
#include "tradeoff/tradeoff.h"

namespace poinsot {

// Returns the rows of the Pareto front, or all rows, with the resulting advice.
std::string table_of(const Session& session, const Tradeoff& trades, bool all);
std::string csv_of(const Tradeoff& trades);
std::string json_of(const Session& session, const Tradeoff& trades);

// Work–precision charts: cost on the horizontal axis, error on the vertical one.
Chart motion_chart(const Session& session, const Tradeoff& trades);
Chart picture_chart(const Tradeoff& trades);
Chart film_chart(const Tradeoff& trades);

}  // namespace poinsot
