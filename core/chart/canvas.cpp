#include "core/chart/canvas.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>
#include <pango/pangocairo.h>

#include <cmath>

#include "core/base/error.h"
#include "core/chart/svg_text.h"

namespace lacuna {

namespace {

constexpr const char* k_families = "Inter, DejaVu Sans, sans-serif";

cairo_status_t append(void* bytes, const unsigned char* data, unsigned int length) {
    static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
}

void check(cairo_status_t status) {
    if (status != CAIRO_STATUS_SUCCESS)
        throw Error(Errc::io, std::string("The drawing failed: ") + cairo_status_to_string(status) + ".");
}

void check_size(const glm::dvec2& size, double scale = 1) {
    constexpr double k_most = 16384;
    if (!(size.x > 0 && size.y > 0 && size.x * scale <= k_most && size.y * scale <= k_most))
        throw Error(Errc::bad_usage, "A drawing must be wider and higher than 0 and at most 16384 pixels a side.");
}

}  // namespace

struct Canvas::State {
    enum class Kind { svg, png, pdf } kind = Kind::svg;
    glm::dvec2 size{0};
    std::string title, bytes;
    cairo_surface_t* surface = nullptr;
    cairo_t* cairo = nullptr;
    bool finished = false;

    State(Kind k, glm::dvec2 s) : kind(k), size(s) {}
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() {
        if (cairo) cairo_destroy(cairo);
        if (surface) cairo_surface_destroy(surface);
    }

    void open() {
        check(cairo_surface_status(surface));
        cairo = cairo_create(surface);
        check(cairo_status(cairo));
        cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
        cairo_set_line_cap(cairo, CAIRO_LINE_CAP_BUTT);
    }

    void set(const glm::dvec3& c, double opacity) { cairo_set_source_rgba(cairo, c.x, c.y, c.z, opacity); }

    void stroke(const Stroke& s) {
        set(s.color, s.opacity);
        cairo_set_line_width(cairo, s.width);
        cairo_set_dash(cairo, s.dashes.data(), int(s.dashes.size()), 0);
        cairo_stroke(cairo);
    }

    void fill(const Fill& f) {
        set(f.color, f.opacity);
        cairo_fill(cairo);
    }

    void path(std::span<const glm::dvec2> points) {
        cairo_new_path(cairo);
        for (const glm::dvec2& p : points) cairo_line_to(cairo, p.x, p.y);
    }

    /// @return a layout the caller owns
    PangoLayout* layout(std::string_view text, const TextStyle& style, double width) const {
        PangoLayout* made = pango_cairo_create_layout(cairo);
        // Positions are points, whatever the resolution the surface claims.
        pango_cairo_context_set_resolution(pango_layout_get_context(made), 72);
        cairo_font_options_t* options = cairo_font_options_create();
        cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
        cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
        cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
        pango_cairo_context_set_font_options(pango_layout_get_context(made), options);
        cairo_font_options_destroy(options);
        PangoFontDescription* font = pango_font_description_new();
        pango_font_description_set_family_static(font, k_families);
        pango_font_description_set_weight(font, style.bold ? PANGO_WEIGHT_SEMIBOLD : PANGO_WEIGHT_NORMAL);
        pango_font_description_set_size(font, int(std::lround(style.size * PANGO_SCALE)));
        pango_layout_set_font_description(made, font);
        pango_font_description_free(font);
        if (style.tabular) {
            PangoAttrList* attributes = pango_attr_list_new();
            pango_attr_list_insert(attributes, pango_attr_font_features_new("tnum=1"));
            pango_layout_set_attributes(made, attributes);
            pango_attr_list_unref(attributes);
        }
        if (width > 0) {
            pango_layout_set_width(made, int(std::lround(width * PANGO_SCALE)));
            pango_layout_set_wrap(made, PANGO_WRAP_WORD_CHAR);
        }
        const std::string valid = valid_utf8(text);
        pango_layout_set_text(made, valid.data(), int(valid.size()));
        pango_layout_context_changed(made);
        return made;
    }

    static glm::dvec2 size_of(PangoLayout* layout) {
        PangoRectangle box;
        pango_layout_get_extents(layout, nullptr, &box);
        return {double(box.width) / PANGO_SCALE, double(box.height) / PANGO_SCALE};
    }
};

Canvas::Canvas(std::unique_ptr<State> state) : state_(std::move(state)) { state_->open(); }
Canvas::Canvas(Canvas&&) noexcept = default;
Canvas& Canvas::operator=(Canvas&&) noexcept = default;
Canvas::~Canvas() = default;

Canvas Canvas::svg(glm::dvec2 size, std::string_view title) {
    check_size(size);
    auto state = std::make_unique<State>(State::Kind::svg, size);
    state->title = title;
    state->surface = cairo_svg_surface_create_for_stream(append, &state->bytes, size.x, size.y);
    Canvas canvas(std::move(state));
    canvas.rectangle({0, 0, size.x, size.y}, {glm::dvec3(1), 1});  // legible on a dark page too
    return canvas;
}

Canvas Canvas::png(glm::dvec2 size, double pixels_per_point) {
    if (!(pixels_per_point > 0)) throw Error(Errc::bad_usage, "A picture needs more than 0 pixels a point.");
    check_size(size, pixels_per_point);
    auto state = std::make_unique<State>(State::Kind::png, size);
    const glm::ivec2 pixels = glm::max(glm::ivec2(glm::round(size * pixels_per_point)), 1);
    state->surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, pixels.x, pixels.y);
    Canvas canvas(std::move(state));
    cairo_scale(canvas.state_->cairo, pixels.x / size.x, pixels.y / size.y);
    canvas.rectangle({0, 0, size.x, size.y}, {glm::dvec3(1), 1});
    return canvas;
}

Canvas Canvas::pdf(glm::dvec2 size, std::string_view title, std::string_view created) {
    check_size(size);
    auto state = std::make_unique<State>(State::Kind::pdf, size);
    state->surface = cairo_pdf_surface_create_for_stream(append, &state->bytes, size.x, size.y);
    const auto tell = [&](cairo_pdf_metadata_t what, const std::string& value) {
        cairo_pdf_surface_set_metadata(state->surface, what, value.c_str());
    };
    tell(CAIRO_PDF_METADATA_TITLE, valid_utf8(title));
    tell(CAIRO_PDF_METADATA_CREATOR, "Lacuna");
    tell(CAIRO_PDF_METADATA_CREATE_DATE, std::string(created));
    return Canvas(std::move(state));
}

glm::dvec2 Canvas::size() const { return state_->size; }

void Canvas::next_page() {
    if (state_->kind != State::Kind::pdf) throw Error(Errc::unsupported, "Only a PDF has more than one page.");
    cairo_show_page(state_->cairo);
}

void Canvas::line(const glm::dvec2& from, const glm::dvec2& to, const Stroke& stroke) {
    const glm::dvec2 points[] = {from, to};
    polyline(points, stroke);
}

void Canvas::polyline(std::span<const glm::dvec2> points, const Stroke& stroke) {
    state_->path(points);
    state_->stroke(stroke);
}

void Canvas::polygon(std::span<const glm::dvec2> points, const Fill& fill) {
    state_->path(points);
    cairo_close_path(state_->cairo);
    state_->fill(fill);
}

void Canvas::polygon(std::span<const glm::dvec2> points, const Fill& fill, const Stroke& edge) {
    polygon(points, fill);
    state_->path(points);
    cairo_close_path(state_->cairo);
    state_->stroke(edge);
}

void Canvas::rectangle(const Box& box, const Fill& fill) {
    cairo_new_path(state_->cairo);
    cairo_rectangle(state_->cairo, box.x, box.y, box.width, box.height);
    state_->fill(fill);
}

void Canvas::frame(const Box& box, const Stroke& stroke) {
    cairo_new_path(state_->cairo);
    cairo_rectangle(state_->cairo, box.x, box.y, box.width, box.height);
    state_->stroke(stroke);
}

void Canvas::circle(const glm::dvec2& middle, double radius, const Fill& fill, const Stroke& edge) {
    const auto path = [&] {
        cairo_new_path(state_->cairo);
        cairo_arc(state_->cairo, middle.x, middle.y, radius, 0, 2 * M_PI);
        cairo_close_path(state_->cairo);
    };
    path();
    state_->fill(fill);
    path();
    state_->stroke(edge);
}

void Canvas::image(glm::ivec2 pixels, std::span<const std::uint8_t> rgb, const Box& box) {
    if (pixels.x < 1 || pixels.y < 1 || rgb.size() != std::size_t(pixels.x) * std::size_t(pixels.y) * 3)
        throw Error(Errc::bad_usage, "The bytes are no RGB picture of the size given.");
    cairo_surface_t* picture = cairo_image_surface_create(CAIRO_FORMAT_RGB24, pixels.x, pixels.y);
    check(cairo_surface_status(picture));
    cairo_surface_flush(picture);
    unsigned char* rows = cairo_image_surface_get_data(picture);
    const int stride = cairo_image_surface_get_stride(picture);
    for (int y = 0; y < pixels.y; ++y) {
        auto* row = reinterpret_cast<std::uint32_t*>(rows + std::ptrdiff_t(y) * stride);
        const std::uint8_t* in = rgb.data() + std::size_t(y) * std::size_t(pixels.x) * 3;
        for (int x = 0; x < pixels.x; ++x, in += 3)
            row[x] = std::uint32_t(in[0]) << 16 | std::uint32_t(in[1]) << 8 | in[2];
    }
    cairo_surface_mark_dirty(picture);
    cairo_save(state_->cairo);
    cairo_translate(state_->cairo, box.x, box.y);
    cairo_scale(state_->cairo, box.width / pixels.x, box.height / pixels.y);
    cairo_set_source_surface(state_->cairo, picture, 0, 0);
    double pixel_x = 1, pixel_y = 0;
    cairo_user_to_device_distance(state_->cairo, &pixel_x, &pixel_y);
    cairo_pattern_t* source = cairo_get_source(state_->cairo);
    cairo_pattern_set_filter(source, pixel_x >= 1 ? CAIRO_FILTER_NEAREST : CAIRO_FILTER_GOOD);
    cairo_pattern_set_extend(source, CAIRO_EXTEND_PAD);
    cairo_rectangle(state_->cairo, 0, 0, pixels.x, pixels.y);
    cairo_fill(state_->cairo);
    cairo_restore(state_->cairo);
    cairo_surface_destroy(picture);
}

void Canvas::text(std::string_view text, const glm::dvec2& at, const TextStyle& style, Align across, Align down,
                  bool turned) {
    PangoLayout* layout = state_->layout(text, style, 0);
    const glm::dvec2 size = State::size_of(layout);
    const auto offset = [](Align align, double length) {
        return align == Align::start ? 0 : align == Align::middle ? -0.5 * length : -length;
    };
    cairo_save(state_->cairo);
    cairo_translate(state_->cairo, at.x, at.y);
    if (turned) cairo_rotate(state_->cairo, -0.5 * M_PI);
    cairo_move_to(state_->cairo, offset(across, size.x), offset(down, size.y));
    state_->set(style.color, 1);
    pango_cairo_show_layout(state_->cairo, layout);
    cairo_restore(state_->cairo);
    g_object_unref(layout);
}

double Canvas::paragraph(std::string_view text, const glm::dvec2& top_left, double width, const TextStyle& style) {
    PangoLayout* layout = state_->layout(text, style, width);
    cairo_move_to(state_->cairo, top_left.x, top_left.y);
    state_->set(style.color, 1);
    pango_cairo_show_layout(state_->cairo, layout);
    const double height = State::size_of(layout).y;
    g_object_unref(layout);
    return height;
}

glm::dvec2 Canvas::measure(std::string_view text, const TextStyle& style, double width) const {
    PangoLayout* layout = state_->layout(text, style, width);
    const glm::dvec2 size = State::size_of(layout);
    g_object_unref(layout);
    return size;
}

void Canvas::clip(const Box& box) {
    cairo_save(state_->cairo);
    cairo_new_path(state_->cairo);
    cairo_rectangle(state_->cairo, box.x, box.y, box.width, box.height);
    cairo_clip(state_->cairo);
}

void Canvas::unclip() { cairo_restore(state_->cairo); }

std::string Canvas::finish() {
    if (state_->finished) throw Error(Errc::bad_usage, "The drawing was finished before.");
    state_->finished = true;
    check(cairo_status(state_->cairo));
    if (state_->kind == State::Kind::png) {
        cairo_surface_flush(state_->surface);
        check(cairo_surface_write_to_png_stream(state_->surface, append, &state_->bytes));
        return std::move(state_->bytes);
    }
    if (state_->kind == State::Kind::pdf) cairo_show_page(state_->cairo);
    cairo_destroy(state_->cairo);
    state_->cairo = nullptr;
    cairo_surface_finish(state_->surface);
    check(cairo_surface_status(state_->surface));
    if (state_->kind == State::Kind::svg) return inline_svg(state_->bytes, state_->title);
    return std::move(state_->bytes);
}

}  // namespace lacuna
