#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/chart/canvas.h"
#include "core/chart/svg_text.h"
#include "core/inspect/report_document.h"

namespace lacuna {

namespace {

constexpr glm::dvec2 k_a4{595.28, 841.89};
constexpr double k_margin = 40, k_foot = 24, k_padding = 2.5;
constexpr std::size_t k_longest_cell = 1200;  // characters: a row stays shorter than a page
const TextStyle k_text{8.5}, k_cell{6.8}, k_cell_head{6.8, true}, k_heading{11, true}, k_title{16, true}, k_code{7.2},
    k_small{7, false, glm::dvec3(0.38)};

/// Lays blocks on pages, first without drawing to learn how many pages there will be.
class PdfWriter {
public:
    PdfWriter(const ReportDocument& document, const JobContext& job)
        : document_(document), job_(job), canvas_(Canvas::pdf(k_a4, valid_utf8(document.title))) {}

    std::string write() {
        lay_out();
        pages_ = page_;
        drawing_ = true;
        lay_out();
        return canvas_.finish();
    }

private:
    static constexpr double width() { return k_a4.x - 2 * k_margin; }
    static constexpr double bottom() { return k_a4.y - k_margin - k_foot; }

    void lay_out() {
        page_ = 0;
        start_page();
        y_ += paragraph(document_.title, k_title) + 8;
        for (std::size_t i = 0; i < document_.blocks.size(); ++i) {
            if (const double kept = height_to_keep(i); kept > 0) need(kept);
            std::visit([this](const auto& b) { add(b); }, document_.blocks[i]);
        }
    }

    /// Height of the pictures at block i with the paragraph and the heading that lead to them; 0 where there are none.
    double height_to_keep(std::size_t i) const {
        double height = 0;
        for (; i < document_.blocks.size(); ++i) {
            const Block& block = document_.blocks[i];
            if (const auto* row = std::get_if<PictureRow>(&block))
                return row->pictures.empty() ? 0 : height + heights_of(*row).x + heights_of(*row).y + 8;
            if (const auto* text = std::get_if<Paragraph>(&block); text && !text->code)
                height += canvas_.measure(valid_utf8(text->text), k_text, width()).y + 4;
            else if (const auto* heading = std::get_if<Heading>(&block))
                height += canvas_.measure(valid_utf8(heading->text), k_heading, width()).y + 15;
            else
                return 0;
        }
        return 0;
    }

    void start_page() {
        ++page_;
        y_ = k_margin;
        if (!drawing_) return;
        if (page_ > 1) canvas_.next_page();
        const double foot = k_a4.y - k_margin;
        canvas_.line({k_margin, foot - 12}, {k_a4.x - k_margin, foot - 12}, {glm::dvec3(0.8), 0.5});
        canvas_.text(valid_utf8(document_.title + ", " + document_.software), {k_margin, foot}, k_small);
        canvas_.text(fmt::format("page {} of {}", page_, pages_), {k_a4.x - k_margin, foot}, k_small, Align::end);
    }

    /// Starts a page unless `height` more points fit on this one.
    void need(double height) {
        if (y_ + height > bottom() && y_ > k_margin) start_page();
    }

    /// @return its height; y_ is left where it is
    double paragraph(const std::string& text, const TextStyle& style) {
        const std::string clean = valid_utf8(text);
        if (drawing_) return canvas_.paragraph(clean, {k_margin, y_}, width(), style);
        return canvas_.measure(clean, style, width()).y;
    }

    void add(const Heading& heading) {
        constexpr double k_with_what_follows = 90;
        y_ += 10;
        need(k_with_what_follows);
        y_ += paragraph(heading.text, k_heading) + 5;
    }

    void add(const Paragraph& block) {
        // Line by line, so that a long one may run over a page's end.
        const TextStyle& style = block.code ? k_code : k_text;
        std::size_t from = 0;
        while (from <= block.text.size()) {
            const std::size_t end = std::min(block.text.find('\n', from), block.text.size());
            std::string line = block.text.substr(from, end - from);
            if (block.code)
                for (std::size_t i = 0; i < line.size() && line[i] == ' '; i += 3)  // leading blanks keep their width
                    line.replace(i, 1, "\u00a0\u00a0");
            if (line.empty()) line = " ";
            need(canvas_.measure(valid_utf8(line), style, width()).y);
            y_ += paragraph(line, style);
            from = end + 1;
        }
        y_ += 4;
    }

    void add(const Banner& banner) {
        const TextStyle big{20, true, glm::dvec3(1)}, small{8.5, false, glm::dvec3(1)};
        double height = canvas_.measure(banner.text, big).y + 16;
        for (const std::string& reason : banner.reasons)
            height += canvas_.measure(valid_utf8(reason), small, width() - 24).y + 1;
        height = std::min(height, bottom() - k_margin);
        need(height);
        if (drawing_) {
            const Box box{k_margin, y_, width(), height};
            canvas_.rectangle(box, {verdict_color(banner.verdict)});
            canvas_.clip(box);
            double y = y_ + 8;
            y += canvas_.paragraph(banner.text, {k_margin + 12, y}, width() - 24, big);
            for (const std::string& reason : banner.reasons)
                y += canvas_.paragraph(valid_utf8(reason), {k_margin + 12, y}, width() - 24, small) + 1;
            canvas_.unclip();
        }
        y_ += height + 6;
    }

    /// Columns that stand beside each other; of a table too wide for the page every piece starts with the first.
    static std::vector<std::vector<std::size_t>> pieces(const Table& table) {
        std::vector<std::vector<std::size_t>> all{{}};
        double used = 0;
        for (std::size_t c = 0; c < table.columns.size(); ++c) {
            if (!all.back().empty() && used + table.columns[c].width > width()) {
                all.push_back({0});
                used = table.columns[0].width;
            }
            all.back().push_back(c);
            used += table.columns[c].width;
        }
        return all;
    }

    void add(const Table& table) {
        for (const auto& columns : pieces(table)) {
            const double head = head_height(table, columns);
            need(head + 40);
            draw_head(table, columns, head);
            for (const auto& row : table.rows) {
                job_.check();
                const double height = row_height(table, columns, row);
                if (y_ + height > bottom()) {
                    start_page();
                    draw_head(table, columns, head);
                }
                draw_row(table, columns, row, height);
            }
            y_ += 8;
        }
    }

    double head_height(const Table& table, const std::vector<std::size_t>& columns) const {
        double height = 0;
        for (const std::size_t c : columns)
            if (!table.columns[c].title.empty())
                height = std::max(height, text_height(table.columns[c].title, k_cell_head, table.columns[c].width));
        return height > 0 ? height + 2 * k_padding : 0;
    }

    double text_height(const std::string& text, const TextStyle& style, double column) const {
        const double room = column - 2 * k_padding;
        constexpr double k_widest = 0.8;  // of a character, in sizes: what surely fits one line is not measured
        if (double(text.size()) * k_widest * style.size <= room) return line_height(style);
        return canvas_.measure(valid_utf8(text), style, room).y;
    }

    double line_height(const TextStyle& style) const {
        double& height = style.bold ? bold_line_ : plain_line_;
        if (height == 0) height = canvas_.measure("Xg", style).y;
        return height;
    }

    static std::string cut(const std::string& text) {
        return text.size() <= k_longest_cell ? text : text.substr(0, k_longest_cell) + " ...";
    }

    double row_height(const Table& table, const std::vector<std::size_t>& columns,
                      const std::vector<TableCell>& row) const {
        double height = line_height(k_cell);
        for (const std::size_t c : columns)
            height = std::max(height, text_height(cut(row[c].text), cell_style(row[c]), table.columns[c].width));
        return height + 2 * k_padding;
    }

    static TextStyle cell_style(const TableCell& cell) {
        TextStyle style = k_cell;
        style.tabular = true;
        if (cell.mark) {
            style.bold = true;
            style.color = verdict_color(*cell.mark);
        }
        return style;
    }

    void draw_head(const Table& table, const std::vector<std::size_t>& columns, double height) {
        if (height == 0) return;
        if (drawing_) {
            double total = 0;
            for (const std::size_t c : columns) total += table.columns[c].width;
            canvas_.rectangle({k_margin, y_, total, height}, {glm::dvec3(0.94, 0.95, 0.96)});
            double x = k_margin;
            for (const std::size_t c : columns) {
                canvas_.paragraph(valid_utf8(table.columns[c].title), {x + k_padding, y_ + k_padding},
                                  table.columns[c].width - 2 * k_padding, k_cell_head);
                x += table.columns[c].width;
            }
        }
        y_ += height;
    }

    void draw_row(const Table& table, const std::vector<std::size_t>& columns, const std::vector<TableCell>& row,
                  double height) {
        if (drawing_) {
            double x = k_margin;
            for (const std::size_t c : columns) {
                if (!row[c].text.empty())
                    canvas_.paragraph(valid_utf8(cut(row[c].text)), {x + k_padding, y_ + k_padding},
                                      table.columns[c].width - 2 * k_padding, cell_style(row[c]));
                x += table.columns[c].width;
            }
            canvas_.line({k_margin, y_ + height}, {x, y_ + height}, {glm::dvec3(0.86), 0.4});
        }
        y_ += height;
    }

    static constexpr double k_picture_gap = 14;

    static double picture_share(const PictureRow& row) {
        return (width() - k_picture_gap * double(row.pictures.size() - 1)) / double(row.pictures.size());
    }

    static double picture_width(const ReportPicture& p, double share) {
        constexpr double k_most = 250;
        return std::min(share, k_most * p.size.x / p.size.y);
    }

    /// Of the tallest picture, and of the longest caption.
    glm::dvec2 heights_of(const PictureRow& row) const {
        const double share = picture_share(row);
        glm::dvec2 heights(0);
        for (const ReportPicture& p : row.pictures) {
            if (p.rgb.empty()) continue;
            heights.x = std::max(heights.x, picture_width(p, share) * p.size.y / p.size.x);
            heights.y = std::max(heights.y, canvas_.measure(valid_utf8(p.caption), k_small, share).y);
        }
        return heights;
    }

    void add(const PictureRow& row) {
        if (row.pictures.empty()) return;
        const double share = picture_share(row);
        const glm::dvec2 heights = heights_of(row);
        const double height = heights.x, caption = heights.y;
        need(height + caption + 8);
        double x = k_margin;
        for (const ReportPicture& p : row.pictures) {
            if (drawing_ && !p.rgb.empty()) {
                const double w = picture_width(p, share), h = w * p.size.y / p.size.x;
                canvas_.image(p.size, p.rgb, {x, y_, w, h});
                canvas_.frame({x, y_, w, h}, {glm::dvec3(0.8), 0.5});
                canvas_.paragraph(valid_utf8(p.caption), {x, y_ + height + 3}, share, k_small);
            }
            x += share + k_picture_gap;
        }
        y_ += height + caption + 10;
    }

    void add(const ChartRow& row) {
        constexpr double k_height = 170;
        constexpr std::size_t k_beside = 2;
        for (std::size_t first = 0; first < row.charts.size(); first += k_beside) {
            need(k_height);
            for (std::size_t i = first; i < std::min(row.charts.size(), first + k_beside) && drawing_; ++i)
                draw(row.charts[i], canvas_,
                     {k_margin + double(i - first) * width() / k_beside, y_, width() / k_beside - 8, k_height - 8});
            y_ += k_height;
        }
    }

    const ReportDocument& document_;
    const JobContext& job_;
    Canvas canvas_;
    double y_ = 0;
    int page_ = 0, pages_ = 0;
    bool drawing_ = false;
    mutable double plain_line_ = 0, bold_line_ = 0;
};

}  // namespace

std::string to_pdf(const ReportDocument& document, const JobContext& job) { return PdfWriter(document, job).write(); }

}  // namespace lacuna
