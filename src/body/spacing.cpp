#include "perinox/body/spacing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cloud.hpp"
#include "perinox/body/body.hpp"
#include "perinox/body/together.hpp"
#include "size.hpp"

namespace perinox::body {

double edge_of(double volume, int dimension) { return dimension == 3 ? std::cbrt(volume) : std::sqrt(volume); }

double largest_spacing(const deck::Deck& deck, const Communicator& communicator) {
  double largest = 0;
  together(communicator, [&] {
    for (std::size_t part = 0; part < deck.body.size(); ++part) {
      const deck::BodyPart& body = deck.body[part];
      if (body.spacing > 0) {
        largest = std::max(largest, body.spacing);
      } else if (std::holds_alternative<deck::CloudFile>(body.shape.form)) {
        if (!communicator.is_root()) continue;
        double volume = 0;
        const std::vector<Particle> particles = read_cloud(deck, static_cast<int>(part), 0);
        for (const Particle& particle : particles) volume += particle.volume;
        const double mean = edge_of(volume / static_cast<double>(particles.size()), deck::unknowns(deck.dimension));
        refuse_odd_length(mean, body.location, "the body " + body.name + ", on average,");
        largest = std::max(largest, mean);
      } else {
        deck::refuse(body.location, fmt::format("the body {} needs a spacing greater than 0", body.name));
      }
    }
    if (deck.body.empty()) deck::refuse({deck.file, 0, 0}, "the deck has no body; add one under body");
  });
  return communicator.max(largest);
}

double horizon_length(const deck::Deck& deck, const Communicator& communicator) {
  const double length =
      deck.horizon.length ? *deck.horizon.length : deck.horizon.ratio.value_or(0) * largest_spacing(deck, communicator);
  if (!(length > 0) || !std::isfinite(length)) {
    deck::refuse(deck.horizon.location, fmt::format("the horizon must be greater than 0, but is {:g}; give either its "
                                                    "ratio to the spacing or its length",
                                                    length));
  }
  return length;
}

}  // namespace perinox::body
