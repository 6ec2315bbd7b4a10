#pragma once

#include "io/building/shape_material.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace abbe {

// Some keywords have an effect on some shapes or lights only: roughness on what mirrors or
// refracts, softEdge on spotlights. Each is a row of one of the two tables below. The reader of
// scenes notes each statement of such a keyword; the statement that acts on nothing that it
// applies to is warned of at its place.

/// A keyword that changes the current material.
struct MaterialEffect {
  std::string_view keyword;
  MaterialSlot slot;
  /// True where its value is that of no keyword, such as a roughness of 0.
  bool (*is_neutral)(const ShapeMaterial&);
  /// True where it makes a difference to a shape of this material, which is a solid or has no
  /// inside.
  bool (*acts)(const ShapeMaterial&, bool is_solid);
  std::string_view why_not; ///< where it makes none
};

/// A keyword that applies to the lights that follow.
struct LightEffect {
  std::string_view keyword;
  LightSlot slot;
  bool (*acts)(const LightKind&);
  std::string_view why_not;
};

/// The row of a keyword, by its name as its table has it; null: it always acts.
[[nodiscard]] const MaterialEffect* material_effect(std::string_view keyword);
[[nodiscard]] const LightEffect* light_effect(std::string_view keyword);

/// The statements that have been noted, and what they have acted on. A statement that is carried
/// out several times, as in a macro, is one.
class KeywordLedger {
public:
  /// Notes a statement in a slot of the current material or light. What was noted there before is
  /// no longer asked for: the last one counts.
  void note(NotedKeyword& slot, std::string_view keyword, const SourcePosition& where);
  /// The statement in the slot has met something it applies to.
  void meet(NotedKeyword slot, bool acts, std::string_view why_not);
  /// The statement may still be asked for, by a name.
  void keep(NotedKeyword slot);

  /// A shape of this material has been made.
  void meet_shape(const ShapeMaterial& material, bool is_solid);
  void meet_light(const LightKeywords& given, const LightKind& kind);

  /// Warns of each statement that had no effect, in the order of their first use.
  void warn_of_rest(const Warn& warn) const;

private:
  struct Place {
    std::int32_t file, line, column;
    friend bool operator==(const Place&, const Place&) = default;
  };
  struct Hash {
    std::size_t operator()(const Place& place) const;
  };
  struct Statement {
    Place place;
    std::string_view keyword, why_not;
    bool acted = false; ///< or may still act, or is not asked for
    bool met = false;
  };

  std::vector<std::string> files_;
  std::vector<Statement> statements_;
  std::unordered_map<Place, std::int32_t, Hash> numbers_;
};

} // namespace abbe
