// SPDX-License-Identifier: BSD-3-Clause
// What every reader owes its callers, whatever the bytes are.
#ifndef GMAPPING_SPA_TESTS_FUZZ_CONTRACT_H_
#define GMAPPING_SPA_TESTS_FUZZ_CONTRACT_H_

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>

#include "backend/out_of_memory.h"

namespace gmapping_spa::fuzz {

// Ends the process, so that the fuzzer keeps the input.
[[noreturn]] inline void Break(const std::string& what) {
  std::fprintf(stderr, "broken contract: %s\n", what.c_str());
  std::abort();
}

// Calls a reader. It returns, or throws a std::runtime_error whose message is one printable line.
// Returns whether it returned; other exceptions end the process.
template <typename Read>
bool ReadsOrRefuses(const Read& read) {
  try {
    read();
    return true;
  } catch (const backend::OutOfMemory& error) {
    Break(std::string("expected to need little memory, found: ") + error.what());
  } catch (const std::runtime_error& error) {
    const std::string message = error.what();
    const auto is_control = [](unsigned char c) { return c < ' ' || c == 0x7f; };
    if (message.empty() || std::any_of(message.begin(), message.end(), is_control)) {
      Break("expected a message of one printable line, found '" + message + "'");
    }
    return false;
  }
}

inline std::string TextOf(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

// Whether two numbers are the same to the bit, or both zero.
inline bool Same(double a, double b) { return a == b || std::memcmp(&a, &b, sizeof(a)) == 0; }

}  // namespace gmapping_spa::fuzz

#endif  // GMAPPING_SPA_TESTS_FUZZ_CONTRACT_H_
