#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lacuna {

/// An upright rectangle in points (1/72 inch), y down.
struct Box {
    double x = 0, y = 0, width = 0, height = 0;

    double right() const { return x + width; }
    double bottom() const { return y + height; }
    glm::dvec2 middle() const { return {x + 0.5 * width, y + 0.5 * height}; }
    bool contains(const glm::dvec2& p) const { return p.x >= x && p.x <= right() && p.y >= y && p.y <= bottom(); }
    bool meets(const Box& o) const { return x < o.right() && o.x < right() && y < o.bottom() && o.y < bottom(); }
    Box shrunk(double by) const { return {x + by, y + by, width - 2 * by, height - 2 * by}; }
};

/// How a line or an edge is drawn.
struct Stroke {
    glm::dvec3 color{0.0};  ///< sRGB 0..1, as all colours here
    double width = 1;       ///< points
    double opacity = 1;
    std::vector<double> dashes = {};  ///< lengths on, off, ... in points; empty: solid
};

struct Fill {
    glm::dvec3 color{0.0};
    double opacity = 1;
};

struct TextStyle {
    double size = 8.5;  ///< points
    bool bold = false;
    glm::dvec3 color{0.13};
    bool tabular = false;  ///< all digits equally wide, for columns of numbers
};

/// Which part of a text lies at the point given.
enum class Align { start, middle, end };

/// A page to draw on, in points, y down: SVG, PNG or PDF from the same calls. Text is set by Pango in the first of
/// Inter and DejaVu Sans that is installed, and becomes outlines in SVG and embedded fonts in PDF. One thread at a
/// time.
class Canvas {
public:
    /// @param title  read aloud by screen readers and shown as a tooltip
    static Canvas svg(glm::dvec2 size, std::string_view title = {});
    /// @param pixels_per_point  2.5 gives 180 dots an inch
    static Canvas png(glm::dvec2 size, double pixels_per_point = 2.5);
    /// @param created  ISO 8601 date of the document; empty: none is written, so that equal pages are equal bytes
    static Canvas pdf(glm::dvec2 size, std::string_view title = {}, std::string_view created = {});
    Canvas(Canvas&&) noexcept;
    Canvas& operator=(Canvas&&) noexcept;
    ~Canvas();

    glm::dvec2 size() const;
    /// PDF: what follows goes on a new page of the same size. @throws Error(unsupported) for the others
    void next_page();

    void line(const glm::dvec2& from, const glm::dvec2& to, const Stroke& stroke);
    void polyline(std::span<const glm::dvec2> points, const Stroke& stroke);
    void polygon(std::span<const glm::dvec2> points, const Fill& fill);
    void polygon(std::span<const glm::dvec2> points, const Fill& fill, const Stroke& edge);
    void rectangle(const Box& box, const Fill& fill);
    void frame(const Box& box, const Stroke& stroke);
    void circle(const glm::dvec2& middle, double radius, const Fill& fill, const Stroke& edge);
    /// 8-bit RGB, 3 bytes a pixel, row 0 on top, stretched into the box: smoothed where it shrinks, in squares where
    /// it grows.
    /// @throws Error(bad_usage) if the bytes are no picture of that size
    void image(glm::ivec2 pixels, std::span<const std::uint8_t> rgb, const Box& box);

    /// One line of text; `at` is where it starts, its middle or its end, and the top, middle or bottom of its line.
    /// @param turned  reads upwards (for the title of a y axis); `at` and the alignments turn with it
    void text(std::string_view text, const glm::dvec2& at, const TextStyle& style, Align across = Align::start,
              Align down = Align::middle, bool turned = false);
    /// Text broken into lines no wider than `width`. @return its height
    double paragraph(std::string_view text, const glm::dvec2& top_left, double width, const TextStyle& style);
    /// Width and height of a text, in lines no wider than `width` where it is above 0.
    glm::dvec2 measure(std::string_view text, const TextStyle& style, double width = 0) const;

    /// Nothing is drawn outside the box until unclip(). Pairs nest.
    void clip(const Box& box);
    void unclip();

    /// Ends the drawing and gives the file's bytes. @throws Error(io) if Cairo failed. Call once.
    std::string finish();

private:
    struct State;
    explicit Canvas(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

}  // namespace lacuna
