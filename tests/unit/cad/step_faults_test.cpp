#include "cad/step_faults.hpp"

#include <gtest/gtest.h>

namespace quadrille::cad {
namespace {

std::string step(const std::string& data) { return "ISO-10303-21;\nDATA;\n" + data + "ENDSEC;\nEND-ISO-10303-21;\n"; }

TEST(StepFaults, none_in_a_sound_file) {
  EXPECT_EQ(step_fault(step("#1=CARTESIAN_POINT('a;#9''b',(0.,0.,0.));\n#2 = VERTEX_POINT('',\n #1);\n")), "");
  EXPECT_EQ(step_fault(step("#1=(A() B());#2=LINE('',#3,#1);#3=CARTESIAN_POINT('',(0.,0.));")), "");
  EXPECT_EQ(step_fault(""), "");
}

TEST(StepFaults, missing_entities_are_named) {
  EXPECT_EQ(step_fault(step("#2=VERTEX_POINT('',#1);")), "#2 VERTEX_POINT refers to #1, which is not in the file");
}

TEST(StepFaults, wrong_types_are_named) {
  EXPECT_EQ(step_fault(step("#1=DIRECTION('',(1.,0.));#2=VERTEX_POINT('',#1);")),
            "#2 VERTEX_POINT refers to #1, which is of type DIRECTION, not CARTESIAN_POINT");
  EXPECT_EQ(step_fault(step("#1=FOO();#2=EDGE_LOOP('',(#1));")),
            "#2 EDGE_LOOP refers to #1, which is of type FOO, not ORIENTED_EDGE");
}

}  // namespace
}  // namespace quadrille::cad
