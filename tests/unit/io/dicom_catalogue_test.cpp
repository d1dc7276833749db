#include "core/io/dicom_catalogue.h"

#include <gtest/gtest.h>

#include <mutex>

#include "../../support/dicom_zoo.h"
#include "../../support/test_data.h"
#include "volume_fixture.h"

using namespace lacuna;
using namespace lacuna::test;

namespace {

void write_named(const std::filesystem::path& file, const std::string& patient, const std::string& id,
                 const std::string& study, const std::string& date, const std::string& series, int number,
                 int instance) {
    ZooSlice slice;
    slice.series_uid = series;
    slice.series_number = number;
    slice.instance = instance;
    slice.position = {0, 0, double(instance)};
    slice.stored = [instance](int x, int y) { return 100 * instance + 10 * y + x; };
    slice.extra = {
        {{0x0008, 0x0020}, date}, {{0x0010, 0x0010}, patient}, {{0x0010, 0x0020}, id}, {{0x0020, 0x000D}, study}};
    write_zoo_slice(file, slice);
}

class CatalogueTest : public testing::Test {
protected:
    void SetUp() override {
        for (const char* name : {"a", "a/deep", "b"}) std::filesystem::create_directories(folder / name);
        write_named(folder / "a/2", "Adams^Eve", "1", "1.1", "20200101", "1.1.1", 1, 2);
        write_named(folder / "a/1", "Adams^Eve", "1", "1.1", "20200101", "1.1.1", 1, 3);
        write_named(folder / "a/deep/3", "Adams^Eve", "1", "1.1", "20200101", "1.1.1", 1, 1);
        write_named(folder / "a/4", "Adams^Eve", "1", "1.1", "20200101", "1.1.2", 2, 1);
        write_named(folder / "b/5", "Adams^Eve", "1", "1.2", "20240101", "1.2.1", 1, 1);
        write_named(folder / "b/6", "Zed", "2", "1.3", "20190101", "1.3.1", 1, 1);
        put_file(folder / "notes.txt", "no DICOM");
        put_file(folder / "empty", "");
    }
    TemporaryFolder folder;
};

}  // namespace

TEST_F(CatalogueTest, PutsImagesIntoPatientsStudiesAndSeries) {
    const Catalogue found = scan_catalogue(folder.path());
    ASSERT_EQ(found.patients.size(), 2u);
    EXPECT_EQ(found.files, 8);
    EXPECT_EQ(found.unreadable, 0);
    EXPECT_EQ(found.series_count(), 4);
    const CataloguePatient& adams = found.patients[0];
    EXPECT_EQ(person_name(adams.name), "Adams, Eve");
    ASSERT_EQ(adams.studies.size(), 2u);
    EXPECT_EQ(adams.studies[0].date, "20240101");  // the newest first
    const CatalogueStudy& study = adams.studies[1];
    ASSERT_EQ(study.series.size(), 2u);
    EXPECT_EQ(study.series[0].images, 3);
    EXPECT_EQ(study.series[0].columns, 6);
    ASSERT_EQ(study.series[0].files.size(), 3u);
    EXPECT_EQ(study.series[0].files[0].filename(), "3");  // by instance number, not by name
    EXPECT_EQ(study.series[0].files[2].filename(), "1");
    EXPECT_EQ(folder_of(study.series[0]), folder.path() / "a");
    EXPECT_EQ(folder_of(study.series[1]), folder.path() / "a");
    EXPECT_EQ(folder_of({}), std::filesystem::path());
}

TEST_F(CatalogueTest, TheFolderAndUidOfASeriesOpenIt) {
    const Catalogue found = scan_catalogue(folder.path());
    const CatalogueSeries& series = found.patients[0].studies[1].series[0];
    OpenOptions options;
    options.series = series.uid;
    EXPECT_EQ(open_volume(folder_of(series).string(), options).geometry().size.z, 3);
}

TEST_F(CatalogueTest, BrokenFilesAreCountedAndStopNobody) {
    const std::string whole = get_file(folder / "b/6");
    for (const std::size_t bytes : {140u, 200u, 300u, 500u})
        put_file(folder / ("cut" + std::to_string(bytes)), whole.substr(0, bytes));
    const Catalogue found = scan_catalogue(folder.path());
    EXPECT_EQ(found.series_count(), 4);
    EXPECT_EQ(found.files, 12);
}

TEST_F(CatalogueTest, StopsWhenAskedAndKeepsProgressInOrder) {
    std::stop_source stop;
    stop.request_stop();
    expect_error(Errc::cancelled, {}, [&] { scan_catalogue(folder.path(), {stop.get_token(), nullptr}); });
    std::mutex mutex;
    double last = 0;
    bool ordered = true;
    scan_catalogue(folder.path(), {{}, [&](double share) {
                                       const std::lock_guard lock(mutex);
                                       ordered = ordered && share >= last && share <= 1;
                                       last = share;
                                   }});
    EXPECT_TRUE(ordered);
    EXPECT_EQ(last, 1);
    expect_error(Errc::io, {"no such file"}, [&] { scan_catalogue(folder / "missing"); });
    put_file(folder / "DICOMDIR", "no directory");
    expect_error(Errc::bad_input, {"DICOMDIR"}, [&] { scan_catalogue(folder / "DICOMDIR"); });
}

TEST_F(CatalogueTest, ThumbnailsShowTheMiddleImage) {
    const Catalogue found = scan_catalogue(folder.path());
    const CatalogueThumbnail picture = catalogue_thumbnail(found.patients[0].studies[1].series[0], 4);
    EXPECT_EQ(picture.width, 4);
    EXPECT_EQ(picture.height, 3);
    ASSERT_EQ(picture.grey.size(), 12u);
    EXPECT_LT(picture.grey.front(), picture.grey.back());
    CatalogueSeries broken;
    broken.files = {folder / "notes.txt"};
    EXPECT_EQ(catalogue_thumbnail(broken, 64).width, 0);
}

TEST(CatalogueNames, AreWrittenAsPeopleDo) {
    EXPECT_EQ(person_name("Adams^John Robert^Quincy"), "Adams, John Robert Quincy");
    EXPECT_EQ(person_name("Adams"), "Adams");
    EXPECT_EQ(person_name("Yamada^Tarou=\xE5\xB1\xB1\xE7\x94\xB0=x"), "Yamada, Tarou");
    EXPECT_EQ(person_name(""), "");
    EXPECT_EQ(person_name("^^^"), "");
}

TEST(CatalogueReal, ReadsADicomdirAndItsFolderAlike) {
    LACUNA_NEEDS_DATA(root, "dicom_zoo/dicomdir");
    const Catalogue listed = scan_catalogue(root / "DICOMDIR"), looked = scan_catalogue(root);
    EXPECT_EQ(listed.patients.size(), 2u);
    EXPECT_EQ(looked.patients.size(), 2u);
    EXPECT_GT(listed.series_count(), 3);
    EXPECT_EQ(listed.missing, 0);
    ASSERT_EQ(listed.series_count(), looked.series_count());
    for (std::size_t p = 0; p < 2; ++p)
        for (std::size_t s = 0; s < listed.patients[p].studies.size(); ++s)
            for (std::size_t k = 0; k < listed.patients[p].studies[s].series.size(); ++k) {
                const CatalogueSeries &a = listed.patients[p].studies[s].series[k],
                                      &b = looked.patients[p].studies[s].series[k];
                EXPECT_EQ(a.uid, b.uid);
                EXPECT_EQ(a.files, b.files);
                EXPECT_GT(catalogue_thumbnail(b, 64).width, 0);
            }
}
