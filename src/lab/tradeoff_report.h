// What a tradeoff has found: as a table for people, as data, and as charts.
#pragma once

#include <string>

#include "drawing/charts/chart.h"
#include "lab/tradeoff.h"

namespace poinsot {

// The rows that no other beats, or all of them, with the advice that follows.
std::string table_of(const Session& session, const Tradeoff& trades, bool all);
std::string csv_of(const Tradeoff& trades);
std::string json_of(const Session& session, const Tradeoff& trades);

// Work and precision: cost across, error upwards.
Chart motion_chart(const Session& session, const Tradeoff& trades);
Chart picture_chart(const Tradeoff& trades);
Chart film_chart(const Tradeoff& trades);

}  // namespace poinsot
