#pragma once

#include "core/bsdfs/incidence.h"

namespace abbe {

/// A thin film on a boundary, as a BSDF holds it.
struct FilmLayer {
  double thickness_nm = 0.0; ///< 0: there is none
  int index = -1;            ///< into Plan::layers

  [[nodiscard]] bool present() const { return thickness_nm > 0.0; }
  [[nodiscard]] BsdfLayer layer() const { return {index, present()}; }
  [[nodiscard]] FilmOptics optics(const Incidence& in) const {
    return {thickness_nm, in.n_layer, in.lambda_nm};
  }
};

} // namespace abbe
