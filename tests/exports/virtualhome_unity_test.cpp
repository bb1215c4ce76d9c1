// Which of VirtualHome's tasks Unity can do, by its table of classes and its prefabs; and forms by their names.
#include "exports/virtualhome_unity.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/files.h"
#include "exports/express.h"
#include "scene/simulator_forms.h"
#include "tests/support/committed_knowledge.h"
#include "tests/support/scratch_folder.h"

namespace unietp {
namespace {

using ::testing::HasSubstr;

const UnityProperties& classes() {
  static const auto read = read_unity_properties(UNIETP_SOURCE_DIR "/data/scene_files/virtualhome_unity.csv");
  return *read;
}

TEST(UnitysTable, AllowsWhatItsClassesCan) {
  EXPECT_EQ(denied_by_unity({"[Walk] <closet> (3)", "[Grab] <mug> (1)", "[Open] <kitchen_cabinet> (2)",
                             "[PutIn] <mug> (1) <kitchen_cabinet> (2)", "[StandUp]"},
                            classes()),
            "");
}

TEST(UnitysTable, AllowsWhatUnitysGraphsOfItsApartmentsShow) {
  EXPECT_EQ(denied_by_unity({"[Open] <washing_machine> (2)", "[PutIn] <mug> (1) <washing_machine> (2)"}, classes()),
            "");
}

TEST(UnitysTable, DeniesWhatNeitherSourceHas) {
  EXPECT_EQ(denied_by_unity({"[Open] <closetdrawer> (2)"}, classes()), "Unity's table denies Open of closetdrawer");
  EXPECT_EQ(denied_by_unity({"[Grab] <mug> (1)", "[PutIn] <mug> (1) <box> (2)"}, classes()),
            "Unity's table denies PutIn of box");
  EXPECT_EQ(denied_by_unity({"[Grab] <oventray> (1)"}, classes()), "Unity's table denies Grab of oventray")
      << "a class that it does not know";
}

/// A kitchen cabinet of a home of ours, which the demonstration opens.
FinishedTask opening_a_cabinet() {
  FinishedTask task;
  task.start.simulator = Simulator::Virtualhome;
  Node cabinet;
  cabinet.id = "kitchencabinet_1", cabinet.category = "kitchencabinet", cabinet.size = {1, 0.5, 0.8};
  task.start.nodes.push_back(cabinet);
  StepRecord step;
  step.command = {"open", {{"kitchencabinet_1", {}}}};
  step.success = true;
  task.shown[Mode::M1].steps = {step};
  return task;
}

TEST(UnitysPrefabs, AThingOfAClassWithoutAnyIsRefused) {
  namespace fs = std::filesystem;
  const ScratchFolder folder;
  const Profile profile;
  ExportRequest request;
  request.data = folder.path();
  request.backends.resize(kSimulators.size());
  for (const Simulator simulator : kSimulators)
    request.backends[static_cast<std::size_t>(simulator)] = {&committed_knowledge(simulator), &profile};
  fs::copy(fs::path(UNIETP_SOURCE_DIR) / "data" / "scene_files", folder.path() / "scene_files");
  const auto refused = [&] {
    return (*express_form(SimulatorForm::Kind::VirtualhomeUnity, request))(opening_a_cabinet())->refused;
  };
  EXPECT_EQ(refused(), "");
  fs::remove(folder.path() / "scene_files" / "virtualhome_prefabs.csv");
  ASSERT_TRUE(write_file(folder.path() / "scene_files", "virtualhome_prefabs.csv",
                         "prefab,class,width_m,depth_m,height_m,source\nBed_1,bed,1,2,0.5,curated\n"));
  EXPECT_EQ(refused(), "kitchencabinet: Unity has no prefab of it");
  EXPECT_EQ((*express_form(SimulatorForm::Kind::Virtualhome, request))(opening_a_cabinet())->refused, "")
      << "the graph needs none";
}

TEST(Forms, OfAllSimulatorsAreWritten) {
  ExportRequest request;
  request.data = std::filesystem::path(UNIETP_SOURCE_DIR) / "data";
  for (const SimulatorForm& form : kSimulatorForms) EXPECT_TRUE(express_form(form.kind, request)) << form.name;
}

TEST(UnitysTable, ThatIsNoneIsRefused) {
  const ScratchFolder folder;
  ASSERT_TRUE(write_file(folder.at(""), "table.csv", "class,action,source\nbox,Open,x\n"));
  const auto read = read_unity_properties(folder.at("table.csv"));
  ASSERT_FALSE(read);
  EXPECT_THAT(format(read.error()), HasSubstr("class, property and source"));
}

}  // namespace
}  // namespace unietp
