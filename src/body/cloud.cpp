#include "cloud.hpp"

#include <fmt/format.h>

#include "perinox/body/csv.hpp"

namespace perinox::body {

std::vector<Particle> read_cloud(const deck::Deck& deck, int part, GlobalId first_id) {
  const deck::Shape& shape = deck.body[part].shape;
  const CsvTable table(std::get<deck::CloudFile>(shape.form).path, shape.location,
                       {"a point cloud", {"x", "y", "z", "volume"}, {}});
  const std::size_t x = table.column("x"), y = table.column("y"), z = table.column("z");
  const std::size_t volume = table.column("volume");
  const bool flat = deck::unknowns(deck.dimension) == 2;

  std::vector<Particle> particles;
  particles.reserve(table.rows());
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (!(table.value(row, volume) > 0)) {
      deck::refuse(table.where(row, volume), fmt::format("the volume of a particle must be greater than 0, but is {:g}",
                                                         table.value(row, volume)));
    }
    if (flat && table.value(row, z) != 0) {
      deck::refuse(table.where(row, z), fmt::format("z must be 0 in 2-D, but is {:g}", table.value(row, z)));
    }
    particles.push_back({first_id + static_cast<GlobalId>(row),
                         {table.value(row, x), table.value(row, y), table.value(row, z)},
                         table.value(row, volume),
                         part});
  }
  return particles;
}

}  // namespace perinox::body
