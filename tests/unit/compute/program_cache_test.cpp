#include "core/compute/program_cache.h"

#include <fstream>
#include <set>

#include "compute_fixture.h"

namespace lacuna {

namespace {

namespace fs = std::filesystem;

const ProgramKey k_key{"source", "options", "device", "driver", "platform"};

std::size_t count_files(const fs::path& folder) {
    return std::size_t(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

}  // namespace

TEST(ProgramCache, GivesBackWhatWasStored) {
    const ScratchFolder folder;
    const ProgramCache cache(folder.path() / "a" / "b");
    EXPECT_EQ(cache.load(k_key), std::nullopt);
    const std::string binary("\0\1\2 binary \xff", 12);
    ASSERT_TRUE(cache.store(k_key, binary));
    EXPECT_EQ(cache.load(k_key), binary);
    EXPECT_EQ(ProgramCache(folder.path() / "a" / "b").load(k_key), binary);
    ASSERT_TRUE(cache.store(k_key, "newer"));
    EXPECT_EQ(cache.load(k_key), "newer");
    cache.remove(k_key);
    EXPECT_EQ(cache.load(k_key), std::nullopt);
    EXPECT_EQ(count_files(folder.path() / "a" / "b"), 0u);
}

TEST(ProgramCache, EveryPartOfTheKeyCounts) {
    const ProgramCache cache("folder");
    std::set<fs::path> files{cache.file_of(k_key)};
    for (auto part :
         {&ProgramKey::source, &ProgramKey::options, &ProgramKey::device, &ProgramKey::driver, &ProgramKey::platform}) {
        ProgramKey other = k_key;
        other.*part += "x";
        files.insert(cache.file_of(other));
    }
    ProgramKey shifted = k_key;  // the same letters, parted elsewhere
    shifted.source += shifted.options.front();
    shifted.options.erase(0, 1);
    files.insert(cache.file_of(shifted));
    files.insert(cache.file_of(ProgramKey{}));
    EXPECT_EQ(files.size(), 8u);
}

TEST(ProgramCache, AnotherKeysFileIsNotTaken) {
    const ScratchFolder folder;
    const ProgramCache cache(folder.path());
    ProgramKey other = k_key;
    other.driver = "newer driver";
    ASSERT_TRUE(cache.store(k_key, "binary"));
    fs::copy_file(cache.file_of(k_key), cache.file_of(other));  // as if the hashes were equal
    EXPECT_EQ(cache.load(other), std::nullopt);
    EXPECT_EQ(cache.load(k_key), "binary");
}

TEST(ProgramCache, ForeignEntriesAreTolerated) {
    const ScratchFolder folder;
    const ProgramCache cache(folder.path());
    fs::create_directories(cache.file_of(k_key));  // a folder where the file would be
    EXPECT_EQ(cache.load(k_key), std::nullopt);
    EXPECT_FALSE(cache.store(k_key, "binary"));
    EXPECT_EQ(count_files(folder.path()), 1u) << "nothing half-written is left";
}

TEST(ProgramCache, EmptyBinariesAndNoFolderKeepNothing) {
    const ScratchFolder folder;
    EXPECT_FALSE(ProgramCache(folder.path()).store(k_key, ""));
    const ProgramCache none{fs::path()};
    EXPECT_FALSE(none.store(k_key, "binary"));
    EXPECT_EQ(none.load(k_key), std::nullopt);
    none.remove(k_key);
    EXPECT_EQ(count_files(folder.path()), 0u);
}

TEST(ProgramCache, AReadOnlyFolderIsTolerated) {
    if (::geteuid() == 0) GTEST_SKIP() << "root may write anywhere";
    const ScratchFolder folder;
    fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
    EXPECT_FALSE(ProgramCache(folder.path()).store(k_key, "binary"));
}

TEST(ProgramCache, AProcFolderCannotBeWrittenEvenByRoot) {
    EXPECT_FALSE(ProgramCache("/proc/lacuna-kernels").store(k_key, "binary"));
}

TEST(ProgramCache, KeepsTheNewestAndWhatWasUsed) {
    const ScratchFolder folder;
    const ProgramCache cache(folder.path());
    std::ofstream(folder.path() / "notes.txt") << "not ours";
    const auto start = fs::file_time_type::clock::now() - std::chrono::hours(2);
    const auto key_of = [](std::size_t i) { return ProgramKey{"source " + std::to_string(i), "", "", "", ""}; };
    for (std::size_t i = 0; i < ProgramCache::k_entries_kept; ++i) {
        ASSERT_TRUE(cache.store(key_of(i), "binary"));
        fs::last_write_time(cache.file_of(key_of(i)), start + std::chrono::seconds(i));
    }
    EXPECT_TRUE(cache.load(key_of(0)));  // used now
    ASSERT_TRUE(cache.store(key_of(1000), "binary"));
    ASSERT_TRUE(cache.store(key_of(1001), "binary"));
    EXPECT_EQ(count_files(folder.path()), ProgramCache::k_entries_kept + 1);
    EXPECT_TRUE(cache.load(key_of(0)));
    EXPECT_FALSE(cache.load(key_of(1)));
    EXPECT_FALSE(cache.load(key_of(2)));
    EXPECT_TRUE(cache.load(key_of(3)));
    EXPECT_TRUE(fs::exists(folder.path() / "notes.txt"));
}

TEST(ProgramCache, FolderComesFromTheEnvironment) {
    ::setenv("LACUNA_CACHE", "/own", 1);
    EXPECT_EQ(ProgramCache::default_folder(), "/own");
    ::unsetenv("LACUNA_CACHE");
    const char* before = std::getenv("XDG_CACHE_HOME");
    const std::string saved = before ? before : "";
    ::setenv("XDG_CACHE_HOME", "/xdg", 1);
    EXPECT_EQ(ProgramCache::default_folder(), "/xdg/lacuna/kernels");
    ::unsetenv("XDG_CACHE_HOME");
    if (const char* home = std::getenv("HOME")) {
        EXPECT_EQ(ProgramCache::default_folder(), fs::path(home) / ".cache/lacuna/kernels");
    }
    if (before) ::setenv("XDG_CACHE_HOME", saved.c_str(), 1);
}

}  // namespace lacuna
