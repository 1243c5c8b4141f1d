// Names for the glyphs of Font Awesome 4.7 that we use.
#pragma once

namespace isoscope::icon {

constexpr const char* play = "\uf04b";
constexpr const char* pause = "\uf04c";
constexpr const char* first = "\uf049";
constexpr const char* back = "\uf048";
constexpr const char* forward = "\uf051";
constexpr const char* last = "\uf050";
constexpr const char* next_change = "\uf04e";
constexpr const char* eye = "\uf06e";
constexpr const char* eye_off = "\uf070";
constexpr const char* folder = "\uf07b";
constexpr const char* folder_open = "\uf07c";
constexpr const char* record = "\uf111";
constexpr const char* file = "\uf15b";
constexpr const char* camera = "\uf030";
constexpr const char* search = "\uf002";
constexpr const char* close = "\uf00d";
constexpr const char* check = "\uf00c";
constexpr const char* target = "\uf05b";
constexpr const char* cube = "\uf1b2";
constexpr const char* cubes = "\uf1b3";
constexpr const char* info = "\uf05a";
constexpr const char* warning = "\uf071";
constexpr const char* error = "\uf06a";
constexpr const char* help = "\uf059";
constexpr const char* restart = "\uf021";
constexpr const char* down = "\uf107";
constexpr const char* right = "\uf105";
constexpr const char* left = "\uf104";
constexpr const char* up = "\uf106";
constexpr const char* level_up = "\uf148";
constexpr const char* gallery = "\uf009";
constexpr const char* split = "\uf0db";
constexpr const char* square = "\uf096";
constexpr const char* list = "\uf03a";
constexpr const char* chart = "\uf080";
constexpr const char* clock = "\uf017";
constexpr const char* home = "\uf015";
constexpr const char* disk = "\uf0a0";
constexpr const char* stop = "\uf04d";
constexpr const char* bolt = "\uf0e7";
constexpr const char* upload = "\uf093";
constexpr const char* history = "\uf1da";
constexpr const char* layers = "\uf0c9";
constexpr const char* sliders = "\uf1de";
constexpr const char* scissors = "\uf0c4";
constexpr const char* flip = "\uf0ec";
constexpr const char* graduation = "\uf19d";
constexpr const char* star = "\uf005";
constexpr const char* mouse = "\uf245";
constexpr const char* dot = "\uf111";
constexpr const char* hole = "\uf10c";

} // namespace isoscope::icon
