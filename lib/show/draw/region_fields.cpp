#include "draw/region_fields.hpp"

#include "regions/split.hpp"

namespace quadrille::draw {

RegionFields::RegionFields(const Field& field) : fields(regions::split(field)) {
  for (const Field& part : fields) evaluators.emplace_back(part);
}

}  // namespace quadrille::draw
