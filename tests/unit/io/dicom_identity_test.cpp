#include "core/io/dicom_identity.h"

#include <gtest/gtest.h>

#include <fstream>

#include "core/io/dicom_reader.h"
#include "tests/support/dicom_zoo.h"

namespace lacuna {
namespace {

using test::TemporaryFolder;
using test::write_zoo_slice;
using test::ZooSlice;

TEST(ScreenFacts, TheWindowsFunctionIsTheFilesOwn) {
    for (const auto& [word, function] : {std::pair<const char*, std::optional<VoiFunction>>{"", std::nullopt},
                                         {"LINEAR", VoiFunction::linear},
                                         {"LINEAR_EXACT", VoiFunction::linear_exact},
                                         {"SIGMOID", VoiFunction::sigmoid},
                                         {"NONESUCH", std::nullopt}}) {
        const TemporaryFolder folder;
        ZooSlice slice;
        slice.extra = {{{0x0028, 0x1050}, "40"}, {{0x0028, 0x1051}, "400"}};
        if (*word) slice.extra.push_back({{0x0028, 0x1056}, word});
        write_zoo_slice(folder / "a", slice);
        EXPECT_EQ(read_screen_facts(folder / "a").voi_function, function) << word;
    }
}

TEST(ScreenFacts, TablesOfGreyLevelsAreReadWithTheSignTheirValuesHave) {
    const TemporaryFolder folder;
    ZooSlice slice;  // 12 stored bits, rescaled by -1024: values may be negative
    slice.voi_tables = {{"BONE\x01", {0, 1000, 65535}, -1000, 16, false, false},
                        {"", {0, 100, 255, 7}, -3, 8, true, true},
                        {"too few bits", {0, 1}, 0, 7, false, false}};
    write_zoo_slice(folder / "a", slice);
    auto tables = read_screen_facts(folder / "a").voi_tables;
    ASSERT_EQ(tables.size(), 2u);
    EXPECT_EQ(tables[0]->name, "BONE");
    EXPECT_EQ(tables[0]->first, -1000);
    EXPECT_EQ(tables[0]->last(), -998);
    EXPECT_EQ(tables[0]->bits, 16);
    EXPECT_EQ(tables[0]->share, (std::vector<std::uint16_t>{0, 1000, 65535}));
    EXPECT_EQ(tables[1]->first, -3);
    EXPECT_EQ(tables[1]->bits, 8);
    EXPECT_EQ(tables[1]->share, (std::vector<std::uint16_t>{0, 100, 255, 7}));

    const auto first_of = [&](const ZooSlice& like) {
        write_zoo_slice(folder / "b", like);
        return read_screen_facts(folder / "b").voi_tables.at(0)->first;
    };
    slice.voi_tables = {{"", {0, 1}, 0xFC00, 16, false, false}};
    EXPECT_EQ(first_of(slice), -1024);
    slice.intercept = "0";  // 0 to 4095
    EXPECT_EQ(first_of(slice), 64512);
    slice.slope = "-1";
    EXPECT_EQ(first_of(slice), -1024);
    slice.slope = "";  // no rescale at all: as the pixels are
    EXPECT_EQ(first_of(slice), 64512);
    slice.is_signed = true;
    EXPECT_EQ(first_of(slice), -1024);
    slice.modality_lut = {1, 2, 3};  // whose values are unsigned
    EXPECT_EQ(first_of(slice), 64512);
    slice = {};
    slice.voi_tables = {{"", std::vector<int>(65536, 5), -32768, 16, false, false}};  // written as 0 entries
    write_zoo_slice(folder / "b", slice);
    EXPECT_EQ(read_screen_facts(folder / "b").voi_tables.at(0)->share.size(), 65536u);
    // In functional groups the rescale stands elsewhere.
    slice.voi_tables = {{"", {0, 1}, 0xFC00, 16, false, false}};
    test::write_zoo_enhanced(folder / "c", slice, {{0, 0, 0}, {0, 0, 1}}, [](int, int, int) { return 7; });
    EXPECT_EQ(read_screen_facts(folder / "c", 2).voi_tables.at(0)->first, -1024);
}

TEST(ScreenFacts, ATableThatCannotBeIsLeftOut) {
    const TemporaryFolder folder;
    ZooSlice slice;
    slice.voi_tables = {{"", {}, 0, 16, false, false}, {"good", {0, 9}, 0, 16, false, false}};  // 0 means 65536
    write_zoo_slice(folder / "a", slice);
    const auto tables = read_screen_facts(folder / "a").voi_tables;
    ASSERT_EQ(tables.size(), 1u);
    EXPECT_EQ(tables[0]->name, "good");
}

TEST(ScreenFacts, ThePatientIsReadForTheScreenAndKeptOutOfTheFacts) {
    const TemporaryFolder folder;
    ZooSlice slice;
    slice.extra = {{{0x0008, 0x0005}, "ISO_IR 100"},
                   {{0x0010, 0x0010}, "M\xFCller^Jane^M.^Dr."},
                   {{0x0010, 0x0020}, "ID 7\x01"},
                   {{0x0010, 0x0030}, "19700131"},
                   {{0x0010, 0x0040}, "F"},
                   {{0x0008, 0x0020}, "2024.1"},
                   {{0x0008, 0x1030}, "Head with contrast"}};
    write_zoo_slice(folder / "a", slice);
    slice.position.z = 1;
    slice.instance = 2;
    write_zoo_slice(folder / "b", slice);
    const auto patient = read_screen_facts(folder / "a").patient;
    ASSERT_TRUE(patient != nullptr);
    EXPECT_EQ(patient->name, "M\xC3\xBCller, Dr. Jane M.");
    EXPECT_EQ(patient->id, "ID 7");
    EXPECT_EQ(patient->birth_date, "1970-01-31");
    EXPECT_EQ(patient->sex, "F");
    EXPECT_EQ(patient->study_date, "2024.1");
    EXPECT_EQ(patient->study, "Head with contrast");
    const Volume volume = read_dicom_series(find_dicom_series(folder.path()).front());
    std::string told = volume.name + volume.dicom->description + volume.dicom->modality;
    for (const Warning& w : volume.warnings) told += w.text;
    for (const auto& [key, value] : volume.dicom->component) told += key + value;
    EXPECT_EQ(told.find("ller"), std::string::npos);
    EXPECT_EQ(told.find("ID 7"), std::string::npos);
}

TEST(ScreenFacts, NamesComeInTheWritingThereIs) {
    const TemporaryFolder folder;
    const auto name_of = [&](const std::string& written) {
        ZooSlice slice;
        slice.extra = {{{0x0008, 0x0005}, "ISO_IR 192"}, {{0x0010, 0x0010}, written}};
        write_zoo_slice(folder / "a", slice);
        const auto patient = read_screen_facts(folder / "a").patient;
        return patient ? patient->name : "nobody";
    };
    EXPECT_EQ(name_of("Doe^Jane"), "Doe, Jane");
    EXPECT_EQ(name_of("Doe"), "Doe");
    EXPECT_EQ(name_of("^Jane"), "Jane");
    EXPECT_EQ(name_of("Yamada^Tarou=\xE5\xB1\xB1\xE7\x94\xB0^\xE5\xA4\xAA\xE9\x83\x8E"), "Yamada, Tarou");
    EXPECT_EQ(name_of("=\xE5\xB1\xB1\xE7\x94\xB0^\xE5\xA4\xAA"), "\xE5\xB1\xB1\xE7\x94\xB0, \xE5\xA4\xAA");
}

TEST(ScreenFacts, WhatIsNoDicomSaysNothing) {
    const TemporaryFolder folder;
    std::ofstream(folder / "text") << "no DICOM at all";
    EXPECT_TRUE(read_screen_facts(folder / "text").patient == nullptr);
    EXPECT_TRUE(read_screen_facts(folder / "absent").patient == nullptr);
    EXPECT_FALSE(read_screen_facts(folder / "absent").voi_function.has_value());
}

}  // namespace
}  // namespace lacuna
