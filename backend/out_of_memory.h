// SPDX-License-Identifier: BSD-3-Clause
// Saying what memory was not enough for.
#ifndef GMAPPING_SPA_BACKEND_OUT_OF_MEMORY_H_
#define GMAPPING_SPA_BACKEND_OUT_OF_MEMORY_H_

#include <cstdint>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>

namespace gmapping_spa::backend {

// Thrown in place of a std::bad_alloc, of which nobody can tell what it was about.
struct OutOfMemory : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Calls `work` and returns what it returns. Where memory runs out, for a thread as well, throws
// OutOfMemory "out of memory <while>", where `while_text` is such as "while reading map.yaml".
template <typename Function>
auto WithMemory(const std::string& while_text, const Function& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    throw OutOfMemory("out of memory " + while_text);
  } catch (const std::system_error& error) {
    if (error.code() != std::errc::resource_unavailable_try_again) throw;
    throw OutOfMemory("out of memory for a thread " + while_text);
  }
}

// "a map of 400 x 300 cells needs 1 MB", in whole megabytes, rounded up.
inline std::string MemoryOfCells(std::int64_t width, std::int64_t height, int bytes_per_cell) {
  const std::int64_t megabytes = (width * height * bytes_per_cell + 999'999) / 1'000'000;
  return "a map of " + std::to_string(width) + " x " + std::to_string(height) + " cells needs " +
         std::to_string(megabytes) + " MB";
}

}  // namespace gmapping_spa::backend

#endif  // GMAPPING_SPA_BACKEND_OUT_OF_MEMORY_H_
