#include "delaunay/options.hpp"

#include "delaunay/error.hpp"

namespace delone {

void ProgressMeter::report() {
  next_ += stride_;
  if (!progress_(static_cast<double>(done_) / static_cast<double>(total_)))
    throw Cancelled();
}

}  // namespace delone
