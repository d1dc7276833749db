#include "core/chart/chart.h"

#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <filesystem>
#include <set>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/chart/svg_text.h"

namespace lacuna {
namespace {

constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();

struct Picture {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;

    /// Mean position and number of the pixels of a colour, give or take rounding.
    std::pair<glm::dvec2, int> find(const glm::dvec3& color) const {
        glm::dvec2 sum(0);
        int count = 0;
        for (int i = 0; i < width * height; ++i) {
            bool same = true;
            for (int c = 0; c < 3; ++c) same = same && std::fabs(rgb[std::size_t(3 * i + c)] - 255 * color[c]) < 2;
            if (!same) continue;
            sum += glm::dvec2(i % width, i / width);
            ++count;
        }
        return {sum / double(std::max(1, count)), count};
    }
};

Picture decode(const std::string& png) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    Picture picture;
    if (!png_image_begin_read_from_memory(&image, png.data(), png.size())) return picture;
    image.format = PNG_FORMAT_RGB;
    picture.width = int(image.width);
    picture.height = int(image.height);
    picture.rgb.resize(PNG_IMAGE_SIZE(image));
    png_image_finish_read(&image, nullptr, picture.rgb.data(), 0, nullptr);
    return picture;
}

Chart times() {
    Chart chart;
    chart.title = "Time against error";
    chart.subtitle = "casting, 256³";
    chart.x = {.title = "error", .unit = "1/255", .scale = Scale::log, .zero_lane = true};
    chart.y = {.title = "time", .unit = "ms", .scale = Scale::log};
    chart.series.push_back({.name = "none", .points = {{0, 80}, {0.5, 40}, {3, 20}}});
    chart.series.push_back({.name = "acd", .points = {{0, 20, "step 0.5", 18, 23}, {0.7, 9}, {k_nan, 4}, {4, -1}}});
    chart.series.push_back({.name = "front", .points = {{0, 20}, {0.7, 9}}, .steps = true, .dashes = {4, 2}});
    return chart;
}

Chart histogram() {
    Chart chart;
    chart.x = {.title = "diameter", .unit = "mm"};
    chart.y = {.title = "defects"};
    chart.bars.push_back({.name = "voids", .edges = {0, 1, 2, 3}, .heights = {4, 0, 2}});
    chart.bands.push_back({.lo = 1.5, .hi = 3, .label = "over the limit"});
    chart.marks.push_back({.at = 1.5, .label = "limit"});
    return chart;
}

TEST(Chart, EqualChartsAreEqualBytes) {
    EXPECT_EQ(to_svg(times()), to_svg(times()));
    EXPECT_EQ(to_png(times()), to_png(times()));
}

TEST(Chart, SvgsShareNoIdAndNameThemselves) {
    const std::string a = to_svg(times()), b = to_svg(histogram());
    EXPECT_TRUE(a.starts_with("<svg")) << a.substr(0, 60);
    EXPECT_NE(a.find("<title>Time against error</title>"), std::string::npos);
    const auto ids = [](const std::string& svg) {
        std::set<std::string> found;
        for (std::size_t at = 0; (at = svg.find(" id=\"", at)) != std::string::npos; at += 5)
            found.insert(svg.substr(at + 5, svg.find('"', at + 5) - at - 5));
        return found;
    };
    const std::set<std::string> of_a = ids(a), of_b = ids(b);
    EXPECT_GT(of_a.size(), 5u);
    for (const std::string& id : of_a) EXPECT_FALSE(of_b.contains(id)) << id;
    // What is meant by a reference is there.
    for (std::size_t at = 0; (at = a.find("href=\"#", at)) != std::string::npos; at += 7)
        EXPECT_TRUE(of_a.contains(a.substr(at + 7, a.find('"', at + 7) - at - 7)));
}

TEST(Chart, PointsStandWhereTheirValuesAre) {
    const auto middle = [](double x, double y, Scale scale) {
        Chart chart;
        chart.x = {.title = "x", .scale = scale, .lo = 1, .hi = 100};
        chart.y = {.title = "y", .scale = scale, .lo = 1, .hi = 100};
        chart.series.push_back(
            {.name = "", .points = {{x, y}}, .marker = Marker::circle, .color = glm::dvec3(1, 0, 1)});
        return decode(to_png(chart, {300, 300}, 1)).find({1, 0, 1});
    };
    for (const Scale scale : {Scale::linear, Scale::log}) {
        const auto low = middle(2, 3, scale), right = middle(60, 3, scale), up = middle(2, 60, scale);
        ASSERT_GT(low.second, 5);
        EXPECT_GT(right.first.x, low.first.x + 50);
        EXPECT_NEAR(right.first.y, low.first.y, 0.7);
        EXPECT_LT(up.first.y, low.first.y - 50);
        EXPECT_NEAR(up.first.x, low.first.x, 0.7);
        EXPECT_EQ(middle(200, 3, scale).second, 0) << "outside the axis";
    }
    EXPECT_GT(middle(10, 10, Scale::log).first.x, middle(10, 10, Scale::linear).first.x + 50);
}

TEST(Chart, BarsAreAsHighAsTheirHeights) {
    Chart chart = histogram();
    chart.bands.clear();
    chart.marks.clear();
    chart.bars[0].color = glm::dvec3(1, 0, 1);
    chart.bars[0].opacity = 1;
    chart.bars[0].name.clear();
    const int both = decode(to_png(chart, {300, 300}, 2)).find({1, 0, 1}).second;
    chart.y.hi = 4.16, chart.y.lo = 0;
    chart.bars[0].heights = {4, 0, 0};
    const int first = decode(to_png(chart, {300, 300}, 2)).find({1, 0, 1}).second;
    EXPECT_NEAR(double(both) / first, 1.5, 0.03);
}

TEST(Chart, EverythingAtOnceInEveryShape) {
    Chart chart = histogram();
    for (const Legend legend : {Legend::right, Legend::top, Legend::none}) {
        chart.legend = legend;
        chart.note = "Bars: counts of one part.";
        EXPECT_GT(to_svg(chart).size(), 1000u);
    }
    chart.x = {.title = "structure", .categories = {"none", "octree", "eacd"}};
    chart.bars = {{.name = "", .edges = {-0.4, 0.4}, .heights = {3}}};
    EXPECT_GT(to_svg(chart).size(), 1000u);
    EXPECT_GT(to_svg(Chart{}).size(), 500u) << "an empty chart is a pair of axes";
}

TEST(Chart, RefusesWhatCannotBeDrawn) {
    Chart chart = histogram();
    chart.bars[0].heights.pop_back();
    EXPECT_THROW(to_svg(chart), Error);
    chart = histogram();
    chart.bars[0].edges[1] = k_nan;
    EXPECT_THROW(to_svg(chart), Error);
    EXPECT_THROW(to_svg(times(), {30, 20}), Error);
    EXPECT_THROW(to_svg(times(), {0, 20}), Error);
    EXPECT_THROW(to_png(times(), {300, 200}, k_nan), Error);
    ChartSheet sheet;
    Canvas canvas = Canvas::svg({300, 200});
    EXPECT_THROW(draw(sheet, canvas), Error);
}

TEST(Chart, SheetsAreWrittenInThreeFormats) {
    const auto folder = std::filesystem::temp_directory_path() / ("chart_test_" + std::to_string(::getpid()));
    std::filesystem::create_directory(folder);
    ChartSheet sheet{.title = "Two & more", .charts = {times(), histogram(), times()}};
    for (const auto& [name, magic] :
         {std::pair("a.svg", "<svg"), std::pair("b.PNG", "\x89PNG"), std::pair("c.pdf", "%PDF")}) {
        save(sheet, folder / name);
        EXPECT_TRUE(read_file(folder / name).starts_with(magic)) << name;
    }
    EXPECT_NE(read_file(folder / "a.svg").find("<title>Two &amp; more</title>"), std::string::npos);
    const std::string pdf = read_file(folder / "c.pdf");
    save(sheet, folder / "c.pdf");
    EXPECT_EQ(read_file(folder / "c.pdf"), pdf);
    EXPECT_THROW(save(sheet, folder / "d.gif"), Error);
    EXPECT_THROW(save(sheet, folder / "none" / "d.svg"), Error);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 3);
    std::filesystem::remove_all(folder);
}

TEST(Canvas, PagesOfAPdf) {
    const auto pages = [](int count) {
        Canvas canvas = Canvas::pdf({595, 842}, "Report", "2026-01-02T03:04:05Z");
        for (int i = 0; i < count; ++i) {
            if (i) canvas.next_page();
            canvas.text("page", {50, 50}, {});
            draw(histogram(), canvas, {50, 100, 400, 250});
        }
        return canvas.finish();
    };
    const std::string three = pages(3);
    EXPECT_NE(three.find("/Count 3"), std::string::npos);
    EXPECT_EQ(pages(1).find("/Count 3"), std::string::npos);
    Canvas svg = Canvas::svg({100, 100});
    EXPECT_THROW(svg.next_page(), Error);
    svg.finish();
    EXPECT_THROW(svg.finish(), Error);
}

TEST(Canvas, TextIsMeasuredWrappedAndRepaired) {
    Canvas canvas = Canvas::svg({300, 300});
    const glm::dvec2 one = canvas.measure("void void void", {});
    const glm::dvec2 wrapped = canvas.measure("void void void", {}, 0.75 * one.x);
    EXPECT_NEAR(wrapped.y, 2 * one.y, 0.5);
    EXPECT_LE(wrapped.x, 0.75 * one.x + 0.01);
    EXPECT_DOUBLE_EQ(canvas.paragraph("void void void", {0, 0}, 0.75 * one.x, {}), wrapped.y);
    EXPECT_GT(canvas.measure("void", {.size = 17}).x, 1.9 * canvas.measure("void", {.size = 8.5}).x);
    canvas.text(std::string("broken \xff\xc3 text \x01", 16), {10, 10}, {});
    canvas.text("", {10, 10}, {});
    EXPECT_GT(canvas.finish().size(), 100u);
    EXPECT_EQ(valid_utf8("a\xff"
                         "b\xe2\x82\xac\xed\xa0\x80"),
              "a?b€???");
}

TEST(Canvas, ImagesKeepTheirOrientation) {
    Canvas canvas = Canvas::png({40, 40}, 1);
    const std::vector<std::uint8_t> rgb{255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 0};  // red green / blue yellow
    canvas.image({2, 2}, rgb, {0, 0, 40, 40});
    EXPECT_THROW(canvas.image({2, 3}, rgb, {0, 0, 40, 40}), Error);
    const Picture picture = decode(canvas.finish());
    const auto at = [&](int x, int y) {
        const std::uint8_t* p = &picture.rgb[std::size_t(3 * (y * 40 + x))];
        return glm::ivec3(p[0], p[1], p[2]);
    };
    EXPECT_EQ(at(3, 3), glm::ivec3(255, 0, 0));
    EXPECT_EQ(at(36, 3), glm::ivec3(0, 255, 0));
    EXPECT_EQ(at(3, 36), glm::ivec3(0, 0, 255));
    EXPECT_EQ(at(36, 36), glm::ivec3(255, 255, 0));
}

TEST(Chart, TellsWhereItDrewItsPoints) {
    Chart chart = times();
    chart.series[1].color = glm::dvec3(1, 0, 0);
    chart.series[1].points = {{0.7, 9}, {k_nan, 4}};
    Canvas canvas = Canvas::png({400, 300}, 1);
    const PointPlaces places = draw(chart, canvas);
    ASSERT_EQ(places.size(), chart.series.size());
    ASSERT_EQ(places[1].size(), 2u);
    EXPECT_TRUE(std::isnan(places[1][1].x));
    // The legend shows the marker, too, to the right of the plot.
    Picture picture = decode(canvas.finish());
    for (int y = 0; y < picture.height; ++y)
        for (int x = int(places[1][0].x) + 12; x < picture.width; ++x)
            picture.rgb[3 * (std::size_t(y) * std::size_t(picture.width) + std::size_t(x))] = 1;
    const auto [middle, count] = picture.find({1, 0, 0});
    ASSERT_GT(count, 4);
    EXPECT_NEAR(middle.x + 0.5, places[1][0].x, 1);
    EXPECT_NEAR(middle.y + 0.5, places[1][0].y, 1);
}

}  // namespace
}  // namespace lacuna
