#include "lengths.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "perinox/body/shape.hpp"

namespace perinox::body {

namespace {
/// Lengths of the deck that are equal up to their rounding fit.
constexpr double slack = 1e-9;
/// A body of one particle may be somewhat smaller than its cell.
constexpr double most_over_body = 1.5;

double longest_extent(const deck::Shape& shape, int dimension) {
  const Bounds box = bounds(shape);
  double longest = 0;
  for (int axis = 0; axis < dimension; ++axis) longest = std::max(longest, box.max[axis] - box.min[axis]);
  return longest;
}
}  // namespace

void refuse_unfit_lengths(const deck::Deck& deck, double horizon, double reach) {
  for (const deck::BodyPart& part : deck.body) {
    if (std::holds_alternative<deck::CloudFile>(part.shape.form) || !(part.spacing > 0)) continue;
    const double longest = longest_extent(part.shape, deck::unknowns(deck.dimension));
    if (longest > 0 && part.spacing > most_over_body * longest)
      deck::refuse(part.spacing_location,
                   fmt::format("the spacing {:g} is larger than the whole body {}, whose longest side is {:g}; make it "
                               "a tenth of that or less, or check that both are in the same unit",
                               part.spacing, part.name, longest));
    if (reach < part.spacing * (1 - slack))
      deck::refuse(
          deck.horizon.location,
          fmt::format("the horizon {:g} is shorter than the spacing {:g} of the body {}, so that its particles "
                      "have no neighbours; a horizon of 3 spacings is usual: make it {:g}, or the spacing "
                      "smaller",
                      horizon, part.spacing, part.name, 3 * part.spacing));
  }
}

}  // namespace perinox::body
