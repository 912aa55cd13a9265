// SPDX-License-Identifier: BSD-3-Clause
// What a call complains about.
#ifndef GMAPPING_SPA_TESTS_MESSAGE_OF_H_
#define GMAPPING_SPA_TESTS_MESSAGE_OF_H_

#include <stdexcept>
#include <string>

namespace gmapping_spa {

// The message of the Error that `call` throws; other exceptions pass.
template <typename Error = std::runtime_error, typename Call>
std::string MessageOf(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace gmapping_spa

#endif  // GMAPPING_SPA_TESTS_MESSAGE_OF_H_
