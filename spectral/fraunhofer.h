#pragma once

namespace abbe {

/// Fraunhofer lines in nm: d (He), F and C (H) [TIE29].
inline constexpr double kLineD_nm = 587.5618;
inline constexpr double kLineF_nm = 486.1327;
inline constexpr double kLineC_nm = 656.2725;

} // namespace abbe
