# Writes a source file that holds other files as text, so that a program carries its pages. Run with
# OUTPUT (the source to write), FUNCTION (what it defines), and FILES (paths, separated by |). The
# function takes a file's name without its folder and returns its text.

string(REPLACE "|" ";" files "${FILES}")
set(source "")
string(APPEND source "// Made by cmake/EmbedFiles.cmake.\n#include \"io/pages/page_files.h\"\n\n"
  "#include <stdexcept>\n#include <string>\n\nnamespace abbe {\n\n"
  "std::string_view ${FUNCTION}(std::string_view name) {\n")
foreach(file IN LISTS files)
  get_filename_component(name "${file}" NAME)
  file(READ "${file}" text)
  string(APPEND source "  if (name == \"${name}\")\n    return R\"~page~(${text})~page~\";\n")
endforeach()
string(APPEND source "  throw std::logic_error(\"no page file \" + std::string(name));\n}\n\n} // namespace abbe\n")
file(WRITE "${OUTPUT}" "${source}")
