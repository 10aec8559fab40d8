#include "perinox/core/sentence.hpp"

namespace perinox {

std::string first_sentence(const Communicator& ranks, const std::string& mine) {
  const long long none = ranks.size();
  const long long speaker = -ranks.max(mine.empty() ? -none : -static_cast<long long>(ranks.rank()));
  if (speaker == none) return "";
  auto length = static_cast<int>(mine.size());
  MPI_Bcast(&length, 1, MPI_INT, static_cast<int>(speaker), ranks.mpi());
  std::string text = mine;
  text.resize(static_cast<std::size_t>(length));
  MPI_Bcast(text.data(), length, MPI_CHAR, static_cast<int>(speaker), ranks.mpi());
  return text;
}

}  // namespace perinox
