// Why a part of a series was rejected: every reason is kept, the first one where there is room for one.
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "core/base/atomic_file.h"
#include "core/inspect/batch.h"
#include "core/inspect/batch_journal.h"

namespace lacuna {

namespace {

namespace fs = std::filesystem;

BatchRow rejected() {
    BatchRow row{"a", "a.mhd", Verdict::fail, "Count: 3 breaks 2.", "00ff", {}};
    row.more_reasons = {"Gap: 0.1 mm, \"too near\".", "The part is cut."};
    return row;
}

TEST(BatchReasons, AreAllThereInOrder) {
    EXPECT_EQ(reasons_of(rejected()),
              (std::vector<std::string>{"Count: 3 breaks 2.", "Gap: 0.1 mm, \"too near\".", "The part is cut."}));
    EXPECT_TRUE(reasons_of({}).empty());
    InspectionReport report;
    report.judgement.verdict = Verdict::fail;
    report.judgement.reasons = reasons_of(rejected());
    const BatchRow row = row_of({"a", "a.mhd"}, report);
    EXPECT_EQ(row.reason, "Count: 3 breaks 2.");
    EXPECT_EQ(reasons_of(row), reasons_of(rejected()));
}

TEST(BatchReasons, OutliveAResumeAndOldJournalsAreRead) {
    const fs::path folder = fs::temp_directory_path() / ("lacuna-reasons-" + std::to_string(::getpid()));
    fs::remove_all(folder);
    fs::create_directories(folder / "a");
    fs::create_directories(folder / "journal");
    std::ofstream(folder / "a" / "report.json") << "{}";
    const BatchJournal journal(folder);
    journal.write(rejected());
    const auto back = journal.read("a");
    ASSERT_TRUE(back);
    EXPECT_EQ(reasons_of(*back), reasons_of(rejected()));
    BatchRow one = rejected();
    one.more_reasons.clear();
    journal.write(one);
    for (const fs::directory_entry& entry : fs::directory_iterator(folder / "journal"))
        EXPECT_EQ(read_file(entry.path()).find("more_reasons"), std::string::npos) << "as before there were such";
    ASSERT_TRUE(journal.read("a"));
    EXPECT_TRUE(journal.read("a")->more_reasons.empty());
    fs::remove_all(folder);
}

TEST(BatchReasons, StandInTheSummariesWithTheFirstInItsPlace) {
    const std::vector<BatchRow> rows{rejected()};
    const std::string csv = summary_csv(rows, std::nullopt);
    EXPECT_TRUE(csv.starts_with("part,input,verdict,reason,outlier_in,sha256,more_reasons"));
    EXPECT_NE(csv.find("a,a.mhd,fail,Count: 3 breaks 2.,,00ff,\"Gap: 0.1 mm, \"\"too near\"\". The part is cut.\""),
              std::string::npos)
        << csv;
    const std::string html = summary_html(rows, std::nullopt, {}, "Lacuna");
    EXPECT_NE(html.find("Count: 3 breaks 2. Gap: 0.1 mm"), std::string::npos);
}

}  // namespace

}  // namespace lacuna
