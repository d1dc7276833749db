#include <algorithm>
#include <optional>
#include <set>
#include <string_view>

#include "core/base/error.h"
#include "core/compute/embedded_kernels.h"
#include "core/compute/program.h"

namespace lacuna {

namespace {

std::optional<std::string_view> embedded_text(std::string_view name) {
    for (const EmbeddedKernelFile& file : embedded_kernel_files())
        if (name == file.name) return std::string_view(reinterpret_cast<const char*>(file.bytes), file.size);
    return std::nullopt;
}

std::string_view without_leading_blanks(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t");
    return first == std::string_view::npos ? std::string_view{} : text.substr(first);
}

/// The directive's word and what follows it, of a line "# word rest"; empty word when it is none.
struct Directive {
    std::string_view word, rest;
};

Directive directive_of(std::string_view line) {
    line = without_leading_blanks(line);
    if (line.empty() || line.front() != '#') return {};
    line = without_leading_blanks(line.substr(1));
    const std::size_t end = std::min(line.find_first_of(" \t\r\"<("), line.size());
    return {line.substr(0, end), without_leading_blanks(line.substr(end))};
}

/// The name between quotes; empty for <...> and macros, which the device's compiler resolves.
std::string_view quoted_name(std::string_view rest) {
    if (rest.empty() || rest.front() != '"') return {};
    const std::size_t end = rest.find('"', 1);
    return end == std::string_view::npos ? std::string_view{} : rest.substr(1, end - 1);
}

std::string guard_name(std::string_view file) {
    std::string guard = "LACUNA_INCLUDED_";
    for (char c : file) guard += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    return guard;
}

class Expander {
public:
    explicit Expander(const SourceText& files) : files_(files) {}

    std::string expand(const std::string& name) {
        const auto text = files_(name);
        if (!text) throw Error(Errc::kernel_build, "There is no kernel source \"" + name + "\" in this program.", name);
        out_.reserve(text->size() * 4);
        append(name, *text, false);
        return std::move(out_);
    }

private:
    /// Appends one file line by line. An include below #if may stand in a branch that is not taken, so a file seen only
    /// there is written again, behind a guard, where it is included next.
    void append(const std::string& name, std::string_view text, bool conditional) {
        open_.insert(name);
        line_directive(1, name);
        int depth = 0, number = 0;
        while (!text.empty()) {
            const std::size_t end = text.find('\n');
            const std::string_view line = text.substr(0, end);
            text = end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
            ++number;
            const Directive directive = directive_of(line);
            if (directive.word == "if" || directive.word == "ifdef" || directive.word == "ifndef") ++depth;
            if (directive.word == "endif") --depth;
            const std::string_view quoted = directive.word == "include" ? quoted_name(directive.rest) : "";
            if (!quoted.empty()) {
                include(std::string(quoted), name, number, conditional || depth > 0);
                line_directive(number + 1, name);
            } else if (directive.word == "pragma" && directive.rest.starts_with("once")) {
                out_ += '\n';
            } else {
                out_.append(line);
                out_ += '\n';
            }
        }
        open_.erase(name);
    }

    void include(const std::string& wanted, const std::string& from, int number, bool conditional) {
        std::string name = wanted;
        auto text = files_(name);
        if (!text) {  // beside the including file, as a C compiler looks
            name = from.substr(0, from.find_last_of('/') + 1) + wanted;
            text = files_(name);
        }
        if (!text)
            throw Error(Errc::kernel_build,
                        "Kernel source " + from + ", line " + std::to_string(number) + ", includes \"" + wanted +
                            "\", which is not in this program.",
                        wanted);
        if (open_.count(name) || always_.count(name)) return;
        if (!conditional) always_.insert(name);
        const std::string guard = guard_name(name);
        out_ += "#ifndef " + guard + "\n#define " + guard + "\n";
        append(name, *text, conditional);
        out_ += "#endif\n";
    }

    void line_directive(int number, const std::string& name) {
        out_ += "#line " + std::to_string(number) + " \"" + name + "\"\n";
    }

    const SourceText& files_;
    std::string out_;
    std::set<std::string> open_, always_;
};

}  // namespace

std::string expand_source(const std::string& name, const SourceText& files) { return Expander(files).expand(name); }

std::string expand_kernel_source(const std::string& name) { return expand_source(name, embedded_text); }

}  // namespace lacuna
