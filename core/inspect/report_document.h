#pragma once

#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/chart/chart.h"
#include "core/inspect/report.h"

// A report as a list of blocks: what report.html, report.pdf and a series' summary.html have in common. The writers
// know paper and screen, this knows what is said.
namespace lacuna {

struct Heading {
    std::string text;
};
struct Paragraph {
    std::string text;
    bool code = false;  ///< set in a fixed width, as typed
};
/// The verdict, in its colour, with its reasons.
struct Banner {
    Verdict verdict = Verdict::cannot_tell;
    std::string text;
    std::vector<std::string> reasons;
};
struct TableColumn {
    std::string title;
    double width = 60;  ///< points on paper; what does not fit beside the others moves to a table of its own
    bool number = false;
};
struct TableCell {
    std::string text;
    double sort = std::numeric_limits<double>::quiet_NaN();  ///< what the column sorts by; NaN: the text
    std::optional<Verdict> mark{};                           ///< shown in the verdict's colour
    std::string link{};                                      ///< address the text leads to; on screen only
};
struct Table {
    std::vector<TableColumn> columns;
    std::vector<std::vector<TableCell>> rows;
    bool sortable = false;
};
struct PictureRow {
    std::vector<ReportPicture> pictures;
};
struct ChartRow {
    std::vector<Chart> charts;  ///< side by side
};
using Block = std::variant<Heading, Paragraph, Banner, Table, PictureRow, ChartRow>;

struct ReportDocument {
    std::string title, software;
    std::vector<Block> blocks;
};

/// What the report of one part says, verdict first.
ReportDocument document_of(const InspectionReport& report);

/// One HTML page, everything inside.
std::string to_html(const ReportDocument& document);
/// A4 pages with page numbers. Cost: about a millisecond a row of a wide table. @throws Error(cancelled)
std::string to_pdf(const ReportDocument& document, const JobContext& job = {});

/// The colour a verdict is shown in, sRGB 0..1.
glm::dvec3 verdict_color(Verdict verdict);

}  // namespace lacuna
