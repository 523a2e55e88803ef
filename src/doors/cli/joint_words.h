// What `poinsot fit` says of flights that are fitted together, and of predictions.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "measured/joint_fit.h"
#include "measured/prediction.h"
#include "production/fits/fit_flights.h"

namespace poinsot {

// Predictions are of the flights that count; empty without --predict.
using FlightPredictions = std::vector<std::optional<Prediction>>;

std::vector<std::string> words_of(const JointFit& joint,
                                  const std::vector<const TableFlight*>& flights,
                                  const FlightPredictions& predictions);
std::string json_of(const JointFit& joint, const std::vector<const TableFlight*>& flights,
                    const FlightPredictions& predictions);

std::string words_of(const Prediction& prediction);
std::string json_of(const Prediction& prediction);

}  // namespace poinsot
