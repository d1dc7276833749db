#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>

namespace lacuna {

/// The middle value; of an even number of values the mean of the two middle ones, of none NaN. No value may be NaN.
/// @param values  a container with random access; its own copy is put out of order. Cost: linear
template <class Container>
double median(Container values) {
    const auto count = std::size(values);
    if (count == 0) return std::numeric_limits<double>::quiet_NaN();
    const auto middle = std::begin(values) + std::ptrdiff_t(count / 2);
    std::nth_element(std::begin(values), middle, std::end(values));
    if (count % 2 == 1) return double(*middle);
    return 0.5 * (double(*std::max_element(std::begin(values), middle)) + double(*middle));
}

}  // namespace lacuna
