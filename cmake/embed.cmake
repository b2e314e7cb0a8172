# Writes OUTPUT, a C++ source that holds the files of FOLDER with the EXTENSIONS (separated by blanks) as text: a
# function NAME of zonal/view/NAME.h gives all of them as TYPE{stem, text}. Run as a script when one of them changes.
separate_arguments(EXTENSIONS)
set(patterns ${EXTENSIONS})
list(TRANSFORM patterns PREPEND ${FOLDER}/*.)
file(GLOB files ${patterns})
set(text "#include \"zonal/view/${NAME}.h\"\n\nnamespace zonal {\nnamespace {\n\nconstexpr ${TYPE} kTexts[] = {\n")
foreach(file IN LISTS files)
  get_filename_component(stem ${file} NAME_WE)
  file(READ ${file} body)
  string(APPEND text "    {\"${stem}\", R\"embedded(${body})embedded\"},\n")
endforeach()
string(APPEND text "};\n\n}  // namespace\n\nstd::span<const ${TYPE}> ${NAME}() { return kTexts; }\n\n}  // namespace zonal\n")
file(WRITE ${OUTPUT} "${text}")
