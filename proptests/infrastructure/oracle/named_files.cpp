// SPDX-License-Identifier: Apache-2.0
#include "oracle/certificates/check.h"
#include "proptests/catch.h"
#include "proptests/infrastructure/oracle/claims.h"

/// Claims that name a file instead of holding a mesh, and what both checkers say where the file is none.
namespace touchstone::proptests::named_files_tests {
namespace {

namespace fs = std::filesystem;

/// A folder of this process with meshes, gone afterwards.
class Folder {
 public:
  Folder() : path_(fs::temp_directory_path() / (std::to_string(::getpid()) + "_named_files")) {
    fs::create_directories(path_ / "meshes" / "folder.json");
    fs::create_symlink("nowhere", path_ / "meshes" / "dangling.json");
    write("outside.json", tetrahedron);
    write("../" + path_.filename().string() + "_foreign.json", tetrahedron);
    fs::create_symlink("../../" + path_.filename().string() + "_foreign.json", path_ / "meshes" / "leaving.json");
    fs::create_symlink("../outside.json", path_ / "meshes" / "staying.json");
    fs::create_symlink("/dev/zero", path_ / "meshes" / "endless.json");
    write("meshes/tetrahedron.json", tetrahedron);
    write("meshes/lines.json", "\n" + tetrahedron + "\r\n");
    write("meshes/hexadecimal.json", replaced("[4,0,0]", R"(["0x1p2",0,-0.0])"));
    write("meshes/empty.json", "");
    write("meshes/cut.json", tetrahedron.substr(0, 40));
    write("meshes/two.json", tetrahedron + tetrahedron);
    write("meshes/mark.json", "\xef\xbb\xbf" + tetrahedron);
    write("meshes/zero.json", tetrahedron + std::string(1, '\0'));
    write("meshes/bytes.json", "\"\xff\"");
    write("meshes/twice.json", replaced("{", R"({"faces":[],)"));
    write("meshes/deep.json", std::string(65, '[') + std::string(65, ']'));
    write("meshes/text.json", R"("meshes/tetrahedron.json")");
    write("meshes/open.json", replaced(",[1,2,3]", ""));
    write("meshes/index.json", replaced("[1,2,3]", "[1,2,4]"));
    write("meshes/huge.json", replaced("[4,0,0]", "[1e999,0,0]"));
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
    fs::remove(path_.string() + "_foreign.json", ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
  }
  std::string path() const { return path_.string(); }

 private:
  static std::string replaced(const std::string& what, const std::string& by) {
    std::string text = tetrahedron;
    return text.replace(text.find(what), what.size(), by);
  }
  inline static const std::string tetrahedron =
      R"({"vertices":[[0,0,0],[4,0,0],[0,4,0],[0,0,4]],"faces":[[0,2,1],[0,1,3],[0,3,2],[1,2,3]]})";
  fs::path path_;
};

std::string claim_of(const std::string& mesh) {
  return R"({"op":"point_in_convex_polyhedron","input":{"mesh":")" + mesh + R"(","point":[2,2,1]},)" +
         R"("truth":{"location":"outside"},"certificate":{"kind":"separating_face","face":["3"]}})";
}

}  // namespace

TEST_CASE("named files: both checkers read the mesh that a claim names, and refuse what is no such file") {
  const Folder folder;
  const std::string rule = "mesh: a file meshes/NAME.json, NAME of small letters, digits and _";
  const auto unreadable = [](const std::string& name) { return "mesh: " + name + ": a file that can be read"; };
  const auto no_json = [](const std::string& name) { return "mesh: " + name + ": JSON, nested at most 64 deep"; };
  std::vector<std::string> lines, verdicts;
  const auto says = [&](const std::string& line, const std::string& expected) {
    const std::string said = certify::refuse_text(line, folder.path()).value_or("accepted");
    INFO(line);
    CHECK(said == expected);
    lines.push_back(line), verdicts.push_back(said);
  };
  for (const char* good : {"tetrahedron", "lines", "hexadecimal", "staying"})
    says(claim_of("meshes/" + std::string(good) + ".json"), "accepted");
  for (const char* none : {"unknown", "folder", "dangling", "endless"}) {
    const std::string name = "meshes/" + std::string(none) + ".json";
    says(claim_of(name), unreadable(name));
  }
  says(claim_of("meshes/leaving.json"),
       "mesh: meshes/leaving.json: a file in the folder of the claims, no link out of it");
  for (const char* bad : {"empty", "cut", "two", "mark", "zero", "bytes", "twice", "deep"}) {
    const std::string name = "meshes/" + std::string(bad) + ".json";
    says(claim_of(name), no_json(name));
  }
  for (const std::string name :
       {"outside.json", "./meshes/tetrahedron.json", "../meshes/tetrahedron.json", "meshes/../outside.json",
        "meshes/../meshes/tetrahedron.json", "meshes//tetrahedron.json", "meshes/Tetrahedron.json", "meshes/.json",
        "meshes/tetrahedron.json.json", "meshes/a b.json", "meshes/\\u0000.json", ".json", "/etc/tetrahedron.json",
        "meshes.json", "meshes/tetrahedron\\n.json"})
    says(claim_of(name), rule);
  says(claim_of(folder.path() + "/meshes/tetrahedron.json"), rule);
  for (const char* no_name : {"", "meshes", "meshes/tetrahedron", "meshes/tetrahedron.off", "meshes/tetrahedron.json "})
    says(claim_of(no_name), "mesh: an object");
  says(claim_of("meshes/text.json"), "mesh: an object");
  says(claim_of("meshes/open.json"), "mesh: at least 4 faces");
  says(claim_of("meshes/index.json"), "mesh.faces[3][2]: index of a vertex");
  says(claim_of("meshes/huge.json"), no_json("meshes/huge.json"));
  says(R"({"op":"point_in_convex_polyhedron","input":{"mesh":"meshes/tetrahedron.json","point":"meshes/cut.json"},)"
       R"("truth":{},"certificate":{}})",
       "point: meshes/cut.json: JSON, nested at most 64 deep");
  says(R"({"op":"point_in_convex_polyhedron","input":{"a b":"meshes/cut.json","point":[0,0,0]},"truth":{},)"
       R"("certificate":{}})",
       "input: field mesh is missing");
  says(R"({"op":"point_in_convex_polyhedron","input":{"mesh":"meshes/open.json","point":[0,0,0]},)"
       R"("refused":{"field":"mesh","rule":"at least 4 faces"}})",
       "accepted");
  says(R"({"op":"explicit_line","input":{"slope":"meshes/tetrahedron.json","intercept":1,"point":[1,4]},)"
       R"("truth":{"side":"above"},"certificate":{"kind":"height","height":["3"]}})",
       "slope: a number or a hexadecimal float string");
  const auto in_lines = [](const std::vector<std::string>& all) {
    std::string text;
    for (const std::string& line : all) text += line + "\n";
    return text;
  };
  folder.write("claims.jsonl", in_lines(lines)), folder.write("verdicts.txt", in_lines(verdicts));
  CHECK(python_finds_nothing("proptests/infrastructure/oracle/checkers_agree.py '" + folder.path() +
                             "/claims.jsonl' '" + folder.path() + "/verdicts.txt'"));
}

}  // namespace touchstone::proptests::named_files_tests
