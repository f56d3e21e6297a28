#pragma once
// Reads a prescribed polynomial order for every element: from JSON (formats/order-map.md) or from the orders of a
// field.

#include <string>
#include <vector>

#include "io/whole_file.hpp"
#include "model/field.hpp"

namespace quadrille::io {

/// "field" or "order-map": what the file is, if it is any of them.
std::string order_map_format(const InputFile& file);

/// One order per element. Throws FormatError for anything that is neither an order map nor a field, for another number
/// than `num_elems` and for an order outside [1, max_order].
OrderMap read_order_map(const InputFile& file, int num_elems, int max_order);

}  // namespace quadrille::io
