#include "io/write/unfinished_files.h"

#include <array>
#include <climits>
#include <cstring>
#include <unistd.h>

namespace pcl {
namespace symmetry {
namespace {

enum State : int { free_place, being_filled, in_use };

/** A name in memory that is there when a signal comes: a handler must not allocate, nor wait for a lock. */
struct Place {
  std::atomic<int> state{free_place};
  std::array<char, PATH_MAX> name{};
};

constexpr std::size_t file_limit = 32; ///< that are written at a time: one by each thread that writes

std::array<Place, file_limit> places;

} // namespace

void
UnfinishedFile::remember(const std::string& name)
{
  forget();
  if (name.size() >= PATH_MAX)
    return;
  for (std::size_t i = 0; i < places.size() && place_ == none; ++i) {
    int expected = free_place;
    if (places[i].state.compare_exchange_strong(expected, being_filled)) {
      std::memcpy(places[i].name.data(), name.c_str(), name.size() + 1);
      places[i].state = in_use;
      place_ = i;
    }
  }
}

void
UnfinishedFile::forget()
{
  if (place_ != none)
    places[place_].state = free_place;
  place_ = none;
}

void
removePartFiles() noexcept
{
  for (const Place& place : places)
    if (place.state == in_use)
      ::unlink(place.name.data());
}

} // namespace symmetry
} // namespace pcl
