#include "mesh/input_form.h"

#include "mesh/array_bytes.h"

namespace pectin {

std::size_t UnsharedSeams::memory_bytes() const {
    return capacity_bytes(representatives) + capacity_bytes(corner_vertices) +
           capacity_bytes(edges);
}

bool InputForm::operator==(const InputForm& o) const {
    return parts == o.parts && material_libraries == o.material_libraries &&
           outlines == o.outlines && outline_corners == o.outline_corners &&
           elements == o.elements && same_bytes(element_corners, o.element_corners) &&
           same_bytes(loose_corners, o.loose_corners) && seams == o.seams;
}

std::size_t InputForm::memory_bytes() const {
    std::size_t names = capacity_bytes(material_libraries);
    for (const std::string& name : material_libraries) names += name.capacity();
    for (const Part& part : parts) {
        names += part.object.capacity() + part.group.capacity() + part.material.capacity();
    }
    return names + capacity_bytes(parts) + capacity_bytes(outlines) +
           capacity_bytes(outline_corners) + capacity_bytes(elements) +
           capacity_bytes(element_corners) + capacity_bytes(loose_corners) + seams.memory_bytes();
}

}  // namespace pectin
