// SPDX-License-Identifier: BSD-3-Clause
#include "frontend/session/state.h"

#include <cereal/types/common.hpp>
#include <cereal/types/deque.hpp>
#include <cereal/types/map.hpp>
#include <cereal/types/memory.hpp>
#include <cereal/types/optional.hpp>
#include <cereal/types/string.hpp>
#include <cereal/types/vector.hpp>

#include <stdexcept>
#include <string>

#include "frontend/session/archive.h"
#include "frontend/session/plain_data.h"

namespace gmapping_spa::session {

std::string SaveState(const frontend::ImprovedGmapping& gmapping) {
  SaveArchive archive;
  archive(gmapping);
  return archive.TakeBytes();
}

void LoadState(std::string_view state, frontend::ImprovedGmapping* gmapping) {
  LoadKnown(state, gmapping);
  const std::size_t count = gmapping->filter().particles().size();
  const int expected = gmapping->filter().options().particles;
  if (count == 0 || count == static_cast<std::size_t>(expected)) return;
  throw std::runtime_error("expected " + std::to_string(expected) + " particles, found " +
                           std::to_string(count));
}

void LoadKnown(std::string_view state, frontend::ImprovedGmapping* gmapping) {
  LoadArchive archive(state);
  archive(*gmapping);
  if (archive.left() > 0) throw std::runtime_error("the state goes on behind its end");
}

}  // namespace gmapping_spa::session
