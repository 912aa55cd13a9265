#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Fails where a source does not begin with its licence, or a C++ source is not formatted as .clang-format says.
# Needs the clang-format of Debian 12: other versions format differently. To mend:
# git ls-files '*.h' '*.cc' | xargs clang-format -i
set -euo pipefail
cd "$(dirname "$0")/.."

# The first line, or the second one behind that of the interpreter.
find CMakeLists.txt backend experiments frontend plugins tests -name __pycache__ -prune -o -type f \( \
  -name '*.h' -o -name '*.cc' -o -name '*.c' -o -name '*.py' -o -name '*.sh' -o -name '*.cmake' -o -name CMakeLists.txt \
  \) -print0 | xargs -0 awk -v id="SPDX-License-Identifier: BSD-3-Clause" '
  FNR == 1 && /^#!/ { next }
  { if ($0 != "// " id && $0 != "# " id) { print FILENAME ": expected " id; missing = 1 } nextfile }
  END { exit missing }'

find backend experiments frontend plugins tests -name '*.h' -print0 -o -name '*.cc' -print0 |
  xargs -0 -n 50 -P "$(nproc)" clang-format --dry-run -Werror
