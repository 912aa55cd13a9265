// A fixed amount of work, to compare figures from machines of different speed: floating point on
// registers, then dependent loads from a table larger than the caches near the core.
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <vector>

int main() {
  double x = 0.5;
  for (int i = 0; i < 40'000'000; ++i) x = std::sqrt(x * 1.000001 + 0.25) - 0.1;

  constexpr std::uint32_t kEntries = 1 << 22;  // 16 MB
  std::vector<std::uint32_t> next(kEntries);
  for (std::uint32_t i = 0; i < kEntries; ++i) next[i] = (i * 1664525u + 1013904223u) % kEntries;
  std::uint32_t at = 0;
  for (int i = 0; i < 10'000'000; ++i) at = next[at];

  const double cpu_s = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
  // The results are printed so that no compiler can leave the work out.
  std::printf("{\"cpu_s\": %.3f, \"checksum\": %.3f}\n", cpu_s, x + at);
}
