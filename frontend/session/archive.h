// SPDX-License-Identifier: BSD-3-Clause
// Archives of cereal, in memory: what a class calls in its function serialize.
#ifndef GMAPPING_SPA_FRONTEND_SESSION_ARCHIVE_H_
#define GMAPPING_SPA_FRONTEND_SESSION_ARCHIVE_H_

#include <bit>
#include <cereal/cereal.hpp>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

#include "frontend/map/tile.h"

namespace gmapping_spa::session {

static_assert(std::endian::native == std::endian::little, "numbers are written as they are");

// Not the binary archives of cereal: these go through streams number by number, and ask for as much
// memory as a file says.
class SaveArchive : public cereal::OutputArchive<SaveArchive, cereal::AllowEmptyClassElision> {
 public:
  SaveArchive() : OutputArchive(this) {}

  void SaveBytes(const void* data, std::size_t size) {
    bytes_.append(static_cast<const char*>(data), size);
  }

  // For classes that have no default constructor: here, `values` are as many already.
  template <typename Value>
  void Resize(std::size_t /*count*/, const Value& /*prototype*/, std::vector<Value>* /*values*/) {}

  // The number of the tile, from 1 in the order in which tiles were met; 0: none. Whether it is met
  // for the first time.
  std::pair<std::uint32_t, bool> NumberOf(const map::Tile* tile) {
    if (tile == nullptr) return {0, false};
    const auto next = static_cast<std::uint32_t>(numbers_.size() + 1);
    const auto [found, is_new] = numbers_.emplace(tile, next);
    return {found->second, is_new};
  }

  std::string TakeBytes() { return std::move(bytes_); }

 private:
  std::string bytes_;
  std::unordered_map<const map::Tile*, std::uint32_t> numbers_;
};

// Throws std::runtime_error where there are fewer bytes than a value takes, before memory is asked
// for.
class LoadArchive : public cereal::InputArchive<LoadArchive, cereal::AllowEmptyClassElision> {
 public:
  explicit LoadArchive(std::span<const char> bytes) : InputArchive(this), rest_(bytes) {}

  void LoadBytes(void* data, std::size_t size) {
    CheckRoom(size);
    if (size > 0) std::memcpy(data, rest_.data(), size);
    rest_ = rest_.subspan(size);
  }

  // Everything takes a byte at least.
  void CheckRoom(std::size_t count) const {
    if (count > rest_.size()) throw std::runtime_error("the state ends too early");
  }

  template <typename Value>
  void Resize(std::size_t count, const Value& prototype, std::vector<Value>* values) {
    CheckRoom(count);
    values->assign(count, prototype);
  }

  // The tiles met so far, in the order of their numbers.
  std::vector<map::TilePtr>& tiles() { return tiles_; }

  // Bytes that were not read yet.
  std::size_t left() const { return rest_.size(); }

 private:
  std::span<const char> rest_;
  std::vector<map::TilePtr> tiles_;
};

// What cereal wants an archive to do.
template <typename Number>
requires std::is_arithmetic_v<Number>
void save(SaveArchive& archive, const Number& number) { archive.SaveBytes(&number, sizeof number); }
template <typename Number>
requires std::is_arithmetic_v<Number>
void load(LoadArchive& archive, Number& number) {
  if constexpr (std::is_same_v<Number, bool>) {
    std::uint8_t byte = 0;
    archive.LoadBytes(&byte, 1);
    number = byte != 0;
  } else {
    archive.LoadBytes(&number, sizeof number);
  }
}
template <typename Size>
void save(SaveArchive& archive, const cereal::SizeTag<Size>& tag) {
  archive(tag.size);
}
template <typename Size>
void load(LoadArchive& archive, cereal::SizeTag<Size>& tag) {
  archive(tag.size);
  archive.CheckRoom(tag.size);
}
template <typename Data>
void save(SaveArchive& archive, const cereal::BinaryData<Data>& data) {
  archive.SaveBytes(data.data, data.size);
}
template <typename Data>
void load(LoadArchive& archive, cereal::BinaryData<Data>& data) {
  archive.LoadBytes(data.data, data.size);
}
template <typename Archive, typename Value>
requires std::is_base_of_v<SaveArchive, Archive> || std::is_base_of_v<LoadArchive, Archive>
void serialize(Archive& archive, cereal::NameValuePair<Value>& pair) { archive(pair.value); }

}  // namespace gmapping_spa::session

CEREAL_SETUP_ARCHIVE_TRAITS(gmapping_spa::session::LoadArchive, gmapping_spa::session::SaveArchive)

#endif  // GMAPPING_SPA_FRONTEND_SESSION_ARCHIVE_H_
