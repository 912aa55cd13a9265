// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/apps/certificate_record.h"

namespace gmapping_spa::apps {

nlohmann::ordered_json CertificateRecord(const backend::CertifiedResult& result) {
  using Json = nlohmann::ordered_json;
  const backend::StaircaseResult& staircase = result.staircase;
  const backend::Certificate& certificate = staircase.certificate;
  Json descents = Json::array();
  for (const backend::Descent& descent : staircase.descents) {
    descents.push_back(
        {{"rank", descent.rank}, {"cost", descent.cost}, {"accepted", descent.accepted}});
  }
  return {{"optimal", certificate.optimal()},
          {"message", result.message},
          {"problem", result.problem},
          {"cost", certificate.cost},
          {"lower_bound", certificate.lower_bound},
          {"relative_suboptimality", certificate.relative_gap},
          {"positive_definite", certificate.positive_definite},
          {"shift", certificate.shift},
          {"rounding_margin", certificate.margin},
          {"smallest_eigenvalue", certificate.smallest_eigenvalue},
          {"given_cost", staircase.initial_cost},
          {"given_relative_suboptimality", staircase.first_gap},
          {"descents", descents}};
}

}  // namespace gmapping_spa::apps
