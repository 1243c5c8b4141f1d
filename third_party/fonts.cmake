# Makes isoscope_fonts: the user interface's fonts, from the distribution's packages, embedded in the program.
#
# #include "embedded/fonts.h"; the names are roles, so that a replacement changes no code:
#   "ui" Inter Regular, "ui-bold" Inter SemiBold, "mono" JetBrains Mono, "icons" Font Awesome 4.7 (U+F000 to U+F2E0).
# Inter comes as OpenType with CFF outlines: use ImGui's FreeType builder. Where Inter or JetBrains Mono is missing,
# DejaVu takes the role.

# isoscope_find_font(RESULT LABEL PACKAGE file...): the first of the files that exists under the font folders.
function(isoscope_find_font result label package)
  set(folders opentype/inter truetype/inter truetype/jetbrains-mono truetype/jetbrains opentype/font-awesome
    truetype/font-awesome truetype/dejavu)
  list(TRANSFORM folders PREPEND /usr/share/fonts/)
  find_file(ISOSCOPE_FONT_${result} NAMES ${ARGN} PATHS ${folders} NO_DEFAULT_PATH)
  mark_as_advanced(ISOSCOPE_FONT_${result})
  isoscope_need("font ${label}" "${ISOSCOPE_FONT_${result}}" "${ISOSCOPE_FONT_${result}}" ${package})
endfunction()

isoscope_find_font(UI "Inter" fonts-inter Inter-Regular.otf Inter-Regular.ttf DejaVuSans.ttf)
isoscope_find_font(UI_BOLD "Inter SemiBold" fonts-inter Inter-SemiBold.otf Inter-SemiBold.ttf DejaVuSans-Bold.ttf)
isoscope_find_font(MONO "JetBrains Mono" fonts-jetbrains-mono JetBrainsMono-Regular.ttf JetBrainsMono-Regular.otf
  DejaVuSansMono.ttf)
isoscope_find_font(ICONS "Font Awesome" fonts-font-awesome FontAwesome.otf fontawesome-webfont.ttf)
isoscope_embed(isoscope_fonts NAME fonts FILES
  ui=${ISOSCOPE_FONT_UI} ui-bold=${ISOSCOPE_FONT_UI_BOLD} mono=${ISOSCOPE_FONT_MONO} icons=${ISOSCOPE_FONT_ICONS})
