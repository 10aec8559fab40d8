#include "random_scenes.hpp"

#include <stdexcept>

#include "cloud_scenes.hpp"
#include "lattice_scenes.hpp"
#include "other_scenes.hpp"

namespace perinox::invariance {

RandomScene random_scene(int number, const std::string& folder) {
  Lot lot(static_cast<unsigned>(1000 + number));
  RandomScene scene;
  const int sort = number % random_scene_sorts;
  switch (sort) {
    case 0:
      scene = one_lattice(lot);
      break;
    case 1:
      scene = several_lattices(lot);
      break;
    case 2:
      scene = bodies_apart(lot);
      break;
    case 3:
      scene = box_that_cuts_cells(lot);
      break;
    case 4:
      scene = curved_body(lot);
      break;
    case 5:
      scene = slit_body(lot);
      break;
    case 6:
      scene = split_body(lot);
      break;
    case 7:
      scene = jittered_cloud(lot, folder);
      break;
    case 8:
      scene = turned_cloud(lot, folder);
      break;
    case 9:
      scene = cloud_and_lattice(lot, folder);
      break;
    default:
      throw std::logic_error("there is no such sort of scene");
  }
  scene.name = "scene " + std::to_string(number) + ", " + scene.name;
  return scene;
}

}  // namespace perinox::invariance
