#include "hdf5_handle.hpp"

namespace perinox::output {

namespace {
herr_t keep_first(unsigned level, const H5E_error2_t* error, void* reason) {
  if (level == 0 && error->desc != nullptr) *static_cast<std::string*>(reason) = error->desc;
  return 0;
}
}  // namespace

std::string take_reason() {
  std::string reason;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_first, &reason);
  H5Eclear2(H5E_DEFAULT);
  return reason.empty() ? "HDF5 gives no reason" : reason;
}

}  // namespace perinox::output
