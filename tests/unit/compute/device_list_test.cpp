#include "core/compute/device_list.h"

#include <gtest/gtest.h>

namespace lacuna {

namespace {

DeviceInfo device(int index, const std::string& name, bool usable, double rank_ms) {
    DeviceInfo info;
    info.index = index;
    info.name = name;
    info.platform = "platform";
    info.usable = usable;
    info.rank_ms = rank_ms;
    if (!usable) info.fault = "a sum gave 1 in place of 2";
    return info;
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST(DeviceList, FastestIsTheUsableOneOfLeastTime) {
    EXPECT_EQ(fastest_index({}), -1);
    EXPECT_EQ(fastest_index({device(0, "broken", false, 0)}), -1);
    EXPECT_EQ(fastest_index({device(0, "a", true, 3), device(1, "broken", false, 0), device(2, "b", true, 1)}), 2);
}

TEST(DeviceList, SaysWhy) {
    EXPECT_TRUE(holds(why_chosen({}, -1), "no OpenCL platform"));
    EXPECT_TRUE(holds(why_chosen({device(0, "broken", false, 0)}, -1), "no device can be used"));
    EXPECT_EQ(why_chosen({device(0, "a", true, 0)}, 0), "the only device");
    EXPECT_EQ(why_chosen({device(0, "a", true, 2), device(1, "broken", false, 0)}, 0), "the only one that can be used");
    EXPECT_EQ(why_chosen({device(0, "a", true, 2), device(1, "b", true, 1)}, 1),
              "the fastest of 2 by the ranking kernel");
    EXPECT_EQ(why_chosen({device(0, "a", true, 2), device(1, "b", true, 1)}, 0), "asked for");
}

TEST(DeviceList, TextShowsEveryDeviceTheChoiceAndTheFault) {
    const std::vector<DeviceInfo> devices{device(0, "first", true, 2), device(1, "second", false, 0)};
    const std::string text = describe_devices(devices, 0);
    EXPECT_TRUE(holds(text, "* 0: first")) << text;
    EXPECT_TRUE(holds(text, "  1: second")) << text;
    EXPECT_TRUE(holds(text, "cannot be used: a sum gave 1 in place of 2")) << text;
    EXPECT_TRUE(holds(text, "Chosen: 0 (first), the only one that can be used.")) << text;
    EXPECT_TRUE(holds(describe_devices({}, -1), "Chosen: none"));
}

TEST(DeviceList, JsonHasTheSameAndSurvivesOddText) {
    const std::vector<DeviceInfo> devices{device(0, "fi\"rst\xff", true, 2), device(1, "second", false, 0)};
    const std::string json = describe_devices_json(devices, 0);
    EXPECT_TRUE(holds(json, "\"chosen\": 0")) << json;
    EXPECT_TRUE(holds(json, "\"rank_ms\": 2.0")) << json;
    EXPECT_TRUE(holds(json, "\"rank_ms\": null")) << json;
    EXPECT_TRUE(holds(json, "fi\\\"rst")) << json;
    EXPECT_TRUE(holds(describe_devices_json({}, -1), "\"chosen\": null"));
}

}  // namespace lacuna
