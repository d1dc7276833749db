#include "app/leap_options.h"

#include "app/parse.h"

namespace lacuna::cli {

void LeapWords::add_to(CLI::App& command) {
    command.add_option(
        "--leaping", kernel_word_,
        "kernel of leap: lossless (default), confirmed or published (as Frey & Ertl 2009; ea, no shading)");
    command.add_option("--leap-values", values_word_,
                       "where leap values come from: transform (default), kd-tree or groups[,P,R] (probability of a "
                       "centre, relative radius; 0.001,0.5)");
    command.add_option("--leap-quantise", quantise_word_,
                       "LO,HI: values of an f32 volume that leap spreads over 15 bits; needed there");
    command.add_option("--leap-min-voxels", min_voxels_word_, "leap through regions from so many voxels (default 64)");
}

void LeapWords::parse() {
    if (kernel_word_) leap_.kernel = for_flag("--leaping", [&] { return parse_leaping(*kernel_word_); });
    if (values_word_) {
        const std::size_t comma = values_word_->find(',');
        leap_.way = for_flag("--leap-values", [&] { return parse_leap_way(values_word_->substr(0, comma)); });
        if (comma != std::string::npos) {
            if (leap_.way != LeapWay::groups)
                refuse("--leap-values", *values_word_, "transform, kd-tree or groups,P,R");
            const std::vector<double> v = parse_numbers("--leap-values", values_word_->substr(comma + 1), 2);
            for (const double share : v)
                if (!(share >= 0 && share <= 1))
                    refuse("--leap-values", *values_word_, "groups,P,R with shares from 0 to 1");
            leap_.groups.probability = v[0];
            leap_.groups.relative_radius = v[1];
        }
    }
    if (quantise_word_) leap_.quantisation = parse_range("--leap-quantise", *quantise_word_);
    if (quantise_word_ && !(leap_.quantisation->lo < leap_.quantisation->hi))
        refuse("--leap-quantise", *quantise_word_, "LO,HI with LO below HI");
    if (min_voxels_word_) leap_.min_voxels = parse_integer("--leap-min-voxels", *min_voxels_word_, 1, INT64_MAX);
}

const char* LeapWords::given() const {
    return kernel_word_       ? "--leaping"
           : values_word_     ? "--leap-values"
           : quantise_word_   ? "--leap-quantise"
           : min_voxels_word_ ? "--leap-min-voxels"
                              : nullptr;
}

void LeapWords::apply(Plan& plan) const {
    plan.leap = leap_;
    if (kernel_word_) plan.why.push_back("--leaping as asked for");
    if (values_word_) plan.why.push_back("--leap-values as asked for");
}

}  // namespace lacuna::cli
