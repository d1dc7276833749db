#include <gtest/gtest.h>
#include <unistd.h>

#include "core/base/atomic_file.h"
#include "core/session/preset_library.h"
#include "core/session/preset_settings.h"
#include "core/session/shown_part.h"
#include "core/volume/samples.h"

namespace lacuna {
namespace {

namespace fs = std::filesystem;

class Presets : public testing::Test {
protected:
    void SetUp() override {
        folder = fs::temp_directory_path() / ("lacuna-presets-" + std::to_string(::getpid())) / "own";
        fs::remove_all(folder.parent_path());
        preset.tf.name =
            "Kn\xc3\xb6"
            "chel: links/rechts";
        preset.tf.points = {{1, {1, 0, 0}, 0.5}};
        preset.technique = Technique{"mip", "none", 0.25};
    }
    void TearDown() override { fs::remove_all(folder.parent_path()); }
    std::vector<PresetEntry> own() const {
        std::vector<PresetEntry> all = list_presets(folder);
        std::erase_if(all, [](const PresetEntry& e) { return e.built_in(); });
        return all;
    }
    fs::path folder;
    PresetFile preset;
};

TEST_F(Presets, AreStoredRenamedAndRemoved) {
    EXPECT_EQ(list_presets(folder).size(), preset_names().size());  // no folder yet
    const fs::path file = store_preset(folder, preset, false);
    EXPECT_EQ(file.parent_path(), folder);
    ASSERT_EQ(own().size(), 1u);
    EXPECT_EQ(own()[0].name, preset.tf.name);
    EXPECT_EQ(*own()[0].preset, preset);
    EXPECT_THROW(store_preset(folder, preset, false), Error);
    PresetFile changed = preset;
    changed.tf.points[0].opacity = 1;
    EXPECT_EQ(store_preset(folder, changed, true), file);
    EXPECT_EQ(*own()[0].preset, changed);
    const fs::path renamed = rename_preset(file, "other");
    ASSERT_EQ(own().size(), 1u);
    EXPECT_EQ(own()[0].name, "other");
    EXPECT_THROW(rename_preset(renamed, "bone"), Error);  // a built-in one's name
    EXPECT_THROW(rename_preset(renamed, "  "), Error);
    EXPECT_EQ(own()[0].name, "other");
    remove_preset(renamed);
    EXPECT_TRUE(own().empty());
}

TEST_F(Presets, NamesThatReadAlikeAsFilesStayApart) {
    preset.tf.name = "a/b";
    store_preset(folder, preset, false);
    preset.tf.name = "a:b";
    store_preset(folder, preset, false);
    ASSERT_EQ(own().size(), 2u);
    EXPECT_EQ(own()[0].name, "a/b");
    EXPECT_EQ(own()[1].name, "a:b");
}

TEST_F(Presets, BrokenAndLaterFilesAreNamedAndKept) {
    fs::create_directories(folder);
    write_file(folder / "broken.json", "{\"points\":");
    write_file(folder / "later.json", "{\"version\":9,\"layers\":[]}");
    write_file(folder / "notes.txt", "not a preset");
    const std::vector<PresetEntry> found = own();
    ASSERT_EQ(found.size(), 2u);
    for (const PresetEntry& entry : found) {
        EXPECT_FALSE(entry.preset);
        EXPECT_THROW(preset_for(entry, {}, {}), Error);
        EXPECT_NE(entry.fault.find(entry.file.filename().string()), std::string::npos) << entry.fault;
    }
    EXPECT_NE(found[1].fault.find("version 9"), std::string::npos) << found[1].fault;
    preset.tf.name = "broken";
    EXPECT_THROW(store_preset(folder, preset, false), Error);
    EXPECT_EQ(read_file(folder / "later.json", 1000), "{\"version\":9,\"layers\":[]}");
}

TEST_F(Presets, CarryTheirTechnique) {
    ViewSettings settings;
    const ViewSettings shown = with_preset(settings, preset);
    EXPECT_EQ(shown.tf, preset.tf);
    EXPECT_EQ(shown.mode, ViewMode::mip);
    EXPECT_EQ(shown.shading, Shading::none);
    EXPECT_EQ(shown.quality.step, 0.25);
    EXPECT_EQ(preset_of(shown, preset.tf.name), preset);
    preset.technique.reset();
    EXPECT_EQ(with_preset(settings, preset).mode, settings.mode);
    for (const Technique& bad : {Technique{"xray", "", 0}, Technique{"", "toon", 0}, Technique{"", "", 1e9}}) {
        preset.technique = bad;
        EXPECT_THROW(with_preset(settings, preset), Error);
    }
    const Volume volume = make_sample("casting", {.size = 24}).volume;
    const VolumeStatistics statistics = compute_statistics(volume);
    for (const PresetEntry& entry : list_presets(folder))
        EXPECT_NO_THROW(with_preset(settings, preset_for(entry, volume, statistics))) << entry.name;
}

TEST(ShownPart, HoldsTheCutsAndRangesInUse) {
    ViewSettings settings;
    settings.cuts = {{{{1, 0, 0}, 2, true}, true}, {{{0, 1, 0}, 3, true}, false}};
    settings.ranges = {{{"a", {1, 2}, {}}, false}, {{"b", {3, 4}, {}}, true}};
    const VolumePart part = shown_part(settings);
    EXPECT_EQ(part.half_spaces, (std::vector<glm::dvec4>{{1, 0, 0, 2}}));
    EXPECT_EQ(part.ranges, (std::vector<ValueRange>{{3, 4}}));
    EXPECT_TRUE(shown_part(ViewSettings{}).whole());
}

}  // namespace
}  // namespace lacuna
