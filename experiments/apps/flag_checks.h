// Limits of flag values.
#ifndef GMAPPING_SPA_EXPERIMENTS_APPS_FLAG_CHECKS_H_
#define GMAPPING_SPA_EXPERIMENTS_APPS_FLAG_CHECKS_H_

#include <sstream>
#include <stdexcept>

namespace gmapping_spa::apps {

// Returns `value`; throws std::runtime_error with one line unless min <= value <= max. Not a number
// lies in no range.
template <typename T>
T InRange(const char* flag, T value, T min, T max) {
  if (value >= min && value <= max) return value;
  std::ostringstream message;
  message << "--" << flag << ": expected a value from " << min << " to " << max << ", found "
          << value;
  throw std::runtime_error(message.str());
}

}  // namespace gmapping_spa::apps

#endif  // GMAPPING_SPA_EXPERIMENTS_APPS_FLAG_CHECKS_H_
