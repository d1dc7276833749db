#include <fmt/format.h>

#include <cmath>

#include "core/chart/svg_text.h"
#include "core/inspect/report_document.h"
#include "core/inspect/report_text.h"
#include "core/io/image_writer.h"

namespace lacuna {

namespace {

constexpr const char* k_style = R"(
:root{color-scheme:light}
body{font:15px/1.45 Inter,"DejaVu Sans",system-ui,sans-serif;color:#1c2126;background:#fff;margin:0 auto;max-width:1180px;padding:24px}
h1{font-size:24px;margin:0 0 12px}h2{font-size:17px;margin:28px 0 8px;border-bottom:1px solid #d4d9de;padding-bottom:4px}
.banner{color:#fff;border-radius:6px;padding:14px 18px;margin:0 0 8px}.banner b{font-size:26px;letter-spacing:.04em}
.banner ul{margin:6px 0 0;padding-left:20px}
.wide{overflow-x:auto}table{border-collapse:collapse;font-size:13px}
th,td{border-bottom:1px solid #e3e7ea;padding:4px 9px;text-align:left;vertical-align:top}
th{background:#f3f5f7;font-weight:600}table.sort th{cursor:pointer}
th[aria-sort=ascending]::after{content:" \25B2"}th[aria-sort=descending]::after{content:" \25BC"}
td.n,th.n{text-align:right;font-variant-numeric:tabular-nums;white-space:nowrap}
table.sort td{white-space:nowrap}table.sort td.w{white-space:normal;min-width:260px}
.row{display:flex;flex-wrap:wrap;gap:16px;align-items:flex-start;margin:8px 0}
figure{margin:0}figure img{display:block;max-width:100%;border:1px solid #d4d9de;border-radius:4px}
figcaption{font-size:12px;color:#56606a;margin-top:4px}
pre{background:#f3f5f7;border-radius:4px;padding:10px 12px;overflow-x:auto;font-size:13px;white-space:pre-wrap}
footer{margin-top:32px;color:#56606a;font-size:12px}
@media print{body{max-width:none;padding:0}tr{break-inside:avoid}}
)";

// Sorts a table by the column clicked: by data-v where cells carry it, else by text; again: the other way round.
constexpr const char* k_script = R"(
document.querySelectorAll('table.sort').forEach(function(t){
 var heads=t.tHead.rows[0].cells,body=t.tBodies[0];
 Array.prototype.forEach.call(heads,function(h,i){
  function go(){
   var down=h.getAttribute('aria-sort')==='ascending',rows=Array.from(body.rows);
   function key(r){var c=r.cells[i],v=c.getAttribute('data-v');return v===null?c.textContent:parseFloat(v);}
   rows.sort(function(a,b){var x=key(a),y=key(b);
    var d=(typeof x==='number'&&typeof y==='number')?x-y:String(x).localeCompare(String(y));return down?-d:d;});
   Array.prototype.forEach.call(heads,function(o){o.removeAttribute('aria-sort');});
   h.setAttribute('aria-sort',down?'descending':'ascending');
   rows.forEach(function(r){body.appendChild(r);});
  }
  h.tabIndex=0;h.addEventListener('click',go);
  h.addEventListener('keydown',function(e){if(e.key==='Enter'||e.key===' '){e.preventDefault();go();}});
 });
});
)";

std::string base64(std::string_view bytes) {
    static constexpr char k_digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t word = 0;
        for (std::size_t b = 0; b < 3; ++b)
            word = word << 8 | (i + b < bytes.size() ? static_cast<unsigned char>(bytes[i + b]) : 0u);
        for (std::size_t d = 0; d < 4; ++d) text += i + d > bytes.size() ? '=' : k_digits[word >> (18 - 6 * d) & 63];
    }
    return text;
}

std::string hex(const glm::dvec3& color) {
    return fmt::format("#{:02x}{:02x}{:02x}", int(std::lround(255 * color.x)), int(std::lround(255 * color.y)),
                       int(std::lround(255 * color.z)));
}

std::string escaped(std::string_view text) { return xml_escaped(valid_utf8(text)); }

class HtmlWriter {
public:
    std::string write(const ReportDocument& document) {
        text_ =
            "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
            "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">"
            "<link rel=\"icon\" href=\"data:,\"><title>" +
            escaped(document.title) + "</title><style>" + k_style + "</style></head><body>\n<h1>" +
            escaped(document.title) + "</h1>\n";
        for (const Block& block : document.blocks) std::visit([this](const auto& b) { add(b); }, block);
        text_ +=
            "<footer>" + escaped(document.software) + "</footer>\n<script>" + k_script + "</script>\n</body></html>\n";
        return std::move(text_);
    }

private:
    void add(const Heading& heading) { text_ += "<h2>" + escaped(heading.text) + "</h2>\n"; }

    void add(const Paragraph& paragraph) {
        const char* tag = paragraph.code ? "pre" : "p";
        text_ += fmt::format("<{0}>{1}</{0}>\n", tag, escaped(paragraph.text));
    }

    void add(const Banner& banner) {
        text_ += "<div class=\"banner\" style=\"background:" + hex(verdict_color(banner.verdict)) + "\"><b>" +
                 escaped(banner.text) + "</b><ul>";
        for (const std::string& reason : banner.reasons) text_ += "<li>" + escaped(reason) + "</li>";
        text_ += "</ul></div>\n";
    }

    void add(const Table& table) {
        text_ += table.sortable ? "<div class=\"wide\"><table class=\"sort\">" : "<div class=\"wide\"><table>";
        bool headed = false;
        for (const TableColumn& column : table.columns) headed = headed || !column.title.empty();
        if (headed) {
            text_ += "<thead><tr>";
            for (const TableColumn& column : table.columns)
                text_ += (column.number ? "<th scope=\"col\" class=\"n\">" : "<th scope=\"col\">") +
                         escaped(column.title) + "</th>";
            text_ += "</tr></thead>";
        }
        text_ += "<tbody>\n";
        for (const auto& row : table.rows) {
            text_ += "<tr>";
            for (std::size_t c = 0; c < row.size(); ++c) add_cell(table.columns[c], row[c]);
            text_ += "</tr>\n";
        }
        text_ += "</tbody></table></div>\n";
    }

    void add_cell(const TableColumn& column, const TableCell& cell) {
        constexpr double k_wrapping = 100;  // columns this wide hold sentences
        text_ += column.number ? "<td class=\"n\"" : column.width > k_wrapping ? "<td class=\"w\"" : "<td";
        if (!std::isnan(cell.sort))
            text_ += std::isinf(cell.sort)
                         ? std::string(cell.sort > 0 ? " data-v=\"Infinity\"" : " data-v=\"-Infinity\"")
                         : " data-v=\"" + exact_number(cell.sort) + "\"";
        text_ += ">";
        std::string text = escaped(cell.text);
        if (!cell.link.empty()) text = "<a href=\"" + escaped(cell.link) + "\">" + text + "</a>";
        if (cell.mark) text = "<b style=\"color:" + hex(verdict_color(*cell.mark)) + "\">" + text + "</b>";
        text_ += text + "</td>";
    }

    void add(const PictureRow& row) {
        text_ += "<div class=\"row\">";
        for (const ReportPicture& picture : row.pictures) {
            if (picture.rgb.empty()) continue;
            text_ += fmt::format(
                "<figure style=\"max-width:{}px\"><img width=\"{}\" height=\"{}\" alt=\"{}\" "
                "title=\"{}\" src=\"data:image/png;base64,",
                picture.size.x, picture.size.x, picture.size.y, escaped(picture.caption),
                escaped("Plan: " + picture.plan + ". Error: " + picture.error + "."));
            text_ += base64(encode_png(picture.size, picture.rgb));
            text_ += "\"><figcaption>" + escaped(picture.caption) + "</figcaption></figure>";
        }
        text_ += "</div>\n";
    }

    void add(const ChartRow& row) {
        text_ += "<div class=\"row\">";
        for (const Chart& chart : row.charts) text_ += "<figure>" + to_svg(chart, {340, 240}) + "</figure>";
        text_ += "</div>\n";
    }

    std::string text_;
};

}  // namespace

std::string to_html(const ReportDocument& document) { return HtmlWriter().write(document); }

}  // namespace lacuna
