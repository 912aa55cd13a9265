// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/covariance_choice.h"

#include <sstream>
#include <stdexcept>

#include "backend/text.h"

namespace gmapping_spa::apps {

CovarianceChoice ParseCovarianceChoice(const std::string& place, const std::string& text) {
  if (text == "all") return {};
  const auto fail = [&](const std::string& found) {
    throw std::runtime_error(place +
                             ": expected all, ids of nodes (3,7) or pairs of them (3:7,12:40), "
                             "found '" +
                             found + "'");
  };
  CovarianceChoice choice;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');) {
    const std::size_t colon = word.find(':');
    const auto i = backend::ParseNumber<std::int64_t>(word.substr(0, colon));
    const auto j =
        colon == std::string::npos ? i : backend::ParseNumber<std::int64_t>(word.substr(colon + 1));
    if (!i || !j) fail(word);
    const auto kind = colon == std::string::npos ? CovarianceChoice::Kind::kNodes
                                                 : CovarianceChoice::Kind::kPairs;
    if (!choice.ids.empty() && choice.kind != kind) fail(text);
    choice.kind = kind;
    choice.ids.emplace_back(*i, *j);
  }
  if (choice.ids.empty()) fail(text);
  return choice;
}

}  // namespace gmapping_spa::apps
