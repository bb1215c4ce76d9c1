# Writes a .cpp file that holds files as bytes and defines the function of ROOM/NAME.h that gives them by file name:
#   cmake -DOUT=asset.cpp -DROOM=report -DNAME=asset -DFILES="a.js;b.css" -P Embed.cmake
set(entries "")
set(bytes "")
foreach(file IN LISTS FILES)
  get_filename_component(name ${file} NAME)
  string(MAKE_C_IDENTIFIER ${name} id)
  file(READ ${file} hex HEX)
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," hex "${hex}")
  string(APPEND bytes "constexpr unsigned char ${id}[] = {${hex}0};\n")
  string(APPEND entries "  if (name == \"${name}\") return {reinterpret_cast<const char*>(${id}), sizeof ${id} - 1};\n")
endforeach()
file(WRITE ${OUT} "#include \"${ROOM}/${NAME}.h\"\n\nnamespace unietp {\nnamespace {\n${bytes}}  // namespace\n
std::string_view ${NAME}(std::string_view name) {\n${entries}  return {};\n}\n
}  // namespace unietp\n")
