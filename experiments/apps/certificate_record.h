// SPDX-License-Identifier: BSD-3-Clause
// A certificate of optimality as JSON.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_CERTIFICATE_RECORD_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_CERTIFICATE_RECORD_H_

#include <nlohmann/json.hpp>

#include "backend/scheduling/certify_result.h"

namespace gmapping_spa::apps {

nlohmann::ordered_json CertificateRecord(const backend::CertifiedResult& result);

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_CERTIFICATE_RECORD_H_
