#pragma once

#include "core/render/peers.h"
#include "core/render/render_state.h"
#include "io/states/block_file.h"
#include "io/states/state_info.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace abbe {

struct FilmRow;

/// Reads a state from a file, in the format of docs/state_format.md. Errors: ReadError, which says
/// why the file is refused; a damaged file is found before the state is used.
class StateReader {
public:
  /// Reads all but the film.
  explicit StateReader(const std::filesystem::path& file);

  [[nodiscard]] const StateInfo& info() const { return info_; }
  [[nodiscard]] const PixelWindow& window() const { return window_; }
  [[nodiscard]] const std::vector<LayerForm>& layers() const { return layers_; }
  [[nodiscard]] int done() const { return progress_.done; }
  /// How many tiles the plan has.
  [[nodiscard]] std::size_t tiles() const { return progress_.tiles.size(); }
  [[nodiscard]] double seconds() const { return progress_.seconds; }
  /// True where the film keeps all bands.
  [[nodiscard]] bool has_bands() const;
  /// True where all samples of the state's range are done.
  [[nodiscard]] bool complete() const;

  /// Reads the rest, once. The sums of all bands are kept where `place` says.
  [[nodiscard]] RenderState read(const BandPlace& place);
  /// The same, but of the film only what belongs to one of several peers.
  [[nodiscard]] RenderState read_share(const BandPlace& place, const Plan& plan,
                                       const Peers& peers);
  // The rest row by row instead, from the top to the last of the window, and then the end.
  void read_row(FilmRow& row);
  /// The state, whose film has no pixels but all that it holds beside them.
  [[nodiscard]] RenderState end_rows();
  /// Reads the rest only to see that it is not damaged.
  void check();

private:
  void read_info(const std::string& content);
  void read_progress(const std::string& content);
  void read_film_form(const std::string& content);
  [[nodiscard]] RenderState read(const BandPlace& place,
                                 const std::function<void(int, FilmRow&)>& change);

  BlockReader blocks_;
  StateInfo info_;
  RenderState progress_; ///< its film has no pixels
  PixelWindow window_;
  std::vector<LayerForm> layers_;
  double light_passes_ = 0.0;
  RefusedValues refused_;
};

} // namespace abbe
