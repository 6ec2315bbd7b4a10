#include "core/render/render_progress.h"

#include <cassert>

namespace abbe {

RenderProgress together(std::span<const RenderProgress> processes) {
  assert(!processes.empty());
  RenderProgress all = processes.front();
  for (const RenderProgress& process : processes.subspan(1)) {
    all.fraction += process.fraction;
    all.rays += process.rays;
  }
  all.fraction /= static_cast<double>(processes.size());
  return all;
}

} // namespace abbe
