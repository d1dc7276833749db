#include "core/inspect/batch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <new>

#include "core/base/atomic_file.h"
#include "core/base/atomic_folder.h"
#include "core/base/file_lock.h"
#include "core/base/parallel.h"
#include "core/base/shell_word.h"
#include "core/chart/svg_text.h"
#include "core/inspect/batch_journal.h"
#include "core/io/dicom_source.h"
#include "core/render/engine.h"

namespace lacuna {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t k_mb = std::uint64_t(1) << 20;

/// A part as looked at before the first one starts.
struct Planned {
    std::size_t index = 0;    ///< in the series; the reference comes last
    std::uint64_t bytes = 0;  ///< it will take
    std::string fault;        ///< why it cannot be opened
    std::optional<BatchRow> done;
};

[[noreturn]] void refuse_reference(const std::string& reason) {
    throw Error(Errc::bad_input, "The reference component cannot be inspected: " + reason);
}

/// Runs what is planned on several threads, never more at once than memory allows.
class BatchRunner {
public:
    BatchRunner(const std::vector<BatchPart>& parts, const BatchOptions& options, const BatchJournal& journal,
                const JobContext& job)
        : parts_(parts), options_(options), journal_(journal), job_(job) {}

    /// @param reference  index of the part that stops the series where it cannot be inspected
    void run(std::vector<Planned>& planned, std::optional<std::size_t> reference) {
        reference_ = reference;
        std::vector<Planned*> open;
        for (Planned& p : planned)
            if (!p.done) open.push_back(&p);
        finished_ = planned.size() - open.size();
        total_ = planned.size();
        if (open.empty()) return;
        run_on_threads(std::min(int(open.size()), std::max(1, options_.jobs)), [&] { work(open); });
        if (fault_) std::rethrow_exception(fault_);
    }

private:
    void work(std::vector<Planned*>& open) {
        try {
            Engine engine(options_.device);
            while (Planned* part = take(open)) {
                const Returned returned{*this, *part};
                part->done = inspect(*part, engine);
                if (part->index == reference_ && !part->done->verdict) refuse_reference(part->done->reason);
                engine.drop_caches();
            }
        } catch (...) {
            const std::lock_guard lock(mutex_);
            if (!fault_) fault_ = std::current_exception();
        }
    }

    /// Gives a part's memory back however its work ends.
    struct Returned {
        BatchRunner& runner;
        const Planned& part;
        ~Returned() { runner.give_back(part); }
    };

    /// The next part in order, once its memory fits; a part alone always fits (larger ones were refused before).
    Planned* take(std::vector<Planned*>& open) {
        std::unique_lock lock(mutex_);
        while (next_ < open.size() && !fault_) {
            if (job_.stopped()) {
                fault_ = std::make_exception_ptr(Error(Errc::cancelled, "Cancelled."));
                break;
            }
            if (running_ == 0 || used_ + open[next_]->bytes <= options_.memory_bytes) {
                Planned* part = open[next_++];
                used_ += part->bytes;
                ++running_;
                return part;
            }
            changed_.wait_for(lock, std::chrono::milliseconds(20));
        }
        return nullptr;
    }

    void give_back(const Planned& part) {
        {
            const std::lock_guard lock(mutex_);
            used_ -= part.bytes;
            --running_;
            ++finished_;
            if (job_.progress && !fault_) job_.progress(double(finished_) / double(total_));
        }
        changed_.notify_all();
    }

    void tell(const Planned& part, PartState state, double progress) const {
        if (options_.on_part) options_.on_part(part.index, state, progress);
    }

    BatchRow inspect(const Planned& planned, Engine& engine) {
        const BatchPart& part = parts_[planned.index];
        tell(planned, PartState::running, 0);
        BatchRow row{part.name, last_name(part.input), std::nullopt, planned.fault, "", {}};
        if (planned.fault.empty()) inspect_into(row, planned, part, engine);
        job_.check();
        // As it reads back: file names may be in any encoding, the journal's JSON is UTF-8.
        for (std::string* text : {&row.input, &row.reason}) *text = valid_utf8(*text);
        for (std::string& text : row.more_reasons) text = valid_utf8(text);
        journal_.write(row);
        tell(planned, row.verdict ? PartState::done : PartState::broken, 1);
        return row;
    }

    /// What cannot be read or inspected makes a broken row; what cannot be written stops the series, for that is not
    /// the part's fault.
    void inspect_into(BatchRow& row, const Planned& planned, const BatchPart& part, Engine& engine) {
        JobContext job{job_.stop, nullptr};
        if (options_.on_part) job.progress = [this, planned](double p) { tell(planned, PartState::running, p); };
        std::optional<InspectionReport> report;
        Volume volume;
        try {
            volume = open_volume(part.input, options_.open, job.part(0, 0.2));
            const std::vector<ZoneMask> masks = lay_zones(options_.criteria, volume.geometry(), {job.stop, nullptr});
            InspectOptions inspect;
            inspect.input = part.input;
            inspect.software = options_.software;
            inspect.replay =
                fmt::format("lacuna inspect {} --criteria criteria.json --report {}{}",
                            shell_word(last_name(part.input)), shell_word(part.name), open_flags(options_.open));
            if (options_.worst != InspectOptions().worst) inspect.replay += fmt::format(" --worst {}", options_.worst);
            inspect.worst = options_.worst;
            if (volume.dicom) inspect.source = find_dicom_source(part.input, options_.open, {job.stop, nullptr});
            report = inspect_part(volume, options_.criteria, masks, engine, inspect, job.part(0.2, 0.9));
        } catch (const Error& error) {
            if (error.code() == Errc::cancelled) throw;
            row.reason = error.what();
        } catch (const std::bad_alloc&) {
            row.reason = "There was not enough memory.";
        } catch (const std::exception& error) {
            row.reason = error.what();
        }
        if (!report) return;
        write_report(*report, volume, options_.folder / part.name, job.part(0.9, 1));
        row = row_of(part, *report);
    }

    const std::vector<BatchPart>& parts_;
    const BatchOptions& options_;
    const BatchJournal& journal_;
    const JobContext& job_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::optional<std::size_t> reference_;
    std::size_t next_ = 0, finished_ = 0, total_ = 0;
    int running_ = 0;
    std::uint64_t used_ = 0;
    std::exception_ptr fault_;
};

/// Looks at an input without reading its voxels.
void look_at(Planned& planned, const BatchPart& part, const BatchOptions& options, const JobContext& job) {
    try {
        const std::vector<SeriesEntry> found =
            options.open.raw.empty() ? list_series(part.input, {job.stop, nullptr}) : std::vector<SeriesEntry>{};
        std::uint64_t voxels = 0;
        for (const SeriesEntry& entry : found) {
            const glm::ivec3 n = glm::max(entry.size, 0);
            voxels = std::max(voxels, std::uint64_t(n.x) * std::uint64_t(n.y) * std::uint64_t(n.z));
        }
        constexpr int k_usual_bytes = 2;  // a voxel; the type is known only when it is read
        planned.bytes = inspection_bytes(voxels, k_usual_bytes);
        if (planned.bytes > options.memory_bytes)
            planned.fault = fmt::format("Inspecting it takes {} MB and the limit is {} MB.",
                                        (planned.bytes + k_mb - 1) / k_mb, options.memory_bytes / k_mb);
    } catch (const Error& error) {
        if (error.code() == Errc::cancelled) throw;
        planned.fault = error.what();
    }
}

void check(const BatchOptions& options) {
    if (options.jobs < 1 || options.jobs > 1024) throw Error(Errc::bad_usage, "A series runs 1 to 1024 parts at once.");
    if (options.shards < 1 || options.shard < 1 || options.shard > options.shards)
        throw Error(Errc::bad_usage, "A shard is I/N with 1 <= I <= N.");
}

void write_summary(const fs::path& folder, const BatchResult& result, const BatchOptions& options) {
    write_file(folder / "summary.csv", summary_csv(result.rows, result.reference));
    write_file(folder / "summary.html",
               summary_html(result.rows, result.reference, options.criteria, options.software));
}

}  // namespace

std::uint64_t inspection_bytes(std::uint64_t voxels, int bytes_per_voxel) {
    constexpr std::uint64_t k_measuring = 9;  // labels, mask and work, a voxel
    constexpr std::uint64_t k_fixed = 96 * k_mb;
    // The volume stands in memory twice, here and on the device.
    return voxels * (k_measuring + 2 * std::uint64_t(bytes_per_voxel)) + k_fixed;
}

std::vector<std::string> reasons_of(const BatchRow& row) {
    std::vector<std::string> all;
    if (!row.reason.empty()) all.push_back(row.reason);
    all.insert(all.end(), row.more_reasons.begin(), row.more_reasons.end());
    return all;
}

BatchRow row_of(const BatchPart& part, const InspectionReport& report) {
    BatchRow row{part.name, report.scan.input, report.judgement.verdict, "", report.scan.sha256, {}};
    const std::vector<std::string>& reasons = report.judgement.reasons;
    if (!reasons.empty()) {
        row.reason = reasons.front();
        row.more_reasons.assign(reasons.begin() + 1, reasons.end());
    }
    const PartFacts& facts = report.analysis.part;
    if (!facts.has_material) return row;
    const auto exact = [](double v) { return Measured{v, v, v}; };
    Measured volume{0, 0, 0}, diameter{0, 0, 0}, gap = exact(INFINITY), distance = exact(INFINITY);
    for (const Defect& d : report.analysis.defects) {
        if (d.measurable && d.volume_mm3.value > volume.value) volume = d.volume_mm3;
        if (d.measurable && d.diameter_mm.value > diameter.value) diameter = d.diameter_mm;
        if (d.gap_mm < gap.value) gap = exact(d.gap_mm);
        if (d.surface_distance_mm.value < distance.value) distance = d.surface_distance_mm;
    }
    const glm::dvec3 size = facts.bbox_max_mm - facts.bbox_min_mm;
    row.values = {{"porosity_percent", facts.porosity_percent},
                  {"count", exact(double(report.analysis.defects.size()))},
                  {"largest_defect_volume_mm3", volume},
                  {"largest_defect_diameter_mm", diameter},
                  {"smallest_gap_mm", gap},
                  {"smallest_surface_distance_mm", distance},
                  {"part_volume_mm3", facts.part_volume_mm3},
                  {"material_volume_mm3", exact(facts.material_volume_mm3)},
                  {"size_x_mm", exact(size.x)},
                  {"size_y_mm", exact(size.y)},
                  {"size_z_mm", exact(size.z)},
                  {"material_level", exact(facts.material_level)},
                  {"noise", exact(facts.noise)},
                  {"edge_width_mm", exact(facts.edge_width_mm)}};
    return row;
}

BatchResult run_batch(const std::vector<BatchPart>& series, const BatchOptions& options, const JobContext& job) {
    check(options);
    BatchJournal journal(options.folder);
    std::vector<BatchPart> parts = series;
    const bool with_reference = !options.reference.empty();
    if (with_reference) parts.push_back({"reference", options.reference});
    // A slip in its name must not leave a folder behind that holds the series to it.
    const std::optional<BatchRow> known = with_reference ? journal.read("reference") : std::nullopt;
    if (with_reference && options.shard == 1 && !(known && known->verdict)) {
        Planned reference;
        look_at(reference, parts.back(), options, job);
        if (!reference.fault.empty()) refuse_reference(reference.fault);
    }
    journal.open(series, options);
    const FileLock lock(journal.lock_file(options.shard),
                        "The folder " + options.folder.string() +
                            " is being filled by another run of this series; wait for it to end, or stop it.");

    std::vector<Planned> planned;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const bool reference = with_reference && i + 1 == parts.size();
        // The reference belongs to the first shard.
        if (reference ? options.shard != 1 : int(i % std::size_t(options.shards)) != options.shard - 1) continue;
        job.check();
        Planned part{i, 0, "", journal.read(parts[i].name)};
        if (part.done && !part.done->verdict) part.done.reset();  // what was broken may have been mended
        if (!part.done) {
            journal.forget(parts[i].name);
            AtomicFolder::remove_leftovers(options.folder / parts[i].name);
            look_at(part, parts[i], options, job);
        }
        planned.push_back(std::move(part));
    }
    // The reference first: where it cannot be read, no part has been waited for.
    if (with_reference && !planned.empty() && planned.back().index + 1 == parts.size())
        std::rotate(planned.begin(), planned.end() - 1, planned.end());
    BatchRunner(parts, options, journal, job)
        .run(planned, with_reference ? std::optional(parts.size() - 1) : std::nullopt);

    BatchResult result;
    for (const Planned& part : planned) {
        if (with_reference && part.index + 1 == parts.size())
            result.reference = part.done;
        else
            result.rows.push_back(*part.done);
    }
    if (options.shards > 1) return result;
    write_summary(options.folder, result, options);
    result.whole = true;
    return result;
}

BatchResult merge_batch(const fs::path& folder) {
    const BatchJournal journal(folder);
    std::vector<BatchPart> parts;
    BatchOptions options;
    journal.read_series(parts, options);
    BatchResult result;
    std::string missing;
    std::size_t count = 0;
    const auto want = [&](const std::string& name) {
        std::optional<BatchRow> row = journal.read(name);
        if (!row && ++count <= 8) missing += (missing.empty() ? "" : ", ") + name;
        return row;
    };
    for (const BatchPart& part : parts)
        if (const auto row = want(part.name)) result.rows.push_back(*row);
    if (!options.reference.empty()) result.reference = want("reference");
    if (count > 0)
        throw Error(Errc::bad_input,
                    fmt::format("{} of {} parts in {} are not done ({}{}); run their shards again.", count,
                                parts.size(), folder.string(), missing, count > 8 ? ", ..." : ""));
    if (result.reference && !result.reference->verdict) refuse_reference(result.reference->reason);
    write_summary(folder, result, options);
    result.whole = true;
    return result;
}

}  // namespace lacuna
