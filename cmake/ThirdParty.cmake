# Third parties, each behind one imported target. Debian 12 has Embree 3 and Catch2 2,
# Debian 13 has Embree 4 and Catch2 3; both are found here and told apart in one source file each.
find_package(embree 4 CONFIG QUIET)
if(NOT embree_FOUND)
  find_package(embree 3 CONFIG REQUIRED)
endif()
message(STATUS "Embree ${embree_VERSION}")

find_package(TBB CONFIG REQUIRED)
find_package(glm CONFIG REQUIRED)
find_package(OpenEXR CONFIG REQUIRED)
find_package(TIFF REQUIRED)
find_package(PNG REQUIRED)
find_package(ZLIB REQUIRED)
find_package(fmt CONFIG REQUIRED)
find_package(CLI11 CONFIG REQUIRED)
find_package(nlohmann_json CONFIG REQUIRED)
find_package(Threads REQUIRED)

# abbe-mpi is built where MPI is found, as by ./abbe mpi, which installs it. Its C interface is used.
set(MPI_CXX_SKIP_MPICXX ON)
find_package(MPI QUIET COMPONENTS CXX)

find_path(LCMS2_INCLUDE_DIR lcms2.h REQUIRED)
find_library(LCMS2_LIBRARY lcms2 REQUIRED)
add_library(lcms2::lcms2 UNKNOWN IMPORTED)
set_target_properties(lcms2::lcms2 PROPERTIES
  IMPORTED_LOCATION "${LCMS2_LIBRARY}"
  INTERFACE_INCLUDE_DIRECTORIES "${LCMS2_INCLUDE_DIR}")

# Looks by OpenColorIO are there where it is found. Debian 12 puts its configuration for CMake where
# CMake does not look, with paths that fit elsewhere.
find_path(OCIO_INCLUDE_DIR OpenColorIO/OpenColorIO.h)
find_library(OCIO_LIBRARY OpenColorIO)
if(OCIO_INCLUDE_DIR AND OCIO_LIBRARY)
  add_library(ocio::ocio UNKNOWN IMPORTED)
  set_target_properties(ocio::ocio PROPERTIES
    IMPORTED_LOCATION "${OCIO_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${OCIO_INCLUDE_DIR}")
endif()

# The server of abbe preview, which is left out where this is missing. Debian builds it as a library;
# how it was built, which its header must know, stands in the file for pkg-config alone. It is no imported
# target, since these definitions are for one source file.
find_path(HTTPLIB_INCLUDE_DIR httplib.h)
find_library(HTTPLIB_LIBRARY cpp-httplib)
find_file(HTTPLIB_PKG_CONFIG cpp-httplib.pc PATH_SUFFIXES pkgconfig
  PATHS /usr/lib/${CMAKE_LIBRARY_ARCHITECTURE} /usr/lib /usr/share)
if(HTTPLIB_INCLUDE_DIR AND HTTPLIB_LIBRARY AND HTTPLIB_PKG_CONFIG)
  file(STRINGS "${HTTPLIB_PKG_CONFIG}" httplib_flags REGEX "^Cflags:")
  string(REGEX MATCHALL "CPPHTTPLIB_[A-Z_]+" HTTPLIB_DEFINITIONS "${httplib_flags}")
else()
  message(STATUS "cpp-httplib is missing: abbe preview is left out")
endif()

if(ABBE_TESTS)
  find_package(Catch2 CONFIG REQUIRED)
  message(STATUS "Catch2 ${Catch2_VERSION}")
endif()
