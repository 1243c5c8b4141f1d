// Glyphs are told by the place of their picture in the atlas, lines by the place where the pen went on.
#include "ui/words_on_screen.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace isoscope {
namespace {

struct KnownGlyph {
  const ImFontGlyph* glyph;
  float size; ///< of its font, pixels
};

/// All glyphs of an atlas by the left end of their pictures.
class Glyphs {
 public:
  explicit Glyphs(const ImFontAtlas& atlas) {
    for (const ImFont* font : atlas.Fonts)
      for (const ImFontGlyph& glyph : font->Glyphs)
        if (glyph.Visible) all_.push_back({&glyph, font->FontSize});
    std::stable_sort(all_.begin(), all_.end(),
                     [](const KnownGlyph& a, const KnownGlyph& b) { return a.glyph->U0 < b.glyph->U0; });
    for (const KnownGlyph& g : all_) widest_ = std::max(widest_, g.glyph->U1 - g.glyph->U0);
  }

  /// Whose picture holds that place.
  const KnownGlyph* at(ImVec2 uv) const {
    const auto after = std::upper_bound(all_.begin(), all_.end(), uv.x,
                                        [](float u, const KnownGlyph& g) { return u < g.glyph->U0; });
    for (auto g = after; g != all_.begin();) {
      --g;
      if (g->glyph->U0 + widest_ < uv.x) break;
      if (uv.x <= g->glyph->U1 && uv.y >= g->glyph->V0 && uv.y <= g->glyph->V1) return &*g;
    }
    return nullptr;
  }

 private:
  std::vector<KnownGlyph> all_;
  float widest_ = 0;
};

void append(std::string& text, unsigned letter) {
  const auto put = [&](unsigned byte) { text += static_cast<char>(static_cast<unsigned char>(byte)); };
  if (letter < 0x80) return put(letter);
  if (letter < 0x800) return put(0xC0 | letter >> 6), put(0x80 | (letter & 0x3F));
  put(0xE0 | letter >> 12), put(0x80 | (letter >> 6 & 0x3F)), put(0x80 | (letter & 0x3F));
}

/// Writes letters into words.
class Reader {
 public:
  Reader(std::vector<SeenWords>& words, std::string surface) : words_(words), surface_(std::move(surface)) {}

  void read(const KnownGlyph& known, ImVec2 low, ImVec2 high, const ImVec4& clip) {
    const ImFontGlyph& g = *known.glyph;
    const float scale = g.Y1 > g.Y0 ? (high.y - low.y) / (g.Y1 - g.Y0) : 1, pen = low.x - g.X0 * scale,
                line = low.y - g.Y0 * scale, size = known.size * scale;
    const ImVec2 seen_low{std::max(low.x, clip.x), std::max(low.y, clip.y)},
        seen_high{std::min(high.x, clip.z), std::min(high.y, clip.w)};
    const float overhang = 0.12f * size; // as of a j
    // Of a line that is scrolled half out of sight all letters are seen or none.
    const float line_seen = std::min(line + size, clip.w) - std::max(line, clip.y);
    const bool in_line = line_seen > size / 2,
               seen = in_line && seen_high.x - seen_low.x > (high.x - low.x) / 2,
               cut = in_line && (low.x < clip.x - overhang || high.x > clip.z + overhang);
    constexpr float tolerance = 1.5f;
    const bool goes_on = at_ && std::abs(line - line_) < tolerance && pen > pen_ - tolerance &&
                         pen < pen_ + blanks * size && surface_ == words_[*at_].surface;
    if (!goes_on) {
      at_.reset();
      cut_before_ = false;
    }
    if (seen) {
      if (!at_) {
        at_ = words_.size();
        words_.push_back({"", seen_low, seen_high, cut_before_, surface_});
      } else if (pen > pen_ + tolerance) {
        words_[*at_].text += ' ';
      }
      SeenWords& words = words_[*at_];
      append(words.text, g.Codepoint);
      words.cut |= cut;
      words.low = {std::min(words.low.x, seen_low.x), std::min(words.low.y, seen_low.y)};
      words.high = {std::max(words.high.x, seen_high.x), std::max(words.high.y, seen_high.y)};
    } else if (cut && at_) {
      words_[*at_].cut = true;
    } else {
      cut_before_ |= cut;
    }
    pen_ = pen + g.AdvanceX * scale;
    line_ = line;
  }

 private:
  static constexpr float blanks = 0.8f; ///< of the font's size: two blanks
  std::vector<SeenWords>& words_;
  std::string surface_;
  std::optional<std::size_t> at_;
  bool cut_before_ = false;
  float pen_ = 0, line_ = 0;
};

std::string without_blanks(std::string_view text) {
  std::string out;
  std::copy_if(text.begin(), text.end(), std::back_inserter(out), [](char c) { return c != ' '; });
  return out;
}

} // namespace

std::vector<SeenWords> words_on_screen(const ImDrawData& frame, const ImFontAtlas& atlas) {
  std::vector<SeenWords> words;
  const Glyphs glyphs(atlas);
  const ImVec4 screen{frame.DisplayPos.x, frame.DisplayPos.y, frame.DisplayPos.x + frame.DisplaySize.x,
                      frame.DisplayPos.y + frame.DisplaySize.y};
  for (int l = 0; l < frame.CmdListsCount; ++l) {
    const ImDrawList& list = *frame.CmdLists[l];
    Reader reader(words, list._OwnerName ? list._OwnerName : "");
    for (const ImDrawCmd& command : list.CmdBuffer) {
      if (command.UserCallback != nullptr || command.GetTexID() != atlas.TexID) continue;
      const ImVec4& c = command.ClipRect;
      const ImVec4 clip{std::max(c.x, screen.x), std::max(c.y, screen.y), std::min(c.z, screen.z),
                        std::min(c.w, screen.w)};
      const auto vertex = [&](unsigned i) -> const ImDrawVert& {
        return list.VtxBuffer[static_cast<int>(command.VtxOffset + list.IdxBuffer[static_cast<int>(i)])];
      };
      const unsigned end = command.IdxOffset + command.ElemCount;
      for (unsigned i = command.IdxOffset; i + 6 <= end;) {
        const ImDrawVert &low = vertex(i), &high = vertex(i + 2);
        const bool quad = low.uv.x < high.uv.x && low.uv.y < high.uv.y && low.pos.x < high.pos.x &&
                          low.pos.y < high.pos.y && vertex(i + 3).pos.x == low.pos.x &&
                          vertex(i + 4).pos.x == high.pos.x && vertex(i + 5).pos.y == high.pos.y;
        const KnownGlyph* known =
            quad ? glyphs.at({(low.uv.x + high.uv.x) / 2, (low.uv.y + high.uv.y) / 2}) : nullptr;
        // A triangle of something else.
        if (known == nullptr) {
          i += 3;
          continue;
        }
        reader.read(*known, low.pos, high.pos, clip);
        i += 6;
      }
    }
  }
  return words;
}

bool can_be_read(const std::vector<SeenWords>& seen, std::string_view words) {
  std::string all;
  for (const SeenWords& w : seen) all += without_blanks(w.text);
  return all.find(without_blanks(words)) != std::string::npos;
}

const SeenWords* find_words(const std::vector<SeenWords>& seen, std::string_view words) {
  const std::string wanted = without_blanks(words);
  const SeenWords* found = nullptr;
  for (const SeenWords& w : seen) {
    const std::string text = without_blanks(w.text);
    const bool whole = found != nullptr && without_blanks(found->text) == wanted;
    if (text == wanted || (!whole && text.find(wanted) != std::string::npos)) found = &w;
  }
  return found;
}

} // namespace isoscope
